// SPDX-License-Identifier: Apache-2.0
// The font families of the panel, and the check for their packages: without them the screen displays squares.
#pragma once

#include <QStringList>

namespace campanel::shell {

// Sets the text families as the default font. Call it in the GUI thread, after QGuiApplication is created.
void applyFonts();

// Returns true when one of the panel's fonts has this letter; without it the screen shows a box.
[[nodiscard]] bool hasGlyph(char32_t letter);

// Returns one sentence for each missing family, with the package to install.
[[nodiscard]] QStringList missingFonts();

} // namespace campanel::shell
