// SPDX-License-Identifier: Apache-2.0
// The controller's core connected to the simulated machine, on simulated time in fixed steps: the caller sets
// the pace, and the results do not depend on it.
#pragma once

#include "ctl_core.h"
#include "flash_device.h"
#include "machine.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace campanel::controller {

class SimulatedController {
public:
    static constexpr std::uint64_t usualStepUs = CTL_SLICE_US;

    // The flash must outlive the controller. Longer steps are faster; the bags differ by at most a pulse of
    // the film motor.
    SimulatedController(const ctl_config& config, const MachineOptions& options, FlashDevice& flash,
                        std::uint64_t stepUs = usualStepUs);
    SimulatedController(const SimulatedController&) = delete;
    SimulatedController& operator=(const SimulatedController&) = delete;
    ~SimulatedController() = default;

    // Returns the simulated time since power-up.
    [[nodiscard]] std::uint64_t nowUs() const { return m_nowUs; }
    [[nodiscard]] std::uint64_t stepUs() const { return m_stepUs; }
    void step();
    // Switches it off and on again; its memory but the flash is lost.
    void restart();
    // Runs whole steps up to this time, then checks the line's silence at exactly that time.
    void runTo(std::uint64_t timeUs);

    [[nodiscard]] ctl_core& core() { return *m_core; }
    [[nodiscard]] Machine& machine() { return m_machine; }
    // Returns the cut of the last step.
    [[nodiscard]] const std::optional<BagCut>& cut() const { return m_cut; }

    // Returns the cut that a person made in the last step by jogging the knife. The controller is not told.
    [[nodiscard]] const std::optional<BagCut>& cutByHand() const { return m_cutByHand; }

    // Called with the pulses that the main drive is given, if set.
    std::function<void(const ctl_train&)> onPulses;
    // Called behind each step, if set.
    std::function<void()> onStep;

private:
    void takeOverProgram();
    void passCut();

    std::uint64_t m_stepUs;
    ctl_config m_config{};
    ctl_port m_port{};
    Machine m_machine;
    std::unique_ptr<ctl_core> m_core; // too large for a stack
    FlashDevice& m_flash;
    std::uint64_t m_nowUs = 0;
    std::uint32_t m_generation = 0;
    std::optional<BagCut> m_cut;
    std::optional<BagCut> m_cutByHand;
};

} // namespace campanel::controller
