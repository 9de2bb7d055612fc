// SPDX-License-Identifier: Apache-2.0
// Checks of what is on the screen, computed from the scene: no text clipped, cut off, over another or
// too pale, no touch target too small.
#pragma once

#include "tests/looks/contrast.h"

#include <QStringList>

class QImage;
class QQuickItem;

namespace campanel::looks {

struct SceneLimits {
    double touchPx = 0; // 12 mm, in glove mode 15 mm
    double letterPx =
        0; // 12 mm, for the keys of the keyboards with letters: ten of 15 mm are wider than a 7 inch screen
    double commandPx = 0; // 18 mm, for Start and Stop; in glove mode 22.5 mm
    TextContrast contrast;
};

// One sentence for each fault below `root`; only the uppermost layer (keypad, else dialog, else page) is
// looked at. `picture` is the scene as drawn; texts are compared with the pixels behind them.
[[nodiscard]] QStringList checkScene(QQuickItem& root, const SceneLimits& limits, const QImage& picture);

} // namespace campanel::looks
