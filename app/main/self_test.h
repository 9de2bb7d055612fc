// SPDX-License-Identifier: Apache-2.0
// Loads every page and dialog in every language, theme and size, and fails on any warning, clipped text,
// small target or unreachable Stop.
#pragma once

#include "app/main/scenes.h"

namespace campanel::panel {

// The exit code for main(); a selection that selects nothing is a fault.
[[nodiscard]] int selfTest(const Selection& selection);

} // namespace campanel::panel
