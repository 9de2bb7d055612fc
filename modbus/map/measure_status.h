// SPDX-License-Identifier: Apache-2.0
// The group `measure` as a value: what a measurement of an axis has counted. Read in one proven exchange.
#pragma once

#include "modbus/map/protocol.h"
#include "modbus/map/register_map.h"

#include <cstdint>
#include <optional>
#include <span>

namespace campanel::modbus {

inline constexpr std::uint16_t measureAddress = 0x08E8;
inline constexpr std::uint16_t measureRegisters = 12;
// The first version of the map with this group and Command::Measure.
inline constexpr std::uint16_t measureMapMinor = 7;
// The index marks that a measurement counts.
inline constexpr std::uint16_t measuredTurns = 5;
// The share of a turn by which the longest and the shortest one may differ.
inline constexpr double maxTurnSpread = 0.005;
// The share by which a bag may be off its set length; one that is farther off is another bag.
inline constexpr double maxBagDeviation = 0.2;

struct MeasureStatus {
    MeasureState state = MeasureState::None;
    MeasuredAxis axis = MeasuredAxis::Knife;
    int turns = 0;
    Refusal reason = Refusal::None;    // why it ended before
    double pulses = 0.0;               // per turn, mean
    double spread = 0.0;               // of the turns
    std::optional<double> bagPulses{}; // of the film motor between the last two cuts; empty: not known
    std::uint32_t bag = 0;             // number of the bag that ended with them

    [[nodiscard]] bool areTurnsEven() const { return spread <= maxTurnSpread * pulses; }

    bool operator==(const MeasureStatus&) const = default;
};

// Decodes measureRegisters registers from measureAddress on.
[[nodiscard]] MeasureStatus decodeMeasure(std::span<const std::uint16_t> registers);

} // namespace campanel::modbus
