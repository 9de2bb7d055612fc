// SPDX-License-Identifier: Apache-2.0
// Scenes of the page Trends: empty, with a week of example data, its sheets.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

[[nodiscard]] QList<Scene> trendScenes();

} // namespace campanel::panel
