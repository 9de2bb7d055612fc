// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/mark_edges.h"

#include <algorithm>
#include <cstdlib>

namespace campanel::modbus {

namespace {

constexpr std::size_t registersPerEdge = 8;
constexpr std::size_t registersPerEyeEdge = 4;
constexpr double perSStep = 0.001;
constexpr double mmPerHundredth = 0.01;
constexpr int saturated = 32767;
constexpr double mPerSStep = 0.0001;
constexpr double mPerMm = 0.001;
constexpr double msPerUs = 0.001;

std::optional<double> offMmOf(std::uint16_t value)
{
    const int steps = static_cast<std::int16_t>(value);
    return std::abs(steps) < saturated ? std::optional(steps * mmPerHundredth) : std::nullopt;
}

double signedNumber(std::uint16_t value)
{
    return static_cast<std::int16_t>(value);
}

std::uint32_t wide(std::span<const std::uint16_t> at)
{
    return static_cast<std::uint32_t>(at[0]) << 16u | at[1];
}

// Calls `add` with the number and the registers of each record behind number `after`, oldest first.
template <class Add>
void readRecords(std::span<const std::uint16_t> registers, std::size_t size, std::uint32_t kept,
                 std::uint32_t after, Add add)
{
    if (registers.size() < 2 + size * kept)
        return;
    const std::uint32_t newest = wide(registers);
    const std::uint32_t fresh = newest < after ? newest : newest - after; // fewer than before: restarted
    for (std::uint32_t back = std::min(fresh, kept); back != 0; --back) {
        const std::uint32_t number = newest - (back - 1);
        add(number, registers.subspan(2 + size * (number % kept), size));
    }
}

} // namespace

std::vector<MarkEdge> markEdges(std::span<const std::uint16_t> registers, std::uint32_t after)
{
    std::vector<MarkEdge> edges;
    const auto add = [&edges](std::uint32_t number, std::span<const std::uint16_t> record) {
        edges.push_back({number, wide(record), offMmOf(record[2]), signedNumber(record[3]) * mPerSStep,
                         signedNumber(record[4]) * mPerMm, static_cast<MarkVerdict>(record[5]),
                         record[6] * msPerUs,
                         record[7] != 0 ? std::optional(record[7] * mmPerHundredth) : std::nullopt});
    };
    readRecords(registers, registersPerEdge, edgeRecords, after, add);
    return edges;
}

std::vector<EyeEdge> eyeEdges(std::span<const std::uint16_t> registers, std::uint32_t after)
{
    std::vector<EyeEdge> edges;
    const auto add = [&edges](std::uint32_t number, std::span<const std::uint16_t> record) {
        edges.push_back({number, record[0], record[1] * perSStep, record[2] != 0, record[3] * msPerUs});
    };
    readRecords(registers, registersPerEyeEdge, eyeRecords, after, add);
    return edges;
}

} // namespace campanel::modbus
