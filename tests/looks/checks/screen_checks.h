// SPDX-License-Identifier: Apache-2.0
// Checks the screen contents computed from the screen: texts clipped, cut off, overlapping or too pale, and
// touch targets too small.
#pragma once

#include "tests/looks/checks/contrast.h"

#include <QStringList>

class QImage;
class QQuickItem;

namespace campanel::looks {

struct ScreenLimits {
    double touchPx = 0; // 12 mm, in glove mode 15 mm
    double letterPx =
        0; // 12 mm, for the letter keys of the keyboards: ten of 15 mm are wider than a 7 inch screen
    double commandPx = 0; // 18 mm, for Start and Stop; in glove mode 22.5 mm
    TextContrast contrast;
    double textPx = 0;   // the smallest readable text of the size class
    bool elides = false; // texts without room may be elided
};

// Returns a fault when a picture of the faultless machine has more than a few pixels in the colors of alarms:
// red and amber are for the abnormal alone.
[[nodiscard]] QStringList checkCalm(const QImage& picture);

// Returns one sentence for each fault below `root`, only for the uppermost layer (keypad, else dialog, else
// page). `picture` is the drawn screen; texts are compared with the pixels behind them.
[[nodiscard]] QStringList checkScreen(QQuickItem& root, const ScreenLimits& limits, const QImage& picture);

} // namespace campanel::looks
