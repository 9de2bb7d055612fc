// SPDX-License-Identifier: Apache-2.0
// Scenes of the first start.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

[[nodiscard]] QList<Scene> firstScenes();

} // namespace campanel::panel
