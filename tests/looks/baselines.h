// SPDX-License-Identifier: Apache-2.0
// Compares the screen with the approved pictures.
#pragma once

#include <QString>

namespace campanel::looks {

// Captures the baselines' screens into `folder` and compares them. Reports each different picture and the
// place, and writes "different-NAME" beside it. With `isUpdating` the captured pictures replace the
// baselines. A baseline of an unknown screen or variant is an error. Returns the exit code for main().
[[nodiscard]] int compareWithBaselines(const QString& folder, const QString& baselines, bool isUpdating);

} // namespace campanel::looks
