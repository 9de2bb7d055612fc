// SPDX-License-Identifier: Apache-2.0
// What fingers do to a window of time: one moves it, two keep the times that they were put on.
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

    // Places of one or two fingers in px from the left edge of a canvas that is `widthPx` wide and shows
    // `window`. To be called whenever a finger comes or goes.
    void begin(const QList<double>& fingersPx, const Window& window, double widthPx);
    // The window that they ask for now. As many fingers as began.
    [[nodiscard]] Window moved(const QList<double>& fingersPx);
    // They have moved farther than a finger trembles.
    [[nodiscard]] bool hasMoved() const { return m_hasMoved; }

private:
    [[nodiscard]] double timeAt(double px) const;

    QList<double> m_fingersPx;
    Window m_window;
    double m_widthPx = 1;
    bool m_hasMoved = false;
};

} // namespace campanel::plot
