// SPDX-License-Identifier: Apache-2.0
// The recipe format (profile/README.md) to a recipe and back. Keys are the ids of the fields.
#pragma once

#include "app/program/recipe.h"
#include "app/store/files/file_error.h"

#include <QByteArray>

#include <tl/expected.hpp>

namespace campanel::store {

inline constexpr int recipeFormatVersion = 1;

[[nodiscard]] QByteArray toJson(const program::Recipe& recipe);

// `path` only goes into the error. The two pinned values and the speed law must be there; what else is absent
// or null has its default. Keys that are not known are refused, so that a misspelled one does not become a
// default.
[[nodiscard]] tl::expected<program::Recipe, FileError> fromJson(const QByteArray& json, const QString& path);

} // namespace campanel::store
