// SPDX-License-Identifier: Apache-2.0
// The Alarms page and its dialogs as scenes.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

[[nodiscard]] QList<Scene> alarmScenes();

} // namespace campanel::panel
