// SPDX-License-Identifier: Apache-2.0
// Converts the knots of a cam to and from CSV text. Pure functions of text without file access.
#pragma once

#include "profile/cam/csv_reader.h"
#include "profile/cam/csv_writer.h"
#include "profile/program/programs.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

[[nodiscard]] std::span<const std::string_view> knotColumns();

// Reads a header line, then one line per knot: "master_deg,slave_mm" in degrees and mm. The decimal sign is a
// point or a comma, the same one throughout. checkKnots() decides if the knots form a valid cam.
[[nodiscard]] tl::expected<std::vector<Knot>, CsvError> readKnotsCsv(std::string_view text);

// Writes the shortest numbers that read back exactly.
[[nodiscard]] std::string writeKnotsCsv(std::span<const Knot> knots, const CsvDialect& dialect = {});

} // namespace campanel::profile
