// SPDX-License-Identifier: Apache-2.0
// A press on a bench: the core with its machine, called at irregular intervals, with or without Modbus
// traffic; every pulse is checked.
#pragma once

#include "ctl_core.h"
#include "machine.h"
#include "motion/ctl_start.h"
#include "rig.h"
#include "support/press_image.h"

#include <memory>
#include <random>

namespace campanel::test {

struct Disturbance {
    std::uint64_t seed = 1;
    std::uint32_t longestTickUs = 250; // the controller is called after 50 us up to this
    bool traffic = false;              // continuous requests for status blocks
};

class PressBench {
public:
    PressBench(const PressImage& image, const controller::MachineOptions& options,
               const Disturbance& disturbance = {});
    PressBench(const PressBench&) = delete;
    PressBench& operator=(const PressBench&) = delete;
    ~PressBench() = default;

    // Runs until the state is no longer Running or Stopping, or for a minute.
    void runToStandstill();
    // Calls the controller once and moves the machine.
    void tick();
    // Starts and runs to standstill; returns false when Start was refused.
    bool stroke();

    [[nodiscard]] const ctl_stroke& last() const { return m_core->motion.press.last; }
    [[nodiscard]] ctl_core& core() { return *m_core; }
    [[nodiscard]] controller::Machine& machine() { return m_machine; }
    [[nodiscard]] std::uint64_t nowUs() const { return m_nowUs; }

    // The figures of the last stroke: the ram's true position at the end of the hold, and the number of
    // upward pulses before the return.
    double heldMm = 0.0;
    int backwards = 0;
    std::uint32_t answers = 0; // total answers to the traffic

private:
    void onPulses(std::int32_t count);

    controller::Machine m_machine;
    std::unique_ptr<ctl_core> m_core;
    Disturbance m_disturbance;
    std::mt19937_64 m_random;
    std::uint64_t m_nowUs = 0;
};

} // namespace campanel::test
