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
    return status;
}

} // namespace campanel::modbus
