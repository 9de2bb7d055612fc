// SPDX-License-Identifier: Apache-2.0
// Scenes of users, logins and the audit trail, with example data.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> accessScenes();

// Removes the users of another scene, so that nothing is restricted.
void forgetUsers(Stage& stage);

// The PIN of all users in the scenes.
inline constexpr auto scenePin = "258036";

} // namespace campanel::looks
