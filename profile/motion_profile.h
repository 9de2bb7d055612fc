// SPDX-License-Identifier: Apache-2.0
// A profile pieced together from laws: position, velocity, acceleration and jerk as pure functions of time.
// Position is exact, by the laws' closed integrals; nothing is integrated numerically.
#pragma once

#include "profile/law.h"

#include <cstddef>
#include <span>
#include <vector>

namespace campanel::profile {

struct MotionPoint {
    double positionMm = 0;
    double velocityMmPerS = 0;
    double accelerationMmPerS2 = 0;
    double jerkMmPerS3 = 0;
};

// A stretch of time in which the speed goes from v0 to v1. Without a law the speed is constant.
struct Segment {
    double startS = 0;
    double durationS = 0;
    double startPositionMm = 0;
    double startVelocityMmPerS = 0;
    double endVelocityMmPerS = 0;
    const Law* law = nullptr;
    LawParameters parameters{};
    bool isMirrored = false; // the law runs backwards in time, from its end to its beginning

    [[nodiscard]] double endS() const { return startS + durationS; }
    [[nodiscard]] MotionPoint at(double timeS) const;
};

class MotionProfile {
public:
    // Appends a stretch of constant speed, or a ramp. Time, position continue where the last one ended.
    void addConstant(double durationS, double velocityMmPerS);
    void addRamp(double durationS, double fromMmPerS, double toMmPerS, const Law& law,
                 const LawParameters& parameters, bool isMirrored);

    [[nodiscard]] double durationS() const;
    // timeS is clamped to [0, durationS]. At a joint of two segments the later one answers.
    [[nodiscard]] MotionPoint at(double timeS) const;
    // When a profile that never runs backwards reaches this position: the guess itself where it already is
    // there, else to within 1e-10 s.
    [[nodiscard]] double timeAt(double positionMm, double guessS) const;
    [[nodiscard]] std::span<const Segment> segments() const { return m_segments; }

private:
    void append(Segment segment);

    std::vector<Segment> m_segments;
};

} // namespace campanel::profile
