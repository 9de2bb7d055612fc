// SPDX-License-Identifier: Apache-2.0
// Loads pages and dialogs in each look and fails on any warning, clipped text, small target or unreachable
// Stop.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

// Returns the exit code for main().
[[nodiscard]] int selfTest(const QList<Look>& looks, const QList<Scene>& scenes);

} // namespace campanel::panel
