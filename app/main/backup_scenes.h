// SPDX-License-Identifier: Apache-2.0
// Scenes of backup and restore, with a stick that nobody has to plug in.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

[[nodiscard]] QList<Scene> backupScenes();

} // namespace campanel::panel
