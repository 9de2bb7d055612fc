// SPDX-License-Identifier: Apache-2.0
// The section of Service for packing machines with something to see: values, measured marks, the wizard's
// steps.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> packingScenes();

} // namespace campanel::looks
