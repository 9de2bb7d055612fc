// SPDX-License-Identifier: Apache-2.0
// Scenes of backup and restore, with a stick that nobody has to plug in.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> backupScenes();

} // namespace campanel::looks
