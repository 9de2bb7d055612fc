// SPDX-License-Identifier: Apache-2.0
// The way a motor turns with the pulses of the command: as it was wired and mounted, and as the controller
// has it reversed. Positions in pulses; that of the command has no step when the direction changes.
#pragma once

namespace campanel::controller {

class MotorWay {
public:
    // `position`: where the motor is.
    void setReversed(bool isReversed, double position)
    {
        const double sign = isReversed ? -1.0 : 1.0;
        m_offset += (m_sign - sign) * position;
        m_sign = sign;
    }
    [[nodiscard]] bool isReversed() const { return m_sign < 0.0; }
    // Returns the position of the command at this position of the motor.
    [[nodiscard]] double commanded(double position) const { return m_sign * position + m_offset; }

private:
    double m_sign = 1.0;
    double m_offset = 0.0;
};

} // namespace campanel::controller
