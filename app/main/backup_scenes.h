// SPDX-License-Identifier: Apache-2.0
// Scenes of backup and restore, with a simulated stick.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

[[nodiscard]] QList<Scene> backupScenes();

} // namespace campanel::panel
