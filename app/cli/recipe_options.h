// SPDX-License-Identifier: Apache-2.0
// Options that replace values of the recipe.
#pragma once

#include "app/cli/failure.h"
#include "app/program/program_image.h"

#include <QCommandLineOption>

namespace campanel::cli {

class Invocation;

[[nodiscard]] QList<QCommandLineOption> recipeOptions();

// Returns the recipe of the named file, or the default one, with the options applied. A given cycle value
// becomes an input. One value replaces the input that it contradicts least; two values are the inputs.
[[nodiscard]] tl::expected<program::Recipe, Failure> recipeOf(const Invocation& call);

} // namespace campanel::cli
