// SPDX-License-Identifier: Apache-2.0
// Writes each screen in each variant as a PNG file, reproducibly for the same program.
#pragma once

#include "tests/looks/screens.h"

namespace campanel::looks {

// Captures to files named by pictureName(). Returns the exit code for main().
[[nodiscard]] int capture(const QString& folder, const QList<Variant>& variants,
                          const QList<Screen>& screens);

// Returns "run-light-en-800x480.png".
[[nodiscard]] QString pictureName(const Screen& screen, const Variant& variant);

// Captures the pictures with a wanted name. Returns their number; nothing after an error, which went to
// stderr.
[[nodiscard]] std::optional<int> captureThose(const QString& folder, const QList<Variant>& variants,
                                              const QList<Screen>& screens,
                                              const std::function<bool(const QString& name)>& isWanted);

} // namespace campanel::looks
