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

// Every language, theme and size.
[[nodiscard]] QList<Look> allLooks();

// From wherever the stage is to the scene.
void enterScene(Stage& stage, const Scene& scene);

} // namespace campanel::panel
