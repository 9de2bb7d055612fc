// SPDX-License-Identifier: Apache-2.0
// Scenes of the machine's sections of Service: jog, homing, inputs and outputs, dry run.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> serviceScenes();

} // namespace campanel::looks
