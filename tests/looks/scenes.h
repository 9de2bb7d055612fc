// SPDX-License-Identifier: Apache-2.0
// Every page and dialog of the panel as named scenes, each with the touches that open it.
#pragma once

#include "tests/looks/stage.h"

#include <QList>

#include <functional>

namespace campanel::looks {

struct Scene {
    QString name; // "motion", "keypad" ...
    std::function<void(Stage&)> enter;
};

[[nodiscard]] const QList<Scene>& allScenes();

// Returns every combination of language, theme, size, with and without gloves.
[[nodiscard]] QList<Look> allLooks();

// Return those that match one of the comma-separated shell patterns ("run*,motion"). For looks, "usual" means
// every language and size in the light theme. In the other themes it means
// the looks that their colors could change; gloves and longer texts are added.
[[nodiscard]] QList<Look> looksNamed(const QString& patterns);
[[nodiscard]] QList<Scene> scenesNamed(const QString& patterns);

// Enters the scene from any present state of the stage.
void enterScene(Stage& stage, const Scene& scene);

} // namespace campanel::looks
