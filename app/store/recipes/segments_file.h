// SPDX-License-Identifier: Apache-2.0
// The segments of a cam as CSV file (format: profile/segments/segments_csv.h) and in a recipe file.
#pragma once

#include "app/store/files/json_reader.h"
#include "profile/program/programs.h"

#include <QJsonArray>

#include <span>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::store {

// Reads the segments. Waits for the disk. Errors are whole sentences in the language of the program, with
// file and line.
[[nodiscard]] tl::expected<std::vector<profile::CamSegment>, QString> readSegments(const QString& path);

// Returns an object for each segment. Numbers that its motion does not use are left out.
[[nodiscard]] QJsonArray segmentsJson(std::span<const profile::CamSegment> segments);
// Reads the key `segments` of the program, when it is there; stores the first error. Where segments lie is
// checked with the recipe, not here.
void readSegmentsJson(ObjectReader& reader, profile::SegmentCamProgram& program,
                      std::optional<FileError>& failure);

} // namespace campanel::store
