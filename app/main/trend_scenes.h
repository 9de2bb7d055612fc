// SPDX-License-Identifier: Apache-2.0
// The page Trends: empty, with a week of a machine's life, its sheets.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

[[nodiscard]] QList<Scene> trendScenes();

} // namespace campanel::panel
