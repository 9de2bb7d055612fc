// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/order_status.h"

#include "modbus/map/codec.h"

#include <cassert>

namespace campanel::modbus {

OrderStatus decodeOrderStatus(std::span<const std::uint16_t> registers)
{
    assert(registers.size() == orderStatusRegisters);
    const RegisterReader reader(registers, orderStatusAddress);
    OrderStatus status;
    const auto state = reader.u16("order_status.state");
    if (state <= static_cast<std::uint16_t>(OrderState::Ended))
        status.state = static_cast<OrderState>(state);
    status.number = reader.u16("order_status.number");
    const auto action = reader.u16("order_status.action");
    if (action <= static_cast<std::uint16_t>(OrderAction::Stop))
        status.action = static_cast<OrderAction>(action);
    status.isKept = reader.u16("order_status.kept") != 0;
    status.quantity = reader.u32("order_status.quantity");
    status.good = reader.u32("order_status.good");
    status.rejected = reader.u32("order_status.rejected");
    status.empty = reader.u32("order_status.empty");
    status.cut = reader.u32("order_status.cut");
    status.onTheWay = reader.u16("order_status.on_the_way");
    const std::span<const std::uint16_t> lot = registers.last(orderLotRegisters);
    for (const std::uint16_t value : lot) {
        for (const unsigned byte : {value / 0x100u, value % 0x100u}) {
            if (byte == 0)
                return status;
            status.lot.push_back(static_cast<char>(byte));
        }
    }
    return status;
}

std::optional<std::vector<std::uint16_t>> encodeOrderLot(std::string_view lot)
{
    std::vector<std::uint16_t> registers(orderLotRegisters, 0);
    if (lot.size() > 2 * registers.size())
        return std::nullopt;
    for (std::size_t i = 0; i < lot.size(); ++i) {
        const unsigned byte = static_cast<unsigned char>(lot[i]);
        registers[i / 2] = static_cast<std::uint16_t>(registers[i / 2] | (i % 2 == 0 ? byte << 8u : byte));
    }
    return registers;
}

} // namespace campanel::modbus
