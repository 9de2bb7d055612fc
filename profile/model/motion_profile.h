// SPDX-License-Identifier: Apache-2.0
// A profile pieced together from laws: position, velocity, acceleration and jerk as pure functions of time.
// Position is exact, by the laws' closed integrals; nothing is integrated numerically.
#pragma once

#include "profile/model/law.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace campanel::profile {

struct MotionPoint {
    double positionMm = 0;
    double velocityMmPerS = 0;
    double accelerationMmPerS2 = 0;
    double jerkMmPerS3 = 0;
};

enum class SegmentForm : std::uint8_t {
    Constant,     // of speed
    Ramp,         // of the speed by a speed law, from the start to the end speed
    Displacement, // by a displacement law: s = startPosition + startVelocity t + distance g(t / duration)
    Cubic,        // a third-degree polynomial of time: start speed, acceleration and constant jerk
};

// A stretch of time.
struct Segment {
    SegmentForm form = SegmentForm::Constant;
    double startS = 0;
    double durationS = 0;
    double startPositionMm = 0;
    double startVelocityMmPerS = 0;
    double endVelocityMmPerS = 0;        // Ramp
    double distanceMm = 0;               // Displacement
    double startAccelerationMmPerS2 = 0; // Cubic
    double jerkMmPerS3 = 0;              // Cubic
    const Law* law = nullptr;            // Ramp, Displacement
    LawParameters parameters{};
    bool isMirrored = false; // Ramp: the law runs backwards in time, from its end to its beginning

    [[nodiscard]] double endS() const { return startS + durationS; }
    [[nodiscard]] MotionPoint at(double timeS) const;
};

class MotionProfile {
public:
    // Appends a stretch of constant speed, or a ramp. Time, position continue where the last one ended.
    void addConstant(double durationS, double velocityMmPerS);
    void addRamp(double durationS, double fromMmPerS, double toMmPerS, const Law& law,
                 const LawParameters& parameters, bool isMirrored);

    // Appends distanceMm by a displacement law, on top of a constant speed. A law as a rest-to-rest move has
    // velocityMmPerS = 0.
    void addDisplacement(double durationS, double distanceMm, const Law& law, const LawParameters& parameters,
                         double velocityMmPerS = 0);
    // Appends a stretch of constant jerk; with jerk 0 of constant acceleration.
    void addCubic(double durationS, double velocityMmPerS, double accelerationMmPerS2, double jerkMmPerS3);
    // Where the next stretch begins; 0 unless set before the first one.
    void setStartPosition(double positionMm) { m_startPositionMm = positionMm; }

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
    double m_startPositionMm = 0;
};

} // namespace campanel::profile
