// SPDX-License-Identifier: Apache-2.0
// Scenes of backup and restore, with a simulated stick.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> backupScenes();

} // namespace campanel::looks
