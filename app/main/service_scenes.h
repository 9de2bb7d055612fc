// SPDX-License-Identifier: Apache-2.0
// Scenes of the machine's sections of Service: jog, homing, inputs and outputs, dry run.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

[[nodiscard]] QList<Scene> serviceScenes();

} // namespace campanel::panel
