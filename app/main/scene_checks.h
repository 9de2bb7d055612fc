// SPDX-License-Identifier: Apache-2.0
// Checks of what is on the screen, computed from the scene: no text clipped, cut off, over another or
// too pale, no touch target too small.
#pragma once

#include <QStringList>

class QImage;
class QQuickItem;

namespace campanel::panel {

struct TouchLimits {
    double touchPx = 0;   // 12 mm
    double commandPx = 0; // 18 mm, for Start and Stop
};

// One sentence for each fault below `root`; only the uppermost layer (keypad, else dialog, else page) is
// looked at. `picture` is the scene as drawn; texts are compared with the pixels behind them.
[[nodiscard]] QStringList checkScene(QQuickItem& root, const TouchLimits& limits, const QImage& picture);

} // namespace campanel::panel
