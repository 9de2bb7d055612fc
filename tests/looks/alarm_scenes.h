// SPDX-License-Identifier: Apache-2.0
// The Alarms page and its dialogs as scenes.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

[[nodiscard]] QList<Scene> alarmScenes();

} // namespace campanel::looks
