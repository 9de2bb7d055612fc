// SPDX-License-Identifier: Apache-2.0
// The table of a program as named columns of numbers, for printing and export.
#pragma once

#include "app/program/program_image.h"

#include <string>
#include <vector>

namespace campanel::program {

struct TableColumn {
    const char* name = ""; // including the unit, as in "time_s"
    int decimals = 0;      // in text for people
    std::vector<double> values;
};

// Returns columns of equal length, one value for each row; the first one is the row number from 0.
[[nodiscard]] std::vector<TableColumn> tableColumns(const ProgramImage& image);

// Returns a line of names, then one for each row, with up to 10 significant digits and a decimal point.
[[nodiscard]] std::string tableCsv(const std::vector<TableColumn>& columns);

} // namespace campanel::program
