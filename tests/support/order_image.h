// SPDX-License-Identifier: Apache-2.0
// The group `order_status` as registers.
#pragma once

#include "modbus/map/order_status.h"
#include "modbus/map/register_map.h"

#include <algorithm>
#include <vector>

namespace campanel::test {

// The status must have a state and an action.
[[nodiscard]] inline std::vector<std::uint16_t> orderRegisters(const modbus::OrderStatus& status)
{
    std::vector<std::uint16_t> registers(modbus::orderStatusRegisters, 0);
    const auto put = [&registers](const char* name, std::uint32_t value) {
        const modbus::RegisterInfo& info = *modbus::findRegister(name);
        std::uint16_t* at = &registers[info.address - modbus::orderStatusAddress];
        if (info.count == 2)
            *at++ = static_cast<std::uint16_t>(value >> 16U);
        *at = static_cast<std::uint16_t>(value);
    };
    put("order_status.state", static_cast<std::uint32_t>(*status.state));
    put("order_status.number", status.number);
    put("order_status.action", static_cast<std::uint32_t>(*status.action));
    put("order_status.quantity", status.quantity);
    put("order_status.good", status.good);
    put("order_status.rejected", status.rejected);
    put("order_status.empty", status.empty);
    put("order_status.cut", status.cut);
    put("order_status.on_the_way", status.onTheWay);
    const auto lot = *modbus::encodeOrderLot(status.lot);
    std::ranges::copy(lot, registers.end() - modbus::orderLotRegisters);
    return registers;
}

} // namespace campanel::test
