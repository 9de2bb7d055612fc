// SPDX-License-Identifier: Apache-2.0
// Scenes of the recipe page and its dialogs, with a fixed library.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> recipeScenes();

} // namespace campanel::looks
