// SPDX-License-Identifier: Apache-2.0
// The group `jam` as a value: the knife's torque by its angle, and the jams. Read in one proven exchange.
#pragma once

#include "modbus/map/protocol.h"
#include "modbus/map/register_map.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace campanel::modbus {

inline constexpr std::uint16_t jamAddress = 0x0A80;
inline constexpr std::uint16_t jamRegisters = 14 + 2 * jamBins;
// The first version of the map with this group.
inline constexpr std::uint16_t jamMapMinor = 6;

// Angles are of the shaft, from the cut, negative before it; torques in per cent of the rated torque.
struct JamStatus {
    // One of equal parts of the band.
    struct Part {
        double angleDeg = 0.0; // its middle
        double expectedPercent = 0.0;
        double halfWidthPercent = 0.0;

        bool operator==(const Part&) const = default;
    };
    struct Jam {
        JamSource source = JamSource::None;
        double angleDeg = 0.0; // when it was seen
        double torquePercent = 0.0;
        double limitPercent = 0.0; // end of the band there
        double runOnDeg = 0.0;     // from there to standstill

        bool operator==(const Jam&) const = default;
    };

    std::optional<JamState> state;    // empty: not known to this version
    int cyclesLeft = 0;               // at full speed, until it is armed
    std::optional<double> intervalMs; // between two reports of the torque; empty: unknown
    int jams = 0;                     // since power-up
    std::optional<Jam> last;          // empty without one
    std::uint32_t residueNumber = 0;
    std::optional<double> residuePercent; // the newest; empty before the first
    double fromDeg = 0.0;                 // of the band
    double toDeg = 0.0;
    std::vector<Part> band; // those that are learned

    bool operator==(const JamStatus&) const = default;
};

// Decodes jamRegisters registers from jamAddress on.
[[nodiscard]] JamStatus decodeJam(std::span<const std::uint16_t> registers);

} // namespace campanel::modbus
