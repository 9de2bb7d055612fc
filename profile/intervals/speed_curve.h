// SPDX-License-Identifier: Apache-2.0
// A profile that goes one way, as pulses over time in a table fine enough to search in: the compiler of
// intervals asks it some hundred thousand times.
#pragma once

#include "profile/model/motion_profile.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace campanel::profile::detail {

struct CurveSample {
    double timeS = 0;
    double pulses = 0;  // from the beginning, rising
    double speedHz = 0; // not negative
    double bend = 0; // 1 where the speed's curve is hollow from above, -1 where it is domed, 0 where straight
    double bulgeHz = 0; // the farthest that the curve can leave the straight lines to its neighbors
};

// Bounds the jerk of a segment wherever its acceleration does not step.
[[nodiscard]] double jerkBound(const Segment& segment);

class SpeedCurve {
public:
    // The motion's magnitude, at pulsesPerMm, in about so many samples; there are samples on both sides of
    // each step of the acceleration. A motion that ends at rest is stretched to whole pulses, by less than
    // half a pulse in all; one that ends moving goes on at its speed up to the next whole pulse.
    SpeedCurve(const MotionProfile& motion, double pulsesPerMm, int sampleCount);

    [[nodiscard]] const std::vector<CurveSample>& samples() const { return m_samples; }
    // Indices of the samples at which the acceleration may step.
    [[nodiscard]] const std::vector<std::size_t>& corners() const { return m_corners; }
    [[nodiscard]] std::int64_t wholePulses() const { return m_wholePulses; }
    [[nodiscard]] double stretch() const { return m_stretch; }
    [[nodiscard]] double durationS() const { return m_samples.back().timeS; } // of the motion
    [[nodiscard]] double fastestHz() const { return m_fastestHz; }
    [[nodiscard]] double steepestHzPerS() const { return m_steepestHzPerS; }
    [[nodiscard]] bool beginsAtRest() const { return m_samples.front().speedHz <= m_restHz; }
    [[nodiscard]] bool endsAtRest() const { return m_samples.back().speedHz <= m_restHz; }
    // When so many pulses have passed; the last one when the motion ends, or is continued to it.
    [[nodiscard]] double timeAt(std::int64_t pulses) const;
    [[nodiscard]] double speedAt(double timeS) const; // of the later stretch at a joint
    // Index of the last sample that is not later.
    [[nodiscard]] std::size_t indexAt(double timeS) const;

private:
    void sample(const Segment& segment, int pieces, double startMm, double pulsesPerMm);
    void fillNearby();

    std::vector<CurveSample> m_samples;
    std::vector<std::size_t> m_corners;
    std::vector<std::size_t> m_nearby; // samples, where indexAt() begins to look
    std::int64_t m_wholePulses = 0;
    double m_stretch = 1;
    double m_fastestHz = 0;
    double m_steepestHzPerS = 0;
    double m_restHz = 0; // a speed not above it is none
};

} // namespace campanel::profile::detail
