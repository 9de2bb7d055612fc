// SPDX-License-Identifier: Apache-2.0
// The segments of a cam in a recipe file.
#pragma once

#include "app/store/files/json_reader.h"
#include "profile/program/programs.h"

#include <QJsonArray>

#include <span>

namespace campanel::store {

// Returns an object for each segment. Numbers that its motion does not use are left out.
[[nodiscard]] QJsonArray segmentsJson(std::span<const profile::CamSegment> segments);
// Reads the key `segments` of the program, when it is there; stores the first error. Where segments lie is
// checked with the recipe, not here.
void readSegmentsJson(ObjectReader& reader, profile::SegmentCamProgram& program,
                      std::optional<FileError>& failure);

} // namespace campanel::store
