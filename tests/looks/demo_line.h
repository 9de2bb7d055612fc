// SPDX-License-Identifier: Apache-2.0
// What a line of 9600 baud would have to tell on an ordinary day: figures, frames, findings, registers.
// Always the same. For the demonstration link.
#pragma once

#include "app/link/link_values.h"
#include "app/program/program_image.h"

namespace campanel::looks {

// A day of exchanges up to 14:07 with a bad hour in it.
[[nodiscard]] link::FiguresReport demoFigures(link::SteadyTime now);
// Status, a command, a write, and three kinds of trouble; the last one came `now`.
[[nodiscard]] QList<modbus::FrameRecord> demoFrames(link::SteadyTime now);
// A search under way.
[[nodiscard]] link::ScanReport demoSearch(modbus::ScanPlan::Depth depth);
// The same at its end: with a controller, or with reasons why there is none.
[[nodiscard]] link::ScanReport demoSearchEnd(bool isFound, const modbus::Identity& identity);
// A machine that runs `program`.
[[nodiscard]] std::vector<std::uint16_t> demoRegisters(const link::ReadRequest& request,
                                                       const program::ProgramImage& program);

} // namespace campanel::looks
