// SPDX-License-Identifier: Apache-2.0
// The position of the axis since homing beyond the 32 bits of its registers: as sent and by the encoder.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/wide_counter.h"

namespace campanel::panel {

class AxisPosition {
public:
    // Takes the next status. Homing and a restart of the controller begin at the registers' values.
    void note(const modbus::StatusBlock& status)
    {
        if (status.uptimeS < m_uptimeS || status.state == modbus::State::Homing)
            reset();
        m_uptimeS = status.uptimeS;
        m_commanded.note(status.commandedPositionPulses);
        m_actual.note(status.axisPositionPulses);
    }
    void reset()
    {
        m_commanded.reset();
        m_actual.reset();
    }

    // Return nothing before the first status.
    [[nodiscard]] std::optional<std::int64_t> commandedPulses() const { return m_commanded.value(); }
    [[nodiscard]] std::optional<std::int64_t> actualPulses() const { return m_actual.value(); }

private:
    std::uint32_t m_uptimeS = 0;
    WideCounter m_commanded;
    WideCounter m_actual;
};

} // namespace campanel::panel
