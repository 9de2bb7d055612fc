// SPDX-License-Identifier: Apache-2.0
// The steps of the first start.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> firstScenes();

} // namespace campanel::looks
