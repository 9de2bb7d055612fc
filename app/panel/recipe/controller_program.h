// SPDX-License-Identifier: Apache-2.0
// The controller's active program, reconstructed from the header that is stored beside the table.
#pragma once

#include "app/link/link_values.h"
#include "app/program/recipe.h"
#include "profile/cutter/sampling.h"

#include <limits>
#include <memory>
#include <string>

namespace campanel::panel {

// The points per curve: the maximum that a plot draws.
inline constexpr std::size_t curvePoints = 1000;

struct ControllerProgram {
    std::uint32_t generation = 0;
    std::uint32_t crc = 0;
    std::vector<std::uint16_t> registers; // the header
    std::vector<std::uint16_t> list;      // the knots or segments of a cam
    modbus::ProgramKind kind = modbus::ProgramKind::None;
    modbus::TableLayout layout = modbus::TableLayout::None;
    std::string name;
    program::Recipe recipe;
    double pulsesPerMm = 0;
    double advanceMm = 0; // of the axis per cycle of a cam, in the direction of the program
    // NaN when the header does not describe a cycle.
    double version = std::numeric_limits<double>::quiet_NaN();
    double bagLengthMm = std::numeric_limits<double>::quiet_NaN();
    double cycleSeconds =
        std::numeric_limits<double>::quiet_NaN(); // of the table; of a press: a nominal stroke
    double rateBagsPerMin = std::numeric_limits<double>::quiet_NaN();
    // The knife angles.
    double syncStartDeg = std::numeric_limits<double>::quiet_NaN();
    double syncEndDeg = std::numeric_limits<double>::quiet_NaN();
    double cutDeg = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> marksS;
    std::shared_ptr<const profile::Curves> curves; // null when the parameters do not describe a cycle
};

// Returns the angle of the knife's shaft at a master angle, 0 at the index mark.
[[nodiscard]] double knifeDegAt(const profile::RotaryCutter& cutter, double masterDeg);

// Returns null when the controller has no program.
[[nodiscard]] std::shared_ptr<const ControllerProgram> readProgram(const link::ActiveProgram& active,
                                                                   const modbus::Identity& identity);

} // namespace campanel::panel
