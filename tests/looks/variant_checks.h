// SPDX-License-Identifier: Apache-2.0
// Loads pages and dialogs in each variant and fails on any warning, clipped text, small target or unreachable
// Stop.
#pragma once

#include "tests/looks/screens.h"

namespace campanel::looks {

// The screens of a machine without a fault: on them nothing is red or amber.
[[nodiscard]] QStringList calmScreens();

// Returns the exit code for main().
[[nodiscard]] int checkVariants(const QList<Variant>& variants, const QList<Screen>& screens);

} // namespace campanel::looks
