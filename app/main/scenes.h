// SPDX-License-Identifier: Apache-2.0
// Every page and dialog of the panel as named scenes, each with the touches that lead to it.
#pragma once

#include "app/main/stage.h"

#include <QList>

#include <functional>

namespace campanel::panel {

struct Scene {
    QString name; // "motion", "keypad" ...
    std::function<void(Stage&)> enter;
};

[[nodiscard]] const QList<Scene>& allScenes();

// What the self-test and a capture look at: every language and size in the light theme, in the others what
// their colors could change; gloves, and texts that are longer.
[[nodiscard]] QList<Look> usualLooks();

// Patterns as of a shell ("run*"). Without one: all; of the looks the usual ones unless it is to be every
// one.
struct Selection {
    QString looks;
    QString scenes;
    bool isEveryLook = false; // every language in every theme at every size, with gloves and without
};

[[nodiscard]] QList<Look> looksOf(const Selection& selection);
[[nodiscard]] QList<Scene> scenesOf(const Selection& selection);

// From wherever the stage is to the scene.
void enterScene(Stage& stage, const Scene& scene);

} // namespace campanel::panel
