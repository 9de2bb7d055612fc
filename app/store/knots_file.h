// SPDX-License-Identifier: Apache-2.0
// Knots of a point cam as a CSV file (format: profile/knots_csv.h).
#pragma once

#include "app/store/file_error.h"
#include "profile/programs.h"

#include <tl/expected.hpp>

#include <span>
#include <vector>

namespace campanel::store {

// Errors are whole sentences in the language of the program, with file and line.
[[nodiscard]] tl::expected<std::vector<profile::Knot>, QString> readKnots(const QString& path);
[[nodiscard]] tl::expected<void, QString> writeKnots(std::span<const profile::Knot> knots,
                                                     const QString& path);

} // namespace campanel::store
