// SPDX-License-Identifier: Apache-2.0
// The groups of a program's inputs, for a screen too small for all of them.
#pragma once

#include "app/program/recipe.h"

#include <QString>

namespace campanel::panel {

// Returns the group's key, such as "master"; empty for what is not among a program's inputs.
[[nodiscard]] QString inputGroup(profile::Field field);
[[nodiscard]] QString inputGroup(program::Choice choice);

} // namespace campanel::panel
