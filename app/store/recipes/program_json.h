// SPDX-License-Identifier: Apache-2.0
// The objects "program" and "machine" of a recipe file, for every kind of program. Internal to app/store.
#pragma once

#include "app/program/recipe.h"
#include "app/store/files/file_error.h"

#include <QJsonObject>

#include <optional>

namespace campanel::store {

[[nodiscard]] QJsonObject programJson(const program::Recipe& recipe);
[[nodiscard]] QJsonObject machineJson(const program::Recipe& recipe);

// Read the objects. Missing values have the default of the kind. The first error goes into `failure`. The
// program must be read first: it determines the machine data.
void readProgram(const QJsonObject& object, program::Recipe& recipe, std::optional<FileError>& failure);
void readMachine(const QJsonObject& object, program::Recipe& recipe, std::optional<FileError>& failure);

} // namespace campanel::store
