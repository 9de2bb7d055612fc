// SPDX-License-Identifier: Apache-2.0
// The page of recipes and its dialogs, on a library that is the same each time.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

[[nodiscard]] QList<Scene> recipeScenes();

} // namespace campanel::panel
