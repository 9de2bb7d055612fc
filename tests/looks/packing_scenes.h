// SPDX-License-Identifier: Apache-2.0
// Scenes of Service for packing machines, with example data: values, measured marks, the wizard's steps.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> packingScenes();

} // namespace campanel::looks
