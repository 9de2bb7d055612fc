// SPDX-License-Identifier: Apache-2.0
// The table of a program as named columns of numbers, for who prints it or takes it along.
#pragma once

#include "app/program/program_image.h"

#include <string>
#include <vector>

namespace campanel::program {

struct TableColumn {
    const char* name = ""; // with its unit, as in "time_s"
    int decimals = 0;      // in text for people
    std::vector<double> values;
};

// All equally long, a value for each row; the first one counts the rows from 0.
[[nodiscard]] std::vector<TableColumn> tableColumns(const ProgramImage& image);

// A line of names, then one for each row; up to 10 significant digits, point as decimal mark.
[[nodiscard]] std::string tableCsv(const std::vector<TableColumn>& columns);

} // namespace campanel::program
