// SPDX-License-Identifier: Apache-2.0
// Banks of intervals for tests, built without the profile layer: rows from distances and speeds, corrected
// for the generator's clock, with eight fraction bits.
#pragma once

#include "ctl_registers.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace campanel::test {

struct Interval {
    std::uint32_t pulses = 0;
    double firstHz = 0; // above zero
    double lastHz = 0;

    [[nodiscard]] double timeS() const { return 2.0 * pulses / (firstHz + lastHz); }
};

// Returns the pulses of uniformly accelerated rows after this many seconds.
inline double pulsesAfter(const std::vector<Interval>& rows, double timeS)
{
    double pulses = 0;
    for (const Interval& row : rows) {
        const double rowS = row.timeS();
        if (timeS < rowS)
            return pulses + row.firstHz * timeS + (row.lastHz - row.firstHz) * timeS * timeS / (2.0 * rowS);
        pulses += row.pulses;
        timeS -= rowS;
    }
    return pulses;
}

struct IntervalImage {
    std::uint16_t kind = CTL_PROGRAM_KIND_POSITION_MOVE;
    std::uint16_t atEnd = CTL_END_BEHAVIOR_STOP;
    std::vector<Interval> rows;
    bool backwards = false;
    std::uint32_t remainder = 0;
    std::uint32_t divisor = 1;
    std::uint32_t pulsesPerMotorRev = 10000;
    std::uint32_t feedUm = 100'000;

    [[nodiscard]] double timeS() const
    {
        double sum = 0;
        for (const Interval& row : rows)
            sum += row.timeS();
        return sum;
    }
    // Returns the advance without the fraction.
    [[nodiscard]] std::int64_t advance() const
    {
        std::int64_t sum = 0;
        for (const Interval& row : rows)
            sum += row.pulses;
        return backwards ? -sum : sum;
    }
    [[nodiscard]] std::uint32_t speedUmPerS(double pulseHz) const
    {
        return static_cast<std::uint32_t>(
            std::lround((backwards ? -pulseHz : pulseHz) * feedUm / pulsesPerMotorRev));
    }
    // Returns header and rows as sent over the line.
    [[nodiscard]] std::vector<std::uint16_t> registers() const
    {
        constexpr unsigned fractionBits = 8;
        std::vector<std::uint16_t> result(CTL_BANK_HEADER_REGISTERS, 0);
        const auto wide = [&result](unsigned offset, std::uint32_t value) {
            result.at(offset) = static_cast<std::uint16_t>(value >> 16);
            result.at(offset + 1) = static_cast<std::uint16_t>(value & 0xFFFFu);
        };
        const auto append = [&result](std::uint32_t value) {
            result.push_back(static_cast<std::uint16_t>(value >> 16));
            result.push_back(static_cast<std::uint16_t>(value & 0xFFFFu));
        };
        const bool isPosition = kind == CTL_PROGRAM_KIND_POSITION_MOVE;
        result[CTL_OFFSET_BANK_LAYOUT] = CTL_TABLE_LAYOUT_INTERVALS;
        result[CTL_OFFSET_BANK_KIND] = kind;
        result[CTL_OFFSET_BANK_ROW_COUNT] = static_cast<std::uint16_t>(rows.size());
        wide(CTL_OFFSET_BANK_CYCLE_TICKS, static_cast<std::uint32_t>(std::ceil(8e6 * timeS())));
        wide(CTL_OFFSET_BANK_ADVANCE, static_cast<std::uint32_t>(advance()));
        wide(CTL_OFFSET_BANK_REMAINDER, remainder);
        wide(CTL_OFFSET_BANK_DIVISOR, divisor);
        result[CTL_OFFSET_BANK_END_BEHAVIOR] = atEnd;
        result[CTL_OFFSET_INTERVAL_FRACTION_BITS] = fractionBits;
        wide(isPosition ? CTL_OFFSET_POSITION_MOVE_PULSES_PER_MOTOR_REV
                        : CTL_OFFSET_SPEED_MOVE_PULSES_PER_MOTOR_REV,
             pulsesPerMotorRev);
        wide(isPosition ? CTL_OFFSET_POSITION_MOVE_FEED : CTL_OFFSET_SPEED_MOVE_FEED, feedUm);
        result[isPosition ? CTL_OFFSET_POSITION_MOVE_DURATION : CTL_OFFSET_SPEED_MOVE_DURATION] =
            CTL_MOVE_DURATION_FASTEST;
        if (isPosition) {
            wide(CTL_OFFSET_POSITION_MOVE_DISTANCE,
                 static_cast<std::uint32_t>(advance() * feedUm / pulsesPerMotorRev));
        } else {
            wide(CTL_OFFSET_SPEED_MOVE_START_SPEED, speedUmPerS(rows.front().firstHz));
            wide(CTL_OFFSET_SPEED_MOVE_END_SPEED, speedUmPerS(rows.back().lastHz));
        }
        // The nominal rate is 2^23 iterations a second, the real one 50 MHz / 6.
        constexpr double speedUnit = (1u << fractionBits) * 1.00663296;
        for (const Interval& row : rows) {
            const double first = std::round(row.firstHz * speedUnit);
            const double last = std::round(row.lastHz * speedUnit);
            append(row.pulses);
            append(static_cast<std::uint32_t>(first));
            append(static_cast<std::uint32_t>(last));
            append(static_cast<std::uint32_t>(std::ceil(std::abs(last * last - first * first) /
                                                        (2.0 * (1u << fractionBits) * row.pulses))));
        }
        return result;
    }
};

// Returns 50 Hz to 20 kHz in about 0.2 s, 0.5 s, back in about 0.25 s: the trapezoid of the paper on moves.
inline IntervalImage trapezoidMove(bool backwards = false)
{
    IntervalImage move;
    move.backwards = backwards;
    move.rows = {{2005, 50, 20'000}, {10'000, 20'000, 20'000}, {2506, 20'000, 50}};
    return move;
}

// Returns 50 Hz to 20 kHz in about 0.5 s; the last speed is held.
inline IntervalImage rampAndHold(bool backwards = false)
{
    IntervalImage move;
    move.kind = CTL_PROGRAM_KIND_SPEED_MOVE;
    move.atEnd = CTL_END_BEHAVIOR_HOLD_SPEED;
    move.backwards = backwards;
    move.rows = {{5012, 50, 20'000}};
    return move;
}

} // namespace campanel::test
