// SPDX-License-Identifier: Apache-2.0
// The inputs of every kind of program, as a person enters them. The header of each kind has the derived
// figures: rotary_cutter.h, position_move.h, speed_move.h, point_cam.h, press.h.
#pragma once

#include "profile/cutter/rotary_cutter.h"
#include "profile/model/fields.h"
#include "profile/model/law.h"

#include <cstdint>
#include <variant>
#include <vector>

namespace campanel::profile {

// Stable codes: they are sent to the controller.
enum class ProgramKind : std::uint16_t {
    RotaryCutter = 1,
    PositionMove = 2,
    SpeedMove = 3,
    PointCam = 4,
    Press = 5,
};

// The execution of a move in the controller. Stable codes.
enum class Execution : std::uint16_t { CamPoints = 0, Intervals = 1 };

// The given input of a move. Stable codes.
enum class MoveDuration : std::uint16_t {
    GivenTime = 0,
    Fastest = 1,      // as fast as the limits of the machine allow
    OverDistance = 2, // a speed move only
};

// A move from rest to rest over a distance, by a displacement law.
struct PositionMoveProgram {
    double distanceMm = info(Field::Distance).defaultValue; // negative: backward
    MoveDuration duration = MoveDuration::GivenTime;
    double timeS = info(Field::MoveTime).defaultValue; // used when the time is given
    LawId law = LawId::Quintic;
    LawParameters lawParameters{};
    int camPoints = static_cast<int>(info(Field::CamPoints).defaultValue); // intervals of the cam table
    Execution execution = Execution::CamPoints;
};

// A change from one speed to another by a speed law; the last speed is held until a stop.
struct SpeedMoveProgram {
    double startSpeedMmPerS = 0;
    double endSpeedMmPerS = info(Field::EndSpeed).defaultValue;
    MoveDuration duration = MoveDuration::GivenTime;
    double timeS = info(Field::MoveTime).defaultValue;
    double distanceMm = info(Field::Distance).defaultValue; // travel during the change of speed
    LawId law = LawId::HalfModifiedSine;
    LawParameters lawParameters{};
    int camPoints = static_cast<int>(info(Field::CamPoints).defaultValue);
    Execution execution = Execution::CamPoints;
};

// The end conditions of the spline. Stable codes.
enum class SplineEnds : std::uint16_t {
    Natural = 0,  // no curvature
    Clamped = 1,  // no speed
    Periodic = 2, // speed and acceleration continue at the wrap; with a net advance for a progressive cam
};

// The shape of the master's own ramp. Stable codes.
enum class RampShape : std::uint16_t { Trapezoid = 0, SCurve = 1 };

struct Knot {
    double masterDeg = 0; // 0..360 degrees of a cam cycle
    double slaveMm = 0;

    bool operator==(const Knot&) const = default;
};

// Returns five points as drawn in the EtherCAT paper: a rise, a dwell, a return.
[[nodiscard]] inline std::vector<Knot> defaultKnots()
{
    return {{0, 0}, {90, 20}, {180, 50}, {270, 20}, {360, 0}};
}

struct PointCamProgram {
    std::vector<Knot> knots = defaultKnots(); // 5..100, ascending
    SplineEnds ends = SplineEnds::Periodic;
    double masterRateRevPerMin = info(Field::MasterRate).defaultValue; // negative: the master runs backward
    double masterRampS = info(Field::MasterRamp).defaultValue;
    RampShape masterRamp = RampShape::Trapezoid;
    double masterRatio = 1; // master revolutions per cam cycle, before scaling
    double masterScale = 1; // stretches the cam over the master
    double slaveScale = 1;  // stretches the cam over the slave
    double phaseDeg = 0;    // start of the master within the cam cycle
    int camPoints = 1000;
};

struct PressProgram {
    double approachPositionMm = info(Field::ApproachPosition).defaultValue; // B
    double approachSpeedMmPerS = info(Field::ApproachSpeed).defaultValue;   // A to B
    double probeSpeedMmPerS = info(Field::ProbeSpeed).defaultValue;         // B to C
    double probeForceN = info(Field::ProbeForce).defaultValue;              // contact force, which defines C
    double probeEndMm = info(Field::ProbeEnd).defaultValue;                 // limit for C
    double pressSpeedMmPerS = info(Field::PressSpeed).defaultValue;         // C to D
    double pressPositionMm = info(Field::PressPosition).defaultValue;       // D
    double holdTimeS = info(Field::HoldTime).defaultValue;                  // D to E
    double returnSpeedMmPerS = info(Field::ReturnSpeed).defaultValue;       // E to F
    double maxForceN = info(Field::MaxForce).defaultValue;                  // above it the ram stops at once
                                                                            // and returns
    // The tolerances for position and force of a good stroke.
    double positionToleranceMm = info(Field::PositionTolerance).defaultValue;
    double minStopForceN = info(Field::MinStopForce).defaultValue;
    double maxStopForceN = info(Field::MaxStopForce).defaultValue;
};

// Access by field. Another program's field gives NaN and has no effect. Counts are rounded.
[[nodiscard]] double value(const PositionMoveProgram& program, Field field);
[[nodiscard]] double value(const SpeedMoveProgram& program, Field field);
[[nodiscard]] double value(const PointCamProgram& program, Field field);
[[nodiscard]] double value(const PressProgram& program, Field field);
void setValue(PositionMoveProgram& program, Field field, double value);
void setValue(SpeedMoveProgram& program, Field field, double value);
void setValue(PointCamProgram& program, Field field, double value);
void setValue(PressProgram& program, Field field, double value);

using Program =
    std::variant<RotaryCutterProgram, PositionMoveProgram, SpeedMoveProgram, PointCamProgram, PressProgram>;

[[nodiscard]] inline ProgramKind kindOf(const Program& program)
{
    return static_cast<ProgramKind>(program.index() + 1);
}

} // namespace campanel::profile
