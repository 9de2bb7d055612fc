// SPDX-License-Identifier: Apache-2.0
// Banks of cam points for tests, built without the profile layer: any curve with its derivative, sampled at
// the ends of equal intervals.
#pragma once

#include "ctl_registers.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace campanel::test {

struct CamRow {
    std::int32_t position = 0; // 1/256 pulse from the first row
    std::int32_t slope = 0;    // 1/256 pulse per interval
};

struct CamImage {
    std::uint16_t kind = CTL_PROGRAM_KIND_POINT_CAM;
    std::uint16_t atEnd = CTL_END_BEHAVIOR_REPEAT;
    std::vector<CamRow> rows;
    std::uint32_t cycleTicks = 8'000'000;
    std::int32_t advance = 0; // pulses, rounded down
    std::uint32_t remainder = 0;
    std::uint32_t divisor = 1;
    std::uint16_t masterRampMs = 300;
    std::uint16_t rampShape = CTL_RAMP_SHAPE_TRAPEZOID;
    std::uint16_t knots = 0;
    std::uint16_t segments = 0; // only for a segment cam
    std::uint32_t pulsesPerMotorRev = 10000;
    std::uint32_t feedUm = 100'000;
    std::int16_t masterRate = 600; // only for a point cam, 0.1 r/min
    double clockHz = 8e6;

    [[nodiscard]] std::uint32_t speedUmPerS(const CamRow& row) const
    {
        const double pulsesPerS =
            row.slope / 256.0 * static_cast<double>(rows.size() - 1) * clockHz / cycleTicks;
        return static_cast<std::uint32_t>(std::lround(pulsesPerS * feedUm / pulsesPerMotorRev));
    }
    // Returns header, rows, and knots or segments as sent over the line.
    [[nodiscard]] std::vector<std::uint16_t> registers() const
    {
        std::vector<std::uint16_t> result(CTL_BANK_HEADER_REGISTERS, 0);
        const auto wide = [&result](unsigned offset, std::uint32_t value) {
            result.at(offset) = static_cast<std::uint16_t>(value >> 16);
            result.at(offset + 1) = static_cast<std::uint16_t>(value & 0xFFFFu);
        };
        const auto append = [&result](std::int32_t value) {
            const auto bits = static_cast<std::uint32_t>(value);
            result.push_back(static_cast<std::uint16_t>(bits >> 16));
            result.push_back(static_cast<std::uint16_t>(bits & 0xFFFFu));
        };
        result[CTL_OFFSET_BANK_LAYOUT] = CTL_TABLE_LAYOUT_CAM_POINTS;
        result[CTL_OFFSET_BANK_KIND] = kind;
        result[CTL_OFFSET_BANK_ROW_COUNT] = static_cast<std::uint16_t>(rows.size());
        wide(CTL_OFFSET_BANK_CYCLE_TICKS, cycleTicks);
        wide(CTL_OFFSET_BANK_ADVANCE, static_cast<std::uint32_t>(advance));
        wide(CTL_OFFSET_BANK_REMAINDER, remainder);
        wide(CTL_OFFSET_BANK_DIVISOR, divisor);
        result[CTL_OFFSET_BANK_END_BEHAVIOR] = atEnd;
        result[CTL_OFFSET_CAM_MASTER_RAMP] = masterRampMs;
        result[CTL_OFFSET_CAM_RAMP_SHAPE] = rampShape;
        result[CTL_OFFSET_CAM_KNOT_COUNT] = kind == CTL_PROGRAM_KIND_SEGMENT_CAM ? segments : knots;
        switch (kind) {
        case CTL_PROGRAM_KIND_POSITION_MOVE:
            wide(CTL_OFFSET_POSITION_MOVE_PULSES_PER_MOTOR_REV, pulsesPerMotorRev);
            wide(CTL_OFFSET_POSITION_MOVE_FEED, feedUm);
            result[CTL_OFFSET_POSITION_MOVE_DURATION] = CTL_MOVE_DURATION_FASTEST;
            wide(CTL_OFFSET_POSITION_MOVE_DISTANCE,
                 static_cast<std::uint32_t>(std::int64_t{advance} * feedUm / pulsesPerMotorRev));
            break;
        case CTL_PROGRAM_KIND_SPEED_MOVE:
            wide(CTL_OFFSET_SPEED_MOVE_PULSES_PER_MOTOR_REV, pulsesPerMotorRev);
            wide(CTL_OFFSET_SPEED_MOVE_FEED, feedUm);
            result[CTL_OFFSET_SPEED_MOVE_DURATION] = CTL_MOVE_DURATION_FASTEST;
            wide(CTL_OFFSET_SPEED_MOVE_START_SPEED, speedUmPerS(rows.front()));
            wide(CTL_OFFSET_SPEED_MOVE_END_SPEED, speedUmPerS(rows.back()));
            break;
        default:
            result[CTL_OFFSET_CAM_MASTER_RATE] = static_cast<std::uint16_t>(masterRate);
            // 60 s * ratio * scale / rate
            wide(CTL_OFFSET_CAM_MASTER_RATIO,
                 static_cast<std::uint32_t>(
                     std::lround(1e6 * cycleTicks * std::abs(masterRate) / (clockHz * 600))));
            wide(CTL_OFFSET_CAM_MASTER_SCALE, 1);
            wide(CTL_OFFSET_CAM_SLAVE_SCALE, 1000);
            wide(CTL_OFFSET_CAM_PULSES_PER_MOTOR_REV, pulsesPerMotorRev);
            wide(CTL_OFFSET_CAM_FEED, feedUm);
            break;
        }
        for (const CamRow& row : rows) {
            append(row.position);
            append(row.slope);
        }
        for (std::int32_t i = 0; i < knots; ++i) {
            append(3'600'000 / knots * i);
            append(static_cast<std::int32_t>(std::int64_t{advance} * feedUm / pulsesPerMotorRev * i /
                                             (knots - 1)));
        }
        for (std::int32_t i = 1; i <= segments; ++i) {
            append(3'600'000 / segments * i);
            append(
                static_cast<std::int32_t>(std::int64_t{advance} * feedUm / pulsesPerMotorRev * i / segments));
            result.resize(result.size() + CTL_SEGMENT_REGISTERS - 4, 0);
        }
        return result;
    }
};

// Returns rows of `curve` (pulses) and `derivative` (pulses per cycle), both over x = 0..1.
template <typename Curve, typename Derivative>
std::vector<CamRow> camRows(unsigned intervals, Curve curve, Derivative derivative)
{
    std::vector<CamRow> rows;
    for (unsigned i = 0; i <= intervals; ++i) {
        const double x = static_cast<double>(i) / intervals;
        rows.push_back({static_cast<std::int32_t>(std::lround(256.0 * curve(x))),
                        static_cast<std::int32_t>(std::lround(256.0 * derivative(x) / intervals))});
    }
    return rows;
}

// Returns a progressive cam: net pulses per cycle plus a sine of amplitude `swing` pulses.
inline CamImage sineCam(double net, double swing, unsigned intervals, std::uint32_t cycleTicks)
{
    constexpr double turn = 2.0 * std::numbers::pi;
    CamImage cam;
    cam.cycleTicks = cycleTicks;
    cam.rows = camRows(
        intervals, [=](double x) { return net * x + swing * std::sin(turn * x); },
        [=](double x) { return net + swing * turn * std::cos(turn * x); });
    cam.advance = static_cast<std::int32_t>(std::floor(net));
    return cam;
}

// Returns a move from rest to rest over this many pulses, by the quintic.
inline CamImage quinticMove(double pulses, unsigned intervals, std::uint32_t cycleTicks)
{
    CamImage cam;
    cam.kind = CTL_PROGRAM_KIND_POSITION_MOVE;
    cam.atEnd = CTL_END_BEHAVIOR_STOP;
    cam.masterRampMs = 0;
    cam.cycleTicks = cycleTicks;
    cam.rows = camRows(
        intervals, [=](double x) { return pulses * x * x * x * (10.0 - 15.0 * x + 6.0 * x * x); },
        [=](double x) { return pulses * 30.0 * x * x * (1.0 - x) * (1.0 - x); });
    cam.advance = static_cast<std::int32_t>(std::floor(pulses));
    return cam;
}

// Returns a ramp from rest to this many pulses per second, by the cubic 2-3 as speed law; the last speed is
// held.
inline CamImage speedMove(double pulsesPerS, unsigned intervals, std::uint32_t cycleTicks,
                          double clockHz = 8e6)
{
    const double perCycle = pulsesPerS * cycleTicks / clockHz;
    CamImage cam;
    cam.kind = CTL_PROGRAM_KIND_SPEED_MOVE;
    cam.clockHz = clockHz;
    cam.atEnd = CTL_END_BEHAVIOR_HOLD_SPEED;
    cam.masterRampMs = 0;
    cam.cycleTicks = cycleTicks;
    cam.rows = camRows(
        intervals, [=](double x) { return perCycle * x * x * x * (1.0 - x / 2.0); },
        [=](double x) { return perCycle * x * x * (3.0 - 2.0 * x); });
    cam.advance = static_cast<std::int32_t>(std::floor(perCycle / 2.0));
    return cam;
}

} // namespace campanel::test
