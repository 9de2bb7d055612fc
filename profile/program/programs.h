// SPDX-License-Identifier: Apache-2.0
// The inputs of every kind of program, as a person enters them. The header of each kind has the derived
// figures: rotary_cutter.h, position_move.h, speed_move.h, point_cam.h, press.h, segment_cam.h.
#pragma once

#include "profile/cutter/rotary_cutter.h"
#include "profile/model/law.h"
#include "profile/model/members.h"

#include <cstdint>
#include <type_traits>
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
    SegmentCam = 6,
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

template <>
inline constexpr std::array membersOf<PositionMoveProgram>{
    Member<PositionMoveProgram>{Field::Distance, &PositionMoveProgram::distanceMm},
    Member<PositionMoveProgram>{Field::MoveTime, &PositionMoveProgram::timeS},
    Member<PositionMoveProgram>{Field::CamPoints, &PositionMoveProgram::camPoints},
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

template <>
inline constexpr std::array membersOf<SpeedMoveProgram>{
    Member<SpeedMoveProgram>{Field::StartSpeed, &SpeedMoveProgram::startSpeedMmPerS},
    Member<SpeedMoveProgram>{Field::EndSpeed, &SpeedMoveProgram::endSpeedMmPerS},
    Member<SpeedMoveProgram>{Field::MoveTime, &SpeedMoveProgram::timeS},
    Member<SpeedMoveProgram>{Field::Distance, &SpeedMoveProgram::distanceMm},
    Member<SpeedMoveProgram>{Field::CamPoints, &SpeedMoveProgram::camPoints},
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

// The virtual master of a cam, and how the cam lies on it. Every kind that follows a master derives from it.
struct CamMaster {
    double masterRateRevPerMin = info(Field::MasterRate).defaultValue; // negative: the master runs backward
    double masterRampS = info(Field::MasterRamp).defaultValue;
    RampShape masterRamp = RampShape::Trapezoid;
    double masterRatio = 1; // master revolutions per cam cycle, before scaling
    double masterScale = 1; // stretches the cam over the master
    double slaveScale = 1;  // stretches the cam over the slave
    double phaseDeg = 0;    // start of the master within the cam cycle
    int camPoints = 1000;
    // The net advance of the axis per cycle that a person has confirmed; 0: none. Not part of the motion.
    double confirmedAdvanceMm = 0;
};

template <typename Cam>
inline constexpr std::array camMembers{
    Member<Cam>{Field::MasterRate, &Cam::masterRateRevPerMin},
    Member<Cam>{Field::MasterRamp, &Cam::masterRampS},
    Member<Cam>{Field::MasterRatio, &Cam::masterRatio},
    Member<Cam>{Field::MasterScale, &Cam::masterScale},
    Member<Cam>{Field::SlaveScale, &Cam::slaveScale},
    Member<Cam>{Field::Phase, &Cam::phaseDeg},
    Member<Cam>{Field::CamPoints, &Cam::camPoints},
};
template <> inline constexpr auto membersOf<CamMaster> = camMembers<CamMaster>;

struct PointCamProgram : CamMaster {
    std::vector<Knot> knots = defaultKnots(); // 5..100, ascending
    SplineEnds ends = SplineEnds::Periodic;
};

template <> inline constexpr auto membersOf<PointCamProgram> = camMembers<PointCamProgram>;

// The motion of a segment of a cam. Stable codes; a displacement law has the code of its LawId.
enum class SegmentMotion : std::uint16_t {
    Dwell = 0,
    ConstantSpeed = 101,
    Polynomial3 = 103, // with the speeds at both ends
    Polynomial5 = 105, // with the speeds and accelerations at both ends
};

[[nodiscard]] constexpr SegmentMotion segmentMotion(LawId law)
{
    return static_cast<SegmentMotion>(law);
}

// The derivatives of the slave by the master's angle at one end of a segment, before scaling.
struct SegmentBoundary {
    double speedMmPerDeg = 0;
    double accelerationMmPerDeg2 = 0;

    bool operator==(const SegmentBoundary&) const = default;
};

// A part of the cam cycle. It begins at the slave position at which the segment before ends.
struct CamSegment {
    double fromDeg = 0; // 0..360 degrees of a cam cycle
    double toDeg = 0;
    SegmentMotion motion = SegmentMotion::Dwell;
    double endMm = 0;      // slave position at the end; 0 is that of the beginning of the cycle
    SegmentBoundary start; // Polynomial3, Polynomial5
    SegmentBoundary end;
    LawParameters lawParameters{};

    bool operator==(const CamSegment&) const = default;
};

// Returns a rise, a dwell, a return and a dwell.
[[nodiscard]] inline std::vector<CamSegment> defaultSegments()
{
    return {{0, 120, segmentMotion(LawId::Quintic), 50, {}, {}, {}},
            {120, 180, SegmentMotion::Dwell, 50, {}, {}, {}},
            {180, 300, segmentMotion(LawId::ModifiedSine), 0, {}, {}, {}},
            {300, 360, SegmentMotion::Dwell, 0, {}, {}, {}}};
}

struct SegmentCamProgram : CamMaster {
    std::vector<CamSegment> segments = defaultSegments(); // 1..40, one after the other
};

template <> inline constexpr auto membersOf<SegmentCamProgram> = camMembers<SegmentCamProgram>;

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

template <>
inline constexpr std::array membersOf<PressProgram>{
    Member<PressProgram>{Field::ApproachPosition, &PressProgram::approachPositionMm},
    Member<PressProgram>{Field::ApproachSpeed, &PressProgram::approachSpeedMmPerS},
    Member<PressProgram>{Field::ProbeSpeed, &PressProgram::probeSpeedMmPerS},
    Member<PressProgram>{Field::ProbeForce, &PressProgram::probeForceN},
    Member<PressProgram>{Field::ProbeEnd, &PressProgram::probeEndMm},
    Member<PressProgram>{Field::PressSpeed, &PressProgram::pressSpeedMmPerS},
    Member<PressProgram>{Field::PressPosition, &PressProgram::pressPositionMm},
    Member<PressProgram>{Field::HoldTime, &PressProgram::holdTimeS},
    Member<PressProgram>{Field::ReturnSpeed, &PressProgram::returnSpeedMmPerS},
    Member<PressProgram>{Field::MaxForce, &PressProgram::maxForceN},
    Member<PressProgram>{Field::PositionTolerance, &PressProgram::positionToleranceMm},
    Member<PressProgram>{Field::MinStopForce, &PressProgram::minStopForceN},
    Member<PressProgram>{Field::MaxStopForce, &PressProgram::maxStopForceN},
};

using Program = std::variant<RotaryCutterProgram, PositionMoveProgram, SpeedMoveProgram, PointCamProgram,
                             PressProgram, SegmentCamProgram>;

[[nodiscard]] inline ProgramKind kindOf(const Program& program)
{
    return static_cast<ProgramKind>(program.index() + 1);
}

// Returns the master of a program that follows one, or null.
[[nodiscard]] inline const CamMaster* camMaster(const Program& program)
{
    return std::visit(
        []<typename P>(const P& inputs) -> const CamMaster* {
            if constexpr (std::is_base_of_v<CamMaster, P>)
                return &inputs;
            else
                return nullptr;
        },
        program);
}

} // namespace campanel::profile
