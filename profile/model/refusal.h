// SPDX-License-Identifier: Apache-2.0
// Why a program is refused, as a value: which limit, by how much, where in the cycle and what would be
// accepted. Everything a translated sentence needs is in the fields; describe() is the English one.
#pragma once

#include "profile/model/fields.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace campanel::profile {

enum class Limit : std::uint8_t {
    FieldRange,   // the value of `field` is outside its range (or not a number)
    PinnedPair,   // the two pinned fields are not two different ones of L, n, v_a, v_b
    LawUnknown,   // no such law, or not one for this kind of program
    LawParameter, // a parameter of the law is outside its range
    RatioOrder,   // k1 > k2 > k3 > k4 > 1 does not hold; `allowed` is the neighbour it must stay clear of
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
    NoMotion,         // nothing to do: no distance, no change of speed, no master speed
    DistanceTooShort, // for the two speeds and the law; `allowed` is the least one
    DistanceSign,     // the distance points the other way than the speeds
    KnotCount,        // fewer or more knots than a cam has; `allowed` is the nearest number
    KnotOrder,        // knot `index` does not come after the one before it
    KnotSpacing,      // knots `index` - 1 and `index` are closer than `allowed` degrees
    KnotRange,        // knot `index` lies outside 0..360 degrees, or the slave's range
    KnotEnds,         // the first is not at 0 or the last not at 360 degrees
    Overshoot,        // the spline leaves the range of its knots by more than a tenth of their span
    WrapJump,         // position, speed or acceleration jump where the cycle closes
    StageOrder,       // a press stage ends before it begins: `field` must exceed `allowed`
    ForceOrder,       // `field` must not exceed `allowed`
    MasterTooFast,    // the slave would need more pulses in one update than the output stage gives
    TableRange,       // a table value that its register cannot hold
    Reversal,         // the motion turns round within a cycle, and intervals go one way
    SpeedError,       // intervals cannot keep it with whole pulses; `allowed` can be kept
    RampTooLong,      // a press stage speeds up longer than a row holds
};

// Stable id of a limit, for logs and machine-readable output.
[[nodiscard]] std::string_view limitId(Limit limit);

// A value of one input that, alone changed, makes the whole recipe feasible; the nearest one on the field's
// grid.
struct Suggestion {
    Field field = Field::BagLength;
    double value = 0;
};

struct TimeSpan {
    double fromS = 0;
    double toS = 0;
};

struct Refusal {
    Limit limit = Limit::FieldRange;
    Field field = Field::BagLength; // the field that is wrong, or the machine limit that is broken
    double actual = 0;
    double allowed = 0;
    std::string_view unit;
    std::optional<double> timeS;    // where in the cycle it is worst
    std::optional<double> angleDeg; // the same as an angle of the master, 360 degrees per cycle
    std::vector<TimeSpan> brokenDuring;
    std::vector<Suggestion> nearest; // best first; empty when no single input alone can mend it
    std::string_view
        lawParameter; // LawParameter: id of the parameter; WrapJump: "position", "speed", "acceleration"
    int index = -1;   // of the knot, from 0, for the limits of knots only
};

// One or two English sentences: what is wrong, by how much, where, and what to do.
[[nodiscard]] std::string describe(const Refusal& refusal);

} // namespace campanel::profile
