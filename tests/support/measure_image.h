// SPDX-License-Identifier: Apache-2.0
// The group `measure` as registers.
#pragma once

#include "modbus/map/measure_status.h"

#include <cmath>
#include <vector>

namespace campanel::test {

[[nodiscard]] inline std::vector<std::uint16_t> measureRegisters(const modbus::MeasureStatus& status)
{
    std::vector<std::uint16_t> registers(modbus::measureRegisters, 0);
    const auto put = [&registers](const char* name, double value) {
        const modbus::RegisterInfo& info = *modbus::findRegister(name);
        const auto raw = static_cast<std::uint32_t>(std::llround(value / info.scale));
        std::uint16_t* at = &registers[info.address - modbus::measureAddress];
        if (info.count == 2)
            *at++ = static_cast<std::uint16_t>(raw >> 16U);
        *at = static_cast<std::uint16_t>(raw);
    };
    put("measure.state", static_cast<double>(status.state));
    put("measure.axis", static_cast<double>(status.axis));
    put("measure.turns", status.turns);
    put("measure.reason", static_cast<double>(status.reason));
    put("measure.pulses", status.pulses);
    put("measure.spread", status.spread);
    put("measure.bag_pulses", status.bagPulses.value_or(0.0));
    put("measure.bag", status.bag);
    return registers;
}

} // namespace campanel::test
