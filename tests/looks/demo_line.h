// SPDX-License-Identifier: Apache-2.0
// Example data of a line at 9600 baud on an ordinary day: figures, frames, findings, registers. Always the
// same. For the demonstration link.
#pragma once

#include "app/link/link_values.h"
#include "app/program/program_image.h"

namespace campanel::looks {

// Returns a day of exchanges up to 14:07 with a bad hour.
[[nodiscard]] link::FiguresReport demoFigures(link::SteadyTime now);
// Returns a status, a command, a write, and three kinds of errors; the last frame is at `now`.
[[nodiscard]] QList<modbus::FrameRecord> demoFrames(link::SteadyTime now);
// Returns the progress of a search.
[[nodiscard]] link::ScanReport demoSearch(modbus::ScanPlan::Depth depth);
// Returns the end of a search: with a controller, or with the reasons why there is none.
[[nodiscard]] link::ScanReport demoSearchEnd(modbus::ScanPlan::Depth depth, bool isFound,
                                             const modbus::Identity& identity);
// Returns the registers of a machine that runs `program`, with an engaged encoder or none.
[[nodiscard]] std::vector<std::uint16_t> demoRegisters(const link::ReadRequest& request,
                                                       const program::ProgramImage& program, bool hasEncoder);

} // namespace campanel::looks
