// SPDX-License-Identifier: Apache-2.0
// The program that the controller is executing, reconstructed from the header that it keeps beside the table.
#pragma once

#include "app/link/link_values.h"
#include "app/program/recipe.h"
#include "profile/cutter/sampling.h"

#include <limits>
#include <memory>

namespace campanel::machine {

// Points per curve: the most that a plot draws.
inline constexpr std::size_t curvePoints = 1000;

struct ControllerProgram {
    std::uint32_t generation = 0;
    std::uint32_t crc = 0;
    std::vector<std::uint16_t> registers; // of the header
    std::vector<std::uint16_t> knots;     // of a point cam
    modbus::BankHeader header;            // the same decoded
    program::Recipe recipe;
    double pulsesPerMm = 0;
    // NaN when the header does not make a cycle.
    double version = std::numeric_limits<double>::quiet_NaN();
    double bagLengthMm = std::numeric_limits<double>::quiet_NaN();
    double cycleSeconds =
        std::numeric_limits<double>::quiet_NaN(); // of the table; of a press: a nominal stroke
    double rateBagsPerMin = std::numeric_limits<double>::quiet_NaN();
    // Knife angles.
    double syncStartDeg = std::numeric_limits<double>::quiet_NaN();
    double syncEndDeg = std::numeric_limits<double>::quiet_NaN();
    double cutDeg = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> marksS;
    std::shared_ptr<const profile::Curves> curves; // null when the parameters do not make a cycle
};

// Null when the controller has no program.
[[nodiscard]] std::shared_ptr<const ControllerProgram> readProgram(const link::ActiveProgram& active,
                                                                   const modbus::Identity& identity);

} // namespace campanel::machine
