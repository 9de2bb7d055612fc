// SPDX-License-Identifier: Apache-2.0
// Press banks for tests, built without the profile layer; 0.01 mm per pulse.
#pragma once

#include "engine/ctl_press.h"

#include <array>
#include <cstdint>
#include <vector>

namespace campanel::test {

struct PressImage {
    struct Row {
        std::uint32_t hz = 0;
        std::int32_t end = 0;
        std::uint32_t force = 0;
        std::uint32_t ms = 0;
    };
    // 80 mm/s to 60 mm, 4 mm/s until 200 N or 90 mm, 10 mm/s to 100 mm, 0.1 s, 80 mm/s up; at most 8000 N.
    std::array<Row, CTL_STAGE_COUNT> rows{{{8000, 6000, 200, 20},
                                           {400, 9000, 200, 5},
                                           {1000, 10000, 8000, 5},
                                           {0, 10000, 8000, 100},
                                           {8000, 0, 8000, 20}}};
    std::uint16_t toleranceUm = 20;
    std::uint16_t minStopForce = 1000;
    std::uint16_t maxStopForce = 6000;
    std::uint32_t feedUm = 100'000;
    std::uint32_t pulsesPerMotorRev = 10'000;

    [[nodiscard]] std::vector<std::uint16_t> registers() const
    {
        std::vector<std::uint16_t> result(CTL_BANK_HEADER_REGISTERS + CTL_STAGE_COUNT * CTL_STAGE_REGISTERS,
                                          0);
        const auto wide = [&result](std::size_t offset, std::uint32_t value) {
            result.at(offset) = static_cast<std::uint16_t>(value >> 16);
            result.at(offset + 1) = static_cast<std::uint16_t>(value & 0xFFFFu);
        };
        result[CTL_OFFSET_BANK_LAYOUT] = CTL_TABLE_LAYOUT_PRESS_STAGES;
        result[CTL_OFFSET_BANK_KIND] = CTL_PROGRAM_KIND_PRESS;
        result[CTL_OFFSET_BANK_ROW_COUNT] = CTL_STAGE_COUNT;
        wide(CTL_OFFSET_BANK_CYCLE_TICKS, 80'000'000);
        wide(CTL_OFFSET_BANK_DIVISOR, 1);
        result[CTL_OFFSET_PRESS_POSITION_TOLERANCE] = toleranceUm;
        result[CTL_OFFSET_PRESS_MIN_STOP_FORCE] = minStopForce;
        result[CTL_OFFSET_PRESS_MAX_STOP_FORCE] = maxStopForce;
        const auto position = [&](std::size_t offset, const Row& row) {
            wide(offset, static_cast<std::uint32_t>(static_cast<std::uint64_t>(row.end) * feedUm /
                                                    pulsesPerMotorRev));
        };
        position(CTL_OFFSET_PRESS_APPROACH_POSITION, rows[CTL_PRESS_APPROACH]);
        position(CTL_OFFSET_PRESS_PROBE_END, rows[CTL_PRESS_PROBE]);
        position(CTL_OFFSET_PRESS_PRESS_POSITION, rows[CTL_PRESS_PRESS]);
        wide(CTL_OFFSET_PRESS_FEED, feedUm);
        wide(CTL_OFFSET_PRESS_PULSES_PER_MOTOR_REV, pulsesPerMotorRev);
        std::size_t at = CTL_OFFSET_BANK_ROWS;
        for (const Row& row : rows) {
            wide(at, row.hz);
            wide(at + 2, static_cast<std::uint32_t>(row.end));
            wide(at + 4, row.force);
            wide(at + 6, row.ms);
            at += CTL_STAGE_REGISTERS;
        }
        return result;
    }
};

} // namespace campanel::test
