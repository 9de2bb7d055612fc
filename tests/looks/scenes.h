// SPDX-License-Identifier: Apache-2.0
// Every page and dialog of the panel as named scenes, each with the touches that lead to it.
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

// Every language in every theme at every size, with gloves and without.
[[nodiscard]] QList<Look> allLooks();

// Those that one of the patterns names, as of a shell and with commas between them ("run*,motion"). Of looks
// the word "usual" names every language and size in the light theme, in the others what their colors could
// change, gloves, and texts that are longer.
[[nodiscard]] QList<Look> looksNamed(const QString& patterns);
[[nodiscard]] QList<Scene> scenesNamed(const QString& patterns);

// From wherever the stage is to the scene.
void enterScene(Stage& stage, const Scene& scene);

} // namespace campanel::looks
