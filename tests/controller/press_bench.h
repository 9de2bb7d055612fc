// SPDX-License-Identifier: Apache-2.0
// A press on a bench: the core with its machine, called as late and as irregularly as a test likes, with or
// without Modbus traffic; it looks at every pulse.
#pragma once

#include "ctl_core.h"
#include "machine.h"
#include "rig.h"
#include "support/press_image.h"

#include <memory>
#include <random>

namespace campanel::test {

struct Disturbance {
    std::uint64_t seed = 1;
    std::uint32_t longestTickUs = 250; // the controller is called after 50 us up to this
    bool traffic = false;              // status blocks asked for back to back
};

class PressBench {
public:
    PressBench(const PressImage& image, const controller::MachineOptions& options,
               const Disturbance& disturbance = {});
    PressBench(const PressBench&) = delete;
    PressBench& operator=(const PressBench&) = delete;
    ~PressBench() = default;

    // Until the state is no longer Running or Stopping, or a minute has passed.
    void runToStandstill();
    // One call of the controller, the machine moving meanwhile.
    void tick();
    // Start, then as above; false when Start was refused.
    bool stroke();

    [[nodiscard]] const ctl_stroke& last() const { return m_core->motion.press.last; }
    [[nodiscard]] ctl_core& core() { return *m_core; }
    [[nodiscard]] controller::Machine& machine() { return m_machine; }
    [[nodiscard]] std::uint64_t nowUs() const { return m_nowUs; }

    // Of the last stroke: where the ram truly stood at the end of the hold, and how often a pulse came
    // upwards before the return.
    double heldMm = 0.0;
    int backwards = 0;
    std::uint32_t answers = 0; // to the traffic, in all

private:
    void onPulses(std::int32_t count);

    controller::Machine m_machine;
    std::unique_ptr<ctl_core> m_core;
    Disturbance m_disturbance;
    std::mt19937_64 m_random;
    std::uint64_t m_nowUs = 0;
};

} // namespace campanel::test
