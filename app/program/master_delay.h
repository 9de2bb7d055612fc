// SPDX-License-Identifier: Apache-2.0
// Measures the delay that is left between an encoder that leads the line and the knife: the film that has
// passed at a cut is delay x speed. A line is fitted through the cuts at two speeds; its slope is the delay.
#pragma once

#include <deque>
#include <optional>

namespace campanel::program {

class MasterDelay {
public:
    // Above this standard error nothing is offered.
    static constexpr double maxMarginMs = 0.1;
    static constexpr int minCuts = 10;      // at each of the two speeds
    static constexpr double minRatio = 1.2; // of the two speeds

    struct Delay {
        double ms = 0.0;       // to add to the present delay
        double marginMs = 0.0; // standard error of the slope
    };

    // Adds a cut: the measured speed of the film, and the film that had passed beyond the cut.
    void add(double speedMmPerS, double lagMm);
    [[nodiscard]] int cuts() const { return static_cast<int>(m_cuts.size()); }
    // Returns true when there are enough cuts at the slowest speed.
    [[nodiscard]] bool hasOneSpeed() const;
    // Returns nothing before there are enough cuts at two speeds.
    [[nodiscard]] std::optional<Delay> measured() const;
    // Returns the delay to enter instead of `presentMs`, within the register's range; nothing while the
    // margin is too large, or when the present one is within the margin.
    [[nodiscard]] std::optional<double> offered(double presentMs) const;

private:
    struct Cut {
        double speed = 0.0;
        double lag = 0.0;
    };

    std::deque<Cut> m_cuts;
};

} // namespace campanel::program
