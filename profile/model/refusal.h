// SPDX-License-Identifier: Apache-2.0
// The reason why a program is refused, as a value: the limit, by how much it is exceeded, where in the cycle
// and what would be accepted. The fields hold everything a translated sentence needs.
#pragma once

#include "profile/model/fields.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace campanel::profile {

enum class Limit : std::uint8_t {
    FieldRange,        // the value of `field` is outside its range (or not a number)
    PinnedPair,        // the two pinned fields are not two different ones of L, n, v_a, v_b
    LawUnknown,        // the law does not exist, or is not for this kind of program
    LawParameter,      // a parameter of the law is outside its range
    RatioOrder,        // k1 > k2 > k3 > k4 > 1 does not hold; `allowed` is the neighbor that sets the limit
    StrokeCannotClose, // the film would take more than the knife's stroke: v_a (or the cycle time) would be
                       // negative
    MotorSpeed,
    KnifeAcceleration,
    PulseFrequency,
    MachineRate,
    RowCapacity,  // the table has more rows than the controller holds
    TooFewPulses, // less than one pulse per cycle
    AxisAcceleration,
    MotorTorque,
    NoMotion,         // no motion: no distance, no change of speed, no master speed
    DistanceTooShort, // for the two speeds and the law; `allowed` is the minimum
    DistanceSign,     // the distance has the opposite direction of the speeds
    KnotCount,        // too few or too many knots; `allowed` is the nearest valid number
    KnotOrder,        // knot `index` is not after the previous one
    KnotSpacing,      // knots `index` - 1 and `index` are closer than `allowed` degrees
    KnotRange,        // knot `index` lies outside 0..360 degrees, or the slave's range
    KnotEnds,         // the first is not at 0 or the last not at 360 degrees
    Overshoot,        // the spline exceeds the range of its knots by more than a tenth of their span
    WrapJump,         // the speed jumps at the wrap
    StageOrder,       // a press stage ends before it begins: `field` must exceed `allowed`
    ForceOrder,       // `field` must not exceed `allowed`
    MasterTooFast,    // the slave would need more pulses in one update than the output stage gives
    TableRange,       // a table value that its register cannot hold
    Reversal,         // the motion reverses within a cycle, and intervals have one direction
    SpeedError,       // intervals cannot keep it with whole pulses; `allowed` can be kept
    RampTooLong,      // the ramp of a press stage is longer than a row holds
    JawWindow,        // the knife leaves the film's speed while the jaws are in contact
    SealTime,         // the jaws are in contact for less than the film needs
    RmsTorque,        // the motor would overheat: the RMS torque of a cycle exceeds the rated torque
    NaturalFrequency, // the cycle is faster than the natural frequency of the shaft
    SegmentCount,     // too few or too many segments; `allowed` is the nearest valid number
    SegmentRange,     // a value of segment `index` is out of range; `lawParameter` names it
    SegmentWidth,     // segment `index` is narrower than `allowed` degrees
    SegmentOverlap,   // segment `index` begins before the one before it ends, at `allowed`
    SegmentGap,       // segment `index` begins after the one before it ends, at `allowed`
    SegmentEnds,      // the first segment does not begin at 0, or the last one does not end at 360 degrees
    SegmentMotion,    // the motion of segment `index` is unknown
    JointJump,        // the speed jumps where segment `index` begins; index 0: at the wrap
};

// Returns the stable id of a limit, for logs and machine-readable output.
[[nodiscard]] std::string_view limitId(Limit limit);
// Returns "acceleration", for the end of a sentence; empty for a limit that is never named so.
[[nodiscard]] std::string_view limitName(Limit limit);

// A value of one input that, changed alone, makes the whole recipe feasible; the nearest one on the field's
// grid. With `ratios` the synchronous window is widened: k1..k4 change together, and the field with them.
struct Suggestion {
    Field field = Field::BagLength;
    double value = 0;
    std::optional<std::array<double, 4>> ratios{};
};

// The rate that is possible with the gentlest ratios, in place of ratios that were set by hand.
struct RampOffer {
    double rateBagsPerMin = 0;
    bool isLonger = true; // the shorter of the two ramps becomes longer
};

struct TimeSpan {
    double fromS = 0;
    double toS = 0;
};

struct Refusal {
    Limit limit = Limit::FieldRange;
    Field field = Field::BagLength; // the wrong field, or the exceeded limit of the machine
    double actual = 0;
    double allowed = 0;
    std::string_view unit;
    std::optional<double> timeS;    // place of the maximum in the cycle
    std::optional<double> angleDeg; // the same as an angle of the master, 360 degrees per cycle
    std::vector<TimeSpan> brokenDuring;
    std::vector<Suggestion> nearest; // best first; empty when no single input can correct it
    std::string_view lawParameter;   // LawParameter: id of the parameter; SegmentRange: "from", "to", "end",
                                     // "speed", "acceleration"
    std::optional<RampOffer> ramps;  // only for a rotary cutter; empty when other ratios do not help
    int index = -1;                  // index from 0 of the knot or the segment, only for their limits
};

// Returns the ids and the numbers, for logs.
[[nodiscard]] std::string describe(const Refusal& refusal);

} // namespace campanel::profile
