// SPDX-License-Identifier: Apache-2.0
// The simulated machine: a servo that follows the pulses with a lag. With a cutter's program it turns a
// knife with encoder and index mark over a film that is fed in proportion to the master and measured where it
// is cut; with a press's it drives the ram. Same seed and same calls: same results.
#pragma once

#include "ctl_bank.h"
#include "press_ram.h"

#include <cstdint>
#include <optional>
#include <random>

namespace campanel::controller {

struct MachineOptions {
    std::uint64_t seed = 1;
    double filmSlipMm = 0.03;         // standard deviation of the film's slip from bag to bag
    double servoBandwidthHz = 80.0;   // critically damped; the knife lags by 1 / (pi * bandwidth)
    double startAngleDegrees = 300.0; // of the knife at power-up, from its index mark
    PressOptions press;
};

class Machine {
public:
    explicit Machine(const MachineOptions& options);

    // The program that is executed from now on; the knife keeps its angle.
    void setProgram(const ctl_bank& bank);
    void command(std::int64_t pulses) { m_commanded += pulses; }
    // A drive that is cut off does not follow any more; switched on again it has forgotten the pulses in
    // between.
    void setDriveOn(bool on);

    // Moves on by one step of time, while which `filmMm` of film is fed.
    void advance(double stepS, double filmMm);
    // What is known of the last cut no longer counts: the film did not follow the knife.
    void forgetLastCut() { m_filmAtCutMm.reset(); }

    // Of the motor; with a press's program the scale at the ram, the second in 1/256 pulse.
    [[nodiscard]] std::int64_t encoder() const;
    [[nodiscard]] std::int64_t scale() const;
    [[nodiscard]] std::int32_t forceN() const { return m_ram ? m_ram->forceN() : 0; }
    // Only with a press's program.
    [[nodiscard]] const PressRam& ram() const { return *m_ram; }
    // Encoder position at the index mark, once for each time that it was passed forward.
    [[nodiscard]] std::optional<std::int64_t> takeIndex();
    // Length of the bag that was cut in the last step, micrometres.
    [[nodiscard]] std::optional<std::uint32_t> takeCutUm();

private:
    void setKnife(const ctl_bank& bank);
    void setPress(const ctl_bank& bank);
    void followCommand(double stepS);
    void passIndex(double before);
    void passCut(double before, double filmMm);

    MachineOptions m_options;
    std::mt19937_64 m_random;
    std::normal_distribution<double> m_slipMm;
    double m_angularBandwidth = 0.0; // 1/s
    bool m_driveOn = true;
    std::int64_t m_commanded = 0;  // pulses
    double m_position = 0.0;       // pulses
    double m_speed = 0.0;          // pulses/s
    double m_revolution = 10000.0; // pulses of one knife revolution
    double m_mark = 0.0;           // position of an index mark, pulses
    double m_stroke = 10000.0;     // pulses from one knife to the next
    double m_cutOffset = 0.0;      // pulses from an index mark to the cut
    bool m_hasKnife = false;
    double m_filmMm = 0.0; // fed since power-up
    std::optional<double> m_filmAtCutMm;
    std::optional<std::int64_t> m_index;
    std::optional<std::uint32_t> m_cutUm;
    std::optional<PressRam> m_ram;
    double m_pulseMm = 0.0; // of the ram
    double m_top = 0.0;     // motor position of the ram's upper position, pulses
};

} // namespace campanel::controller
