// SPDX-License-Identifier: Apache-2.0
// Options that replace values of the recipe.
#pragma once

#include "app/cli/failure.h"
#include "app/program/program_image.h"

#include <QCommandLineOption>

namespace campanel::cli {

class Invocation;

[[nodiscard]] QList<QCommandLineOption> recipeOptions();

// The recipe of the file named, or the default one, with the options applied. A cycle value given becomes an
// input: one takes the place of the input that it contradicts least, two are the inputs.
[[nodiscard]] tl::expected<program::Recipe, Failure> recipeOf(const Invocation& call);

} // namespace campanel::cli
