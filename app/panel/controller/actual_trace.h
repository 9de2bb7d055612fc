// SPDX-License-Identifier: Apache-2.0
// The measured curve over one cycle, drawn like a chart recorder: each new point replaces the points of the
// previous cycle that the pen has passed.
#pragma once

#include <QList>
#include <QPointF>

#include <cstdint>

namespace campanel::panel {

class ActualTrace {
public:
    static constexpr int maxPoints = 1000;

    struct Sample {
        std::uint32_t cycle = 0; // counts the cycles completed
        double share = 0;        // 0..1 within the cycle
        double value = 0;
    };

    // Adds a point at share * durationS.
    void add(const Sample& sample, double durationS);
    void clear();
    [[nodiscard]] const QList<QPointF>& points() const { return m_points; } // ascending in x

private:
    void erase(double after, double upTo);

    QList<QPointF> m_points;
    Sample m_pen; // the last one that was drawn
};

} // namespace campanel::panel
