// SPDX-License-Identifier: Apache-2.0
// Converts a recipe to and from the recipe format (profile/README.md). Keys are the ids of the fields.
#pragma once

#include "app/program/recipe.h"
#include "app/store/files/file_error.h"

#include <QByteArray>

#include <tl/expected.hpp>

namespace campanel::store {

inline constexpr int recipeFormatVersion = 6;

// Returns true for a code that a scanner can read: printable characters, none of them a space at an end.
[[nodiscard]] bool isScannable(const QString& code);

[[nodiscard]] QByteArray toJson(const program::Recipe& recipe);

// A name with hidden characters, or with none that are visible: files from outside are refused, those that
// this panel has kept are read.
enum class Names { Refuse, Repair };

// Reads a recipe. `path` is only for the error. The two pinned values and the speed law must exist; other
// values that are missing or null have their default. Unknown keys are refused, so that a misspelled one does
// not become a default.
[[nodiscard]] tl::expected<program::Recipe, FileError> fromJson(const QByteArray& json, const QString& path,
                                                                Names names = Names::Refuse);

} // namespace campanel::store
