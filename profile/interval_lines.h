// SPDX-License-Identifier: Apache-2.0
// A speed curve as few straight lines: the plan of a table of intervals before its pulses are whole.
#pragma once

#include "profile/link_path.h"
#include "profile/speed_curve.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace campanel::profile::detail {

struct LineRules {
    double toleranceHz = 0;
    double leastHz = 0; // where the curve is at rest or slower
    double mostHz = 0;
};

class IntervalLines {
public:
    IntervalLines(const SpeedCurve& curve, const LineRules& rules);

    // No fewer lines keep within the tolerance; 0 when none do, or only with more than mostLines.
    [[nodiscard]] std::size_t fewest(std::size_t mostLines);

    // Ends of at most so many lines that make the curve's distance in its time, with the smallest error
    // found. evenness 1: the error evens out over each bend of the curve, for which the lines need a quarter
    // of the tolerance; 0: all of it counts. Nothing when there are none.
    [[nodiscard]] std::optional<std::vector<PathPoint>> find(std::size_t lines, double evenness,
                                                             LastLink last);

private:
    struct Tried {
        std::vector<PathPoint> knots;
        double errorHz = 0;
        double missingHz = 0; // by which their mean speed is too low
    };
    void lay(double errorHz, double evenness, double shiftHz);
    std::optional<std::vector<PathPoint>> within(std::size_t lines, double errorHz, double evenness,
                                                 double shiftHz);
    std::optional<Tried> tightest(std::size_t lines, double evenness, double shiftHz);

    const SpeedCurve& m_curve;
    LineRules m_rules;
    std::vector<Gate> m_channel;
    LastLink m_last = LastLink::LeastTurn;
};

} // namespace campanel::profile::detail
