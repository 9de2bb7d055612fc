// SPDX-License-Identifier: Apache-2.0
// The page Trends: empty, with a week of a machine's life, its sheets.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> trendScenes();

} // namespace campanel::looks
