// SPDX-License-Identifier: Apache-2.0
// Users, logging in and the audit trail with something to see.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> accessScenes();

// Takes out the users of another scene, so that nothing is restricted.
void forgetUsers(Stage& stage);

// Of everybody in the scenes.
inline constexpr auto scenePin = "258036";

} // namespace campanel::looks
