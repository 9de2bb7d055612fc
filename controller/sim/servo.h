// SPDX-License-Identifier: Apache-2.0
// A servo axis: critically damped, second order. The command rises linearly within a step, and the solution
// for that is exact, so the result does not depend on the step length. In pulses.
#pragma once

#include <cstdint>
#include <limits>

namespace campanel::controller {

class Servo {
public:
    // Follows with a lag of 1 / (pi * bandwidthHz) at constant speed.
    explicit Servo(double bandwidthHz);

    void command(std::int64_t pulses) { m_commanded += pulses; }
    // Switches the drive. While it is off the axis does not follow; pulses in the meantime are lost.
    void setDriveOn(bool on);
    // Something accelerates the axis from outside, and the drive accelerates it by at most `limit`, per
    // second squared.
    void setLoad(double acceleration, double limit);
    // Stands at once, so far from where it was.
    void turnByHand(double pulses);
    void advance(double stepS);

    [[nodiscard]] double position() const { return m_position; }
    // Returns the speed at the end of the last step, per second.
    [[nodiscard]] double speed() const { return m_speed; }
    // Returns the acceleration that the drive gives then.
    [[nodiscard]] double acceleration() const;
    // Returns the position before the last step.
    [[nodiscard]] double positionBefore() const { return m_before; }

private:
    double m_angularBandwidth = 0.0; // 1/s
    double m_lagS = 0.0;             // at constant speed
    double m_load = 0.0;             // 1/s^2
    double m_limit = std::numeric_limits<double>::infinity();
    bool m_driveOn = true;
    std::int64_t m_commanded = 0;
    double m_target = 0.0; // the command at the end of the last step
    double m_position = 0.0;
    double m_speed = 0.0; // 1/s
    double m_before = 0.0;
    double m_stepS = 0.0; // step that the next two were computed for
    double m_stepsPerS = 0.0;
    double m_decay = 1.0;
};

} // namespace campanel::controller
