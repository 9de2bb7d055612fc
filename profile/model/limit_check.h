// SPDX-License-Identifier: Apache-2.0
// Compares the peaks of a motion with the limits of a machine, for every kind of program. A kind lists its
// comparisons.
#pragma once

#include "profile/model/machine.h"
#include "profile/model/motion_profile.h"
#include "profile/model/refusal.h"
#include "profile/model/torque.h"

#include <cstdint>
#include <span>
#include <vector>

namespace campanel::profile {

// The largest magnitudes of a motion and the times at which they are reached.
struct Peaks {
    double speedMmPerS = 0;
    double speedTimeS = 0;
    double motorRpm = 0;
    double pulseFrequencyHz = 0;
    double accelerationMmPerS2 = 0;
    double accelerationTimeS = 0;
    AccelerationExtremes extremes; // empty for a motion without a known inertia
    double torqueNm = 0;           // NaN where no inertia is known
    double torqueTimeS = 0;
    double rmsTorqueNm = 0; // over the whole motion; NaN where no inertia is known
    double jerkMmPerS3 = 0; // infinite where the acceleration has a step, also at the ends
};

namespace detail {

// The relative amount by which a value may exceed a limit: the rounding of a value that meets it exactly.
inline constexpr double limitTolerance = 1e-9;

// The quantity of the motion that a limit bounds. Rate: the cycle as a whole, without a place in it. Window:
// the limit is a minimum that the synchronous window must reach.
enum class Bounded : std::uint8_t { Rate, Speed, Acceleration, Torque, Window };

struct LimitComparison {
    Limit limit = Limit::MotorSpeed;
    Field field = Field::MaxMotorRpm; // the machine's limit
    double actual = 0;
    double allowed = 0;
    Bounded bounded = Bounded::Speed;
    double allowedInMotion = 0; // the limit as a rate, a speed in mm/s or an acceleration in mm/s^2
    TimeSpan window{};          // the place of a Window
    TorqueLoad load{};          // the load of a Torque
};

// Compares the peak of the torque with its limit.
[[nodiscard]] LimitComparison compareTorque(const Peaks& peaks, const Machine& machine,
                                            const TorqueLoad& load);

// Compares the RMS torque with the rated torque; without a limit while either is unknown.
[[nodiscard]] LimitComparison compareRmsTorque(const Peaks& peaks, const Machine& machine);

// Returns true when the peak exceeds the limit. The comparison is in the motion's own quantity, like the
// spans: beside a large friction a small torque would be lost in the tolerance.
[[nodiscard]] bool isBroken(const LimitComparison& comparison, const Peaks& peaks);

// Returns every exceeded limit with its peak, the place of the peak and the time spans, in the order of the
// comparisons. Suggestions are missing; each kind of program adds its own.
[[nodiscard]] std::vector<Refusal> brokenLimits(std::span<const LimitComparison> comparisons,
                                                const MotionProfile& motion, const Peaks& peaks);

// Returns the times between which the acceleration of a segment is monotone, including the ends.
[[nodiscard]] std::vector<double> accelerationTurns(const Segment& segment);
// Returns the times between which the speed of a segment is monotone, including the ends.
[[nodiscard]] std::vector<double> speedTurns(const Segment& segment);
// A part of a segment that moves in one direction, with a monotone acceleration.
struct DirectedPart {
    double fromS = 0;
    double toS = 0;
    double direction = 0; // 1, -1, or 0 where it stands
};
[[nodiscard]] std::vector<DirectedPart> directedParts(const Segment& segment);
// Returns true when the speed of the segment changes.
[[nodiscard]] bool hasAcceleration(const Segment& segment);

} // namespace detail

} // namespace campanel::profile
