// SPDX-License-Identifier: Apache-2.0
// The measured curve over one cycle, drawn as a recorder's pen does: each new point takes the place of those
// of the cycle before that the pen has passed.
#pragma once

#include <QList>
#include <QPointF>

#include <cstdint>

namespace campanel::machine {

class ActualTrace {
public:
    static constexpr int mostPoints = 1000;

    struct Sample {
        std::uint32_t cycle = 0; // counts the cycles completed
        double share = 0;        // of the cycle, 0..1
        double value = 0;
    };

    // Points are at share * durationS.
    void add(const Sample& sample, double durationS);
    void clear();
    [[nodiscard]] const QList<QPointF>& points() const { return m_points; } // ascending in x

private:
    void erase(double after, double upTo);

    QList<QPointF> m_points;
    Sample m_pen; // the last one that was drawn
};

} // namespace campanel::machine
