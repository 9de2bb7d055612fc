// SPDX-License-Identifier: Apache-2.0
// Converts the segments of a cam to and from CSV text, with the rules of knots_csv.h. Pure functions of text.
#pragma once

#include "profile/cam/csv_reader.h"
#include "profile/cam/csv_writer.h"
#include "profile/program/programs.h"

#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

[[nodiscard]] std::span<const std::string_view> segmentColumns();

// Reads a header line, then one line per segment with a field for each of segmentColumns(). The motion is its
// key; a number that the motion does not use may be empty. checkSegments() decides if the segments form a
// valid cam.
[[nodiscard]] tl::expected<std::vector<CamSegment>, CsvError> readSegmentsCsv(std::string_view text);

// Writes the shortest numbers that read back exactly. Numbers that the motion does not use are empty.
[[nodiscard]] std::string writeSegmentsCsv(std::span<const CamSegment> segments,
                                           const CsvDialect& dialect = {});

} // namespace campanel::profile
