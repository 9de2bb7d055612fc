// SPDX-License-Identifier: Apache-2.0
// Gestures on a window of time: one finger moves it, two fingers keep the times under them.
#pragma once

#include <QList>

namespace campanel::plot {

class WindowGesture {
public:
    struct Window {
        double fromMs = 0;
        double toMs = 0;
    };

    static constexpr double slopPx = 12; // a finger that moves less is a tap

    // Starts with one or two fingers in px from the left edge of a canvas that is `widthPx` wide and displays
    // `window`. Call it whenever a finger comes or goes.
    void begin(const QList<double>& fingersPx, const Window& window, double widthPx);
    // Returns the requested window. The number of fingers must be that of begin().
    [[nodiscard]] Window moved(const QList<double>& fingersPx);
    // Returns true when they have moved farther than a tremor.
    [[nodiscard]] bool hasMoved() const { return m_hasMoved; }

private:
    [[nodiscard]] double timeAt(double px) const;

    QList<double> m_fingersPx;
    Window m_window;
    double m_widthPx = 1;
    bool m_hasMoved = false;
};

} // namespace campanel::plot
