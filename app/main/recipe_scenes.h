// SPDX-License-Identifier: Apache-2.0
// Scenes of the recipe page and its dialogs, with a fixed library.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

[[nodiscard]] QList<Scene> recipeScenes();

} // namespace campanel::panel
