// SPDX-License-Identifier: Apache-2.0
// The screens of each part of the panel, for allScenes().
#pragma once

#include "tests/looks/screens.h"

namespace campanel::looks {

[[nodiscard]] QList<Screen> accessScreens();
// Returns some of the screens as those of somebody who may only look, with a padlock on each key.
[[nodiscard]] QList<Screen> lockedScreens(const QList<Screen>& all);

// Removes the users of another screen, so that nothing is restricted.
void forgetUsers(TestWindow& window);

// The PIN of all users in the screens.
inline constexpr auto screenPin = "258036";
[[nodiscard]] QList<Screen> alarmScreens();
[[nodiscard]] QList<Screen> backupScreens();
[[nodiscard]] QList<Screen> cutterScreens();
[[nodiscard]] QList<Screen> firstScreens();
[[nodiscard]] QList<Screen> motorScreens();
// Removes the orders of another screen.
void forgetOrders(TestWindow& window);
[[nodiscard]] QList<Screen> orderScreens();
[[nodiscard]] QList<Screen> packingScreens();
[[nodiscard]] QList<Screen> recipeScreens();
[[nodiscard]] QList<Screen> scanScreens();
[[nodiscard]] QList<Screen> maintenanceScreens();
[[nodiscard]] QList<Screen> stopScreens();
[[nodiscard]] QList<Screen> trendScreens();
[[nodiscard]] QList<Screen> updateScreens();

} // namespace campanel::looks
