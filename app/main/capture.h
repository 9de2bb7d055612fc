// SPDX-License-Identifier: Apache-2.0
// Writes every scene in every look as a PNG file, always the same picture for the same program.
#pragma once

#include <QString>

namespace campanel::panel {

// Files are named scene-theme-language-size.png. The exit code for main().
[[nodiscard]] int capture(const QString& folder);

} // namespace campanel::panel
