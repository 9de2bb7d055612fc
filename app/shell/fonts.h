// SPDX-License-Identifier: Apache-2.0
// The font families of the panel, and the check that their packages are installed: without them the screen
// shows squares.
#pragma once

#include <QStringList>

namespace campanel::panel {

// Makes the text families the default font. GUI thread, after QGuiApplication is made.
void applyFonts();

// One sentence for each family that is not installed, naming the package to install.
[[nodiscard]] QStringList missingFonts();

} // namespace campanel::panel
