// SPDX-License-Identifier: Apache-2.0
// Every page and dialog of the panel as named screens, each with the touches that open it.
#pragma once

#include "tests/looks/test_window.h"

#include <QList>

#include <functional>

namespace campanel::looks {

struct Screen {
    QString name; // "motion", "keypad" ...
    std::function<void(TestWindow&)> enter;
    bool keepsUsers = false; // with the users of the previous screen, if it has any
};

// The screens with this end of their name are those of somebody who may only look.
inline constexpr QLatin1StringView lockedSuffix("-padlocks");

[[nodiscard]] const QList<Screen>& allScreens();

// Returns every combination of language, theme, size, with and without gloves.
[[nodiscard]] QList<Variant> allVariants();

// Return those that match one of the comma-separated shell patterns ("run*,motion"). For variants, "usual"
// means every language and size in the light theme. In the other themes it means the variants that their
// colors could change; gloves and longer texts are added.
[[nodiscard]] QList<Variant> variantsNamed(const QString& patterns);
[[nodiscard]] QList<Screen> screensNamed(const QString& patterns);

// Enters the screen from any present state of the window.
void enterScreen(TestWindow& window, const Screen& screen);

} // namespace campanel::looks
