// SPDX-License-Identifier: Apache-2.0
// A servo axis: critically damped, second order; the command is taken to rise evenly within a step, for which
// the solution is exact. So the axis does the same whatever the length of the steps. In pulses.
#pragma once

#include <cstdint>

namespace campanel::controller {

class Servo {
public:
    // Follows with a lag of 1 / (pi * bandwidthHz) at even speed.
    explicit Servo(double bandwidthHz);

    void command(std::int64_t pulses) { m_commanded += pulses; }
    // A drive that is cut off does not follow any more; switched on again it has forgotten the pulses in
    // between.
    void setDriveOn(bool on);
    void advance(double stepS);

    [[nodiscard]] double position() const { return m_position; }
    // Before the last step.
    [[nodiscard]] double positionBefore() const { return m_before; }

private:
    double m_angularBandwidth = 0.0; // 1/s
    bool m_driveOn = true;
    std::int64_t m_commanded = 0;
    double m_target = 0.0; // the command at the end of the last step
    double m_position = 0.0;
    double m_speed = 0.0; // 1/s
    double m_before = 0.0;
    double m_stepS = 0.0; // for which m_decay was computed
    double m_decay = 1.0;
};

} // namespace campanel::controller
