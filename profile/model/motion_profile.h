// SPDX-License-Identifier: Apache-2.0
// A profile composed of laws: position, velocity, acceleration and jerk as pure functions of time. The
// position is exact, by the closed integrals of the laws, without numerical integration.
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
    Constant,     // speed
    Ramp,         // from the start to the end speed by a speed law
    Displacement, // by a displacement law: s = startPosition + startVelocity t + distance g(t / duration)
    Polynomial,   // of time, up to the fifth degree: start speed, acceleration, jerk, snap, constant crackle
};

// A segment in time.
struct Segment {
    SegmentForm form = SegmentForm::Constant;
    double startS = 0;
    double durationS = 0;
    double startPositionMm = 0;
    double startVelocityMmPerS = 0;
    double endVelocityMmPerS = 0;        // Ramp
    double distanceMm = 0;               // Displacement
    double startAccelerationMmPerS2 = 0; // Polynomial
    double jerkMmPerS3 = 0;              // Polynomial: at its start
    double snapMmPerS4 = 0;              // Polynomial: at its start; the derivative of the jerk
    double crackleMmPerS5 = 0;           // Polynomial: the derivative of the snap
    const Law* law = nullptr;            // Ramp, Displacement
    LawParameters parameters{};
    bool isMirrored = false; // Ramp: the law runs backward in time, from its end to its start
    // Displacement: the part of the law that the segment covers. distanceMm is that of the whole law.
    double lawFrom = 0;
    double lawTo = 1;

    [[nodiscard]] double endS() const { return startS + durationS; }
    // Returns the duration of the whole law, of which the segment may be a part.
    [[nodiscard]] double lawDurationS() const { return durationS / (lawTo - lawFrom); }
    [[nodiscard]] MotionPoint at(double timeS) const;
};

class MotionProfile {
public:
    // Appends a segment of constant speed, or a ramp. Time and position continue from the last segment.
    void addConstant(double durationS, double velocityMmPerS);
    void addRamp(double durationS, double fromMmPerS, double toMmPerS, const Law& law,
                 const LawParameters& parameters, bool isMirrored);

    // Appends distanceMm by a displacement law, added to a constant speed. A rest-to-rest move has
    // velocityMmPerS = 0.
    void addDisplacement(double durationS, double distanceMm, const Law& law, const LawParameters& parameters,
                         double velocityMmPerS = 0);
    // Appends a segment of constant jerk; jerk 0 gives constant acceleration.
    void addCubic(double durationS, double velocityMmPerS, double accelerationMmPerS2, double jerkMmPerS3);
    // Appends a polynomial of time or a part of a displacement law. The segment's own start is ignored.
    void addPart(Segment segment) { append(segment); }
    // Sets the position at which the next segment starts; 0 unless set before the first one.
    void setStartPosition(double positionMm) { m_startPositionMm = positionMm; }

    [[nodiscard]] double durationS() const;
    // Returns the point at timeS, clamped to [0, durationS]. At a joint it belongs to the later segment.
    [[nodiscard]] MotionPoint at(double timeS) const;
    // Returns the time at which a profile that never reverses reaches this position, to within 1e-10 s.
    // Returns the guess itself when it is exact.
    [[nodiscard]] double timeAt(double positionMm, double guessS) const;
    [[nodiscard]] std::span<const Segment> segments() const { return m_segments; }

private:
    void append(Segment segment);

    std::vector<Segment> m_segments;
    double m_startPositionMm = 0;
};

} // namespace campanel::profile
