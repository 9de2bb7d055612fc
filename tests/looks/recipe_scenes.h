// SPDX-License-Identifier: Apache-2.0
// The page of recipes and its dialogs, on a library that is the same each time.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> recipeScenes();

} // namespace campanel::looks
