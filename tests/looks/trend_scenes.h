// SPDX-License-Identifier: Apache-2.0
// Scenes of the page Trends: empty, with a week of example data, its sheets.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> trendScenes();

} // namespace campanel::looks
