// SPDX-License-Identifier: Apache-2.0
// A profile without reversal as pulses over time, in a table for fast searches: the interval compiler queries
// it several hundred thousand times.
#pragma once

#include "profile/model/motion_profile.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace campanel::profile::detail {

struct CurveSample {
    double timeS = 0;
    double pulses = 0;  // from the start, ascending
    double speedHz = 0; // not negative
    double bend = 0;    // 1 where the speed curve is convex, -1 where it is concave, 0 where it is straight
    double bulgeHz = 0; // maximum deviation of the curve from the straight lines to its neighbors
};

// Returns a bound of the jerk of a segment wherever its acceleration does not step.
[[nodiscard]] double jerkBound(const Segment& segment);

class SpeedCurve {
public:
    // Samples the magnitude of the motion at pulsesPerMm with about `sampleCount` samples; each step of the
    // acceleration has samples on both sides. A motion that ends at rest is stretched to whole pulses, by
    // less than half a pulse. A motion that ends moving continues at its speed up to the next whole pulse.
    SpeedCurve(const MotionProfile& motion, double pulsesPerMm, int sampleCount);

    [[nodiscard]] const std::vector<CurveSample>& samples() const { return m_samples; }
    // Returns the indices of the samples at which the acceleration may step.
    [[nodiscard]] const std::vector<std::size_t>& corners() const { return m_corners; }
    [[nodiscard]] std::int64_t wholePulses() const { return m_wholePulses; }
    [[nodiscard]] double stretch() const { return m_stretch; }
    [[nodiscard]] double durationS() const { return m_samples.back().timeS; } // duration of the motion
    [[nodiscard]] double fastestHz() const { return m_fastestHz; }
    [[nodiscard]] double steepestHzPerS() const { return m_steepestHzPerS; }
    [[nodiscard]] bool beginsAtRest() const { return m_samples.front().speedHz <= m_restHz; }
    [[nodiscard]] bool endsAtRest() const { return m_samples.back().speedHz <= m_restHz; }
    // Returns the time at which this many pulses have passed. The last pulse comes when the motion, or its
    // continuation, ends.
    [[nodiscard]] double timeAt(std::int64_t pulses) const;
    [[nodiscard]] double speedAt(double timeS) const; // at a joint: the later segment
    // Returns the index of the last sample that is not later.
    [[nodiscard]] std::size_t indexAt(double timeS) const;

private:
    void sample(const Segment& segment, int pieces, double startMm, double pulsesPerMm);
    void fillNearby();

    std::vector<CurveSample> m_samples;
    std::vector<std::size_t> m_corners;
    std::vector<std::size_t> m_nearby; // start indices of the search in indexAt()
    std::int64_t m_wholePulses = 0;
    double m_stretch = 1;
    double m_fastestHz = 0;
    double m_steepestHzPerS = 0;
    double m_restHz = 0; // a speed up to this value counts as rest
};

} // namespace campanel::profile::detail
