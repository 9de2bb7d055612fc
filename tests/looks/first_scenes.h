// SPDX-License-Identifier: Apache-2.0
// Scenes of the first start.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> firstScenes();

} // namespace campanel::looks
