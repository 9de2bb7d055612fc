// SPDX-License-Identifier: Apache-2.0
// Estimates the dead time of the mark sensor from the marks of a producing machine. In a ramp the film is
// faster at one mark than at the one before, so that a late sensor makes their distance wrong by dead time x
// change of speed. A film that stays behind its roll when it speeds up makes it wrong by slip x change of
// acceleration; both are fitted together.
#pragma once

#include "modbus/map/mark_edges.h"

#include <optional>

namespace campanel::program {

struct DeadTime {
    double ms = 0.0;
    double marginMs = 0.0; // standard deviation
    double slipMm = 0.0;   // film behind its roll for each m/s^2
    int ramps = 0;         // distances that tell of it
};

// A sensor whose dead time is no longer the one that is entered.
struct SensorDrift {
    double enteredMs = 0.0;
    DeadTime learned;
};

inline constexpr double maxDeadTimeMs = 20.0;

// Returns the dead time to enter instead of `presentMs`, in steps of the register; nothing while it is within
// the margin.
[[nodiscard]] std::optional<double> offeredMs(double foundMs, double marginMs, double presentMs);

class DeadTimeEstimate {
public:
    // Above this margin nothing is offered.
    static constexpr double maxMarginMs = 0.1;

    // Adds an edge; call it for every edge in turn.
    void take(const modbus::MarkEdge& edge);
    // Another film: what was learned of the sensor stays.
    void startFilm();
    // Returns nothing while the margin is too large.
    [[nodiscard]] std::optional<DeadTime> estimate() const;
    // Returns offeredMs(); nothing while the margin is too large.
    [[nodiscard]] std::optional<double> offered(double presentMs) const;
    // Returns the dead time when it is farther from the entered one than the film notices, and than its
    // margin explains. `isKnown`: it was so before; it ends only well below. Nothing while none is entered.
    [[nodiscard]] std::optional<DeadTime> drift(double enteredMs, bool isKnown) const;

private:
    void takeGap(const modbus::MarkEdge& before, const modbus::MarkEdge& edge);
    void learnPitch(double gapMm);

    std::optional<modbus::MarkEdge> m_before;
    double m_pitchMm = 0.0;  // distance of the marks at constant speed, filtered
    double m_noiseMm2 = 0.0; // variance of the distances around it
    int m_steady = 0;        // distances that are in both
    // Sums over the distances in ramps, with y = distance - pitch, v = change of speed, a = of acceleration.
    double m_vv = 0.0;
    double m_va = 0.0;
    double m_aa = 0.0;
    double m_vy = 0.0;
    double m_ay = 0.0;
    int m_ramps = 0;
};

} // namespace campanel::program
