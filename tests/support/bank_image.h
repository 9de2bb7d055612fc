// SPDX-License-Identifier: Apache-2.0
// Program banks for tests, built without the profile layer: any rows, with sums and header filled in.
#pragma once

#include "ctl_registers.h"

#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace campanel::test {

struct BankRow {
    std::uint16_t pulses = 0;
    std::uint32_t ticks = 0;
};

struct BankImage {
    std::vector<BankRow> rows;
    std::uint32_t remainder = 0;
    std::uint32_t divisor = 1;
    std::uint16_t carryRow = 0;
    std::uint16_t cutAngle = 18000; // 0.01 degrees
    std::uint16_t syncStart = 14400;
    std::uint16_t syncEnd = 21600;
    std::uint16_t knives = 1;
    std::uint32_t pulsesPerMotorRev = 10000;
    std::uint32_t knifeRadiusUm = 60000;
    std::uint32_t bagLengthUm = 250000;

    [[nodiscard]] std::uint32_t cyclePulses() const
    {
        return std::accumulate(rows.begin(), rows.end(), 0u,
                               [](std::uint32_t sum, const BankRow& row) { return sum + row.pulses; });
    }
    [[nodiscard]] std::uint32_t cycleTicks() const
    {
        return std::accumulate(rows.begin(), rows.end(), 0u,
                               [](std::uint32_t sum, const BankRow& row) { return sum + row.ticks; });
    }
    // Returns header and rows as sent over the line.
    [[nodiscard]] std::vector<std::uint16_t> registers() const
    {
        std::vector<std::uint16_t> result(CTL_BANK_HEADER_REGISTERS, 0);
        const auto wide = [&result](unsigned offset, std::uint32_t value) {
            result.at(offset) = static_cast<std::uint16_t>(value >> 16);
            result.at(offset + 1) = static_cast<std::uint16_t>(value & 0xFFFFu);
        };
        result[CTL_OFFSET_BANK_LAYOUT] = CTL_TABLE_LAYOUT_STEP_TABLE;
        result[CTL_OFFSET_BANK_KIND] = CTL_PROGRAM_KIND_ROTARY_CUTTER;
        result[CTL_OFFSET_BANK_ROW_COUNT] = static_cast<std::uint16_t>(rows.size());
        wide(CTL_OFFSET_BANK_CYCLE_TICKS, cycleTicks());
        wide(CTL_OFFSET_BANK_CYCLE_PULSES, cyclePulses());
        wide(CTL_OFFSET_BANK_REMAINDER, remainder);
        wide(CTL_OFFSET_BANK_DIVISOR, divisor);
        result[CTL_OFFSET_BANK_CARRY_ROW] = carryRow;
        result[CTL_OFFSET_BANK_CUT_ANGLE] = cutAngle;
        result[CTL_OFFSET_BANK_SYNC_START] = syncStart;
        result[CTL_OFFSET_BANK_SYNC_END] = syncEnd;
        wide(CTL_OFFSET_PROGRAM_KNIFE_RADIUS, knifeRadiusUm);
        result[CTL_OFFSET_PROGRAM_KNIVES] = knives;
        wide(CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV, pulsesPerMotorRev);
        result[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR] = 1;
        result[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR] = 1;
        wide(CTL_OFFSET_PROGRAM_BAG_LENGTH, bagLengthUm);
        for (const BankRow& row : rows) {
            result.push_back(row.pulses);
            result.push_back(static_cast<std::uint16_t>(row.ticks >> 16));
            result.push_back(static_cast<std::uint16_t>(row.ticks & 0xFFFFu));
        }
        return result;
    }
};

// Returns a cam-like table: `rowCount` (even) rows of equal time, symmetrical, slow at the ends and fast in
// the middle; K / N pulses a cycle with the carry in the middle.
inline BankImage camBank(std::uint32_t pulsesPerRev, std::uint16_t knives, std::uint32_t cycleTicks,
                         std::uint32_t rowCount = 40)
{
    BankImage bank;
    bank.pulsesPerMotorRev = pulsesPerRev;
    bank.knives = knives;
    bank.remainder = pulsesPerRev % knives;
    bank.divisor = bank.remainder == 0 ? 1u : knives;
    bank.carryRow = static_cast<std::uint16_t>(rowCount / 2);
    const std::uint64_t pulses = pulsesPerRev / knives;
    const std::uint64_t half = rowCount / 2;
    // The weight of row i is 1 + i up to the middle and back; cut points at rounded sums keep the total
    // exact.
    const std::uint64_t total = half * (half + 1);
    std::uint64_t weight = 0;
    for (std::uint64_t i = 0; i < rowCount; ++i) {
        const std::uint64_t before = weight;
        weight += i < half ? i + 1 : rowCount - i;
        bank.rows.push_back(
            {static_cast<std::uint16_t>(pulses * weight / total - pulses * before / total),
             static_cast<std::uint32_t>(cycleTicks * (i + 1) / rowCount - cycleTicks * i / rowCount)});
    }
    return bank;
}

// Returns random rows within an 8 MHz, 16-bit timer and 200 kHz, with pauses and a random carry.
inline BankImage randomBank(std::mt19937_64& random)
{
    const auto pick = [&random](std::uint32_t low, std::uint32_t high) {
        return std::uniform_int_distribution<std::uint32_t>(low, high)(random);
    };
    BankImage bank;
    const std::uint32_t rowCount = pick(1, 30);
    for (std::uint32_t i = 0; i < rowCount; ++i) {
        const std::uint32_t pulses = pick(0, 9) == 0 ? 0 : pick(1, pick(0, 3) == 0 ? 3000 : 50);
        const std::uint32_t most = pick(0, 1) == 0 ? 65535 : 200;
        const std::uint32_t ticks = pulses == 0
                                        ? pick(1, 300000)
                                        : pick(41 * (pulses + 1), std::max(41 * (pulses + 1), pulses * most));
        bank.rows.push_back(
            {static_cast<std::uint16_t>(pulses), std::min(ticks, pulses == 0 ? ticks : pulses * 65535)});
    }
    bank.rows.push_back({20, 20 * 1000});
    bank.carryRow = static_cast<std::uint16_t>(rowCount);
    bank.divisor = pick(1, 100);
    bank.remainder = pick(0, bank.divisor - 1);
    bank.knives = static_cast<std::uint16_t>(bank.divisor);
    bank.pulsesPerMotorRev = bank.cyclePulses() * bank.divisor + bank.remainder;
    return bank;
}

} // namespace campanel::test
