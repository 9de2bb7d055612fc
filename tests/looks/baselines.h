// SPDX-License-Identifier: Apache-2.0
// Pictures that a person has looked at and approved, and what is on the screen today.
#pragma once

#include <QString>

namespace campanel::looks {

// Captures into `folder` what the baselines show and compares. Names each picture that differs, with where,
// and writes "different-NAME" beside it. With `isUpdating` what was captured takes their place instead. A
// baseline of a scene or look that there is not is an error. The exit code for main().
[[nodiscard]] int compareWithBaselines(const QString& folder, const QString& baselines, bool isUpdating);

} // namespace campanel::looks
