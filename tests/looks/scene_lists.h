// SPDX-License-Identifier: Apache-2.0
// The scenes of each part of the panel, for allScenes().
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> accessScenes();

// Removes the users of another scene, so that nothing is restricted.
void forgetUsers(Stage& stage);

// The PIN of all users in the scenes.
inline constexpr auto scenePin = "258036";
[[nodiscard]] QList<Scene> alarmScenes();
[[nodiscard]] QList<Scene> backupScenes();
[[nodiscard]] QList<Scene> firstScenes();
[[nodiscard]] QList<Scene> packingScenes();
[[nodiscard]] QList<Scene> recipeScenes();
[[nodiscard]] QList<Scene> serviceScenes();
[[nodiscard]] QList<Scene> trendScenes();

} // namespace campanel::looks
