// SPDX-License-Identifier: Apache-2.0
// The group `order_status` as a value: the order that the controller counts. Read in one proven exchange.
#pragma once

#include "modbus/map/protocol.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace campanel::modbus {

inline constexpr std::uint16_t orderStatusAddress = 0x0B50;
inline constexpr std::uint16_t orderStatusRegisters = 15 + orderLotRegisters;
inline constexpr std::uint16_t orderLotAddress = 0x0B36;
// The first version of the map with this group and its commands.
inline constexpr std::uint16_t orderMapMinor = 6;
// Good bags of one order.
inline constexpr std::uint32_t maxOrderQuantity = 1'000'000;

struct OrderStatus {
    std::optional<OrderState> state; // empty: not known to this version
    std::uint16_t number = 0;        // 0: no order since first power-up
    std::optional<OrderAction> action;
    bool isKept = false; // it survives a power cut
    std::uint32_t quantity = 0;
    std::uint32_t good = 0;
    std::uint32_t rejected = 0;
    std::uint32_t empty = 0;
    std::uint32_t cut = 0;      // the sum of those above and
    std::uint16_t onTheWay = 0; // those that may still be rejected
    std::string lot;            // UTF-8

    bool operator==(const OrderStatus&) const = default;
};

// Decodes orderStatusRegisters registers from orderStatusAddress on.
[[nodiscard]] OrderStatus decodeOrderStatus(std::span<const std::uint16_t> registers);

// Returns the registers of a lot, for orderLotAddress; none if it has more than 2 x orderLotRegisters bytes.
[[nodiscard]] std::optional<std::vector<std::uint16_t>> encodeOrderLot(std::string_view lot);

} // namespace campanel::modbus
