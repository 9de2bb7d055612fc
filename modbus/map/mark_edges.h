// SPDX-License-Identifier: Apache-2.0
// The groups `sensor` and `eye` as values: what mark sensor and product eye of a packing machine saw.
#pragma once

#include "modbus/map/protocol.h"
#include "modbus/map/register_map.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace campanel::modbus {

inline constexpr std::uint16_t sensorAddress = 0x0A00;
inline constexpr std::uint16_t sensorRegisters = 2 + 8 * edgeRecords;
inline constexpr std::uint16_t eyeAddress = 0x0A64;
inline constexpr std::uint16_t eyeRegisters = 2 + 4 * eyeRecords;
// The first version of the map with these groups.
inline constexpr std::uint16_t sensorMapMinor = 6;

struct MarkEdge {
    std::uint32_t number = 0; // counted since power-up
    std::uint32_t filmUm = 0; // position of the film motor, lower 32 bits
    // From the nearest expected mark; empty beyond 327.66 mm.
    std::optional<double> offMm{};
    double speedMPerS = 0.0; // of the film
    double accelerationMPerS2 = 0.0;
    MarkVerdict verdict = MarkVerdict::NotUsed;
    double deadMs = 0.0;             // taken off
    std::optional<double> widthMm{}; // of the print, where its end is known
};

// Returns the edges behind number `after`, oldest first, as far as the controller still has them.
[[nodiscard]] std::vector<MarkEdge> markEdges(std::span<const std::uint16_t> registers, std::uint32_t after);

struct EyeEdge {
    std::uint32_t number = 0; // counted since power-up
    std::uint16_t place = 0;  // of the infeed in the product pitch, 1/65536
    double speed = 0.0;       // of the infeed, pitches per second
    bool begins = false;      // a product begins, otherwise it ends
    double deadMs = 0.0;      // taken off
};

[[nodiscard]] std::vector<EyeEdge> eyeEdges(std::span<const std::uint16_t> registers, std::uint32_t after);

} // namespace campanel::modbus
