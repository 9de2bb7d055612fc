// SPDX-License-Identifier: Apache-2.0
// Loads pages and dialogs in each look and fails on any warning, clipped text, small target or unreachable
// Stop.
#pragma once

#include "tests/looks/scenes.h"

namespace campanel::looks {

// Returns the exit code for main().
[[nodiscard]] int checkLooks(const QList<Look>& looks, const QList<Scene>& scenes);

} // namespace campanel::looks
