// SPDX-License-Identifier: Apache-2.0
// The group `io` as a value: the pins of the machine, the infeed, the torque. Read in one proven exchange.
#pragma once

#include "modbus/map/protocol.h"

#include <cstdint>
#include <optional>
#include <span>

namespace campanel::modbus {

inline constexpr std::uint16_t ioAddress = 0x01B0;
// The first minor version of the map with this group and the parameters of the cam switches.
inline constexpr std::uint16_t ioMapMinor = 3;

// Returns the size of the group in a controller of this version.
[[nodiscard]] std::uint16_t ioRegisters(std::uint16_t minor = mapMinor);

// Values that the machine does not have are empty.
struct IoStatus {
    std::optional<std::uint16_t> inputs;  // bits of InputBit
    std::optional<std::uint32_t> outputs; // bits of OutputBit
    bool hasAllOutputs = false;           // those from Ready on, too
    std::optional<double> torquePercent;  // of the rated torque
    std::optional<double> torqueAngleDeg; // of the master, when it was reported
    std::optional<double> infeedPositionMm;
    std::optional<double> infeedFollowingErrorMm;
    // The positions that survive a power cut.
    bool isAxisKept = false;
    bool isFilmKept = false;
    bool isInfeedKept = false;
    bool canReverse = false; // motors can be turned the other way

    // Return the level of a pin; empty when the machine has no such pins.
    [[nodiscard]] std::optional<bool> level(InputBit bit) const;
    [[nodiscard]] std::optional<bool> level(OutputBit bit) const;

    bool operator==(const IoStatus&) const = default;
};

// Decodes the registers of the group, as many as the controller has.
[[nodiscard]] IoStatus decodeIo(std::span<const std::uint16_t> registers);

} // namespace campanel::modbus
