// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/mark_edges.h"

#include <algorithm>
#include <cstdlib>

namespace campanel::modbus {

namespace {

constexpr std::size_t registersPerEdge = 8;
constexpr double mmPerStep = 0.01;
constexpr int saturated = 32767;
constexpr double mPerSStep = 0.0001;
constexpr double mPerMm = 0.001;
constexpr double msPerUs = 0.001;

std::optional<double> distanceMm(std::uint16_t value)
{
    const int steps = static_cast<std::int16_t>(value);
    return std::abs(steps) < saturated ? std::optional(steps * mmPerStep) : std::nullopt;
}

double signedNumber(std::uint16_t value)
{
    return static_cast<std::int16_t>(value);
}

std::uint32_t wide(std::span<const std::uint16_t> at)
{
    return static_cast<std::uint32_t>(at[0]) << 16u | at[1];
}

} // namespace

std::vector<MarkEdge> markEdges(std::span<const std::uint16_t> registers, std::uint32_t after)
{
    std::vector<MarkEdge> edges;
    if (registers.size() < sensorRegisters)
        return edges;
    const std::uint32_t newest = wide(registers);
    const std::uint32_t fresh = newest < after ? newest : newest - after; // fewer than before: restarted
    for (std::uint32_t back = std::min<std::uint32_t>(fresh, edgeRecords); back != 0; --back) {
        const std::uint32_t number = newest - (back - 1);
        const auto record =
            registers.subspan(2 + registersPerEdge * (number % edgeRecords), registersPerEdge);
        edges.push_back({number, wide(record), distanceMm(record[2]), signedNumber(record[3]) * mPerSStep,
                         signedNumber(record[4]) * mPerMm, static_cast<MarkVerdict>(record[5]),
                         record[6] * msPerUs,
                         record[7] != 0 ? std::optional(record[7] * mmPerStep) : std::nullopt});
    }
    return edges;
}

} // namespace campanel::modbus
