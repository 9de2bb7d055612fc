// SPDX-License-Identifier: Apache-2.0
// A sensor whose output follows some time behind what it sees: the electronics' own time and an input filter.
// The controller latches the axis when the output changes.
#pragma once

#include <cstdint>
#include <deque>
#include <random>

namespace campanel::controller {

struct SensorOptions {
    double delayMs = 0.0;    // of both sensors
    double scatterMs = 0.0;  // standard deviation from edge to edge
    double offLaterMs = 0.0; // the end of a mark or product comes later by this much
};

class LateSensor {
public:
    LateSensor(const SensorOptions& options, std::uint64_t seed);

    // Handles an edge within the next step: the axis was at `position` when it passed.
    void pass(double position, bool on) { m_passed.push_back({position, on}); }
    // Ends the step of an axis that ran evenly from `before` to `now`.
    void advance(double stepS, double before, double now);

    // `position` is that of the axis when the output changes.
    struct Edge {
        double position = 0.0;
        bool on = false;
    };
    // Returns false when no output changed.
    bool take(Edge& edge);

private:
    struct Pending {
        double dueS = 0.0;
        bool on = false;
    };
    [[nodiscard]] double delayS(bool on);

    SensorOptions m_options;
    std::mt19937_64 m_random;
    std::normal_distribution<double> m_normal;
    double m_timeS = 0.0;
    double m_lastDueS = 0.0;
    std::deque<Edge> m_passed;
    std::deque<Pending> m_pending;
    std::deque<Edge> m_edges;
};

} // namespace campanel::controller
