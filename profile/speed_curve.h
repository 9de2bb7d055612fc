// SPDX-License-Identifier: Apache-2.0
// A profile that goes one way, as pulses over time in a table fine enough to search in: the compiler of
// intervals asks it some hundred thousand times.
#pragma once

#include "profile/motion_profile.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace campanel::profile::detail {

struct CurveSample {
    double timeS = 0;
    double pulses = 0;  // from the beginning, rising
    double speedHz = 0; // not negative
    double bend = 0; // 1 where the speed's curve is hollow from above, -1 where it is domed, 0 where straight
};

class SpeedCurve {
public:
    // The motion's magnitude, at pulsesPerMm. A motion that ends at rest is stretched to whole pulses, by
    // less than half a pulse in all; one that ends moving goes on at its speed up to the next whole pulse.
    SpeedCurve(const MotionProfile& motion, double pulsesPerMm);

    [[nodiscard]] const std::vector<CurveSample>& samples() const { return m_samples; }
    // Indices of the samples where two stretches of the motion meet, the later one's.
    [[nodiscard]] const std::vector<std::size_t>& joints() const { return m_joints; }
    [[nodiscard]] std::int64_t wholePulses() const { return m_wholePulses; }
    [[nodiscard]] double stretch() const { return m_stretch; }
    [[nodiscard]] double durationS() const { return m_samples.back().timeS; } // of the motion
    // When so many pulses have passed; the last one when the motion ends, or is continued to it.
    [[nodiscard]] double timeAt(std::int64_t pulses) const;
    [[nodiscard]] double speedAt(double timeS) const; // of the later stretch at a joint
    // Index of the last sample that is not later.
    [[nodiscard]] std::size_t indexAt(double timeS) const;

private:
    std::vector<CurveSample> m_samples;
    std::vector<std::size_t> m_joints;
    std::int64_t m_wholePulses = 0;
    double m_stretch = 1;
};

} // namespace campanel::profile::detail
