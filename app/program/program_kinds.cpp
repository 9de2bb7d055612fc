// SPDX-License-Identifier: Apache-2.0
// The table of kinds, and one list of members per structure of inputs.
#include "app/program/program_kinds.h"

#include "profile/laws/laws.h"
#include "text/marked.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace campanel::program {
namespace {

// profile and modbus know nothing of each other: each has the words of its own side, with the same codes.
template <typename A, typename B> constexpr bool hasSameCodes(A a, B b)
{
    return static_cast<unsigned>(a) == static_cast<unsigned>(b);
}
static_assert(hasSameCodes(profile::ProgramKind::RotaryCutter, modbus::ProgramKind::RotaryCutter));
static_assert(hasSameCodes(profile::ProgramKind::PositionMove, modbus::ProgramKind::PositionMove));
static_assert(hasSameCodes(profile::ProgramKind::SpeedMove, modbus::ProgramKind::SpeedMove));
static_assert(hasSameCodes(profile::ProgramKind::PointCam, modbus::ProgramKind::PointCam));
static_assert(hasSameCodes(profile::ProgramKind::Press, modbus::ProgramKind::Press));
static_assert(hasSameCodes(profile::ProgramKind::SegmentCam, modbus::ProgramKind::SegmentCam));
static_assert(hasSameCodes(profile::MoveDuration::GivenTime, modbus::MoveDuration::GivenTime));
static_assert(hasSameCodes(profile::MoveDuration::Fastest, modbus::MoveDuration::Fastest));
static_assert(hasSameCodes(profile::MoveDuration::OverDistance, modbus::MoveDuration::OverDistance));
static_assert(hasSameCodes(profile::SplineEnds::Natural, modbus::SplineEnds::Natural));
static_assert(hasSameCodes(profile::SplineEnds::Clamped, modbus::SplineEnds::Clamped));
static_assert(hasSameCodes(profile::SplineEnds::Periodic, modbus::SplineEnds::Periodic));
static_assert(hasSameCodes(profile::RampShape::Trapezoid, modbus::RampShape::Trapezoid));
static_assert(hasSameCodes(profile::RampShape::SCurve, modbus::RampShape::SCurve));

using profile::Field;
using profile::PointCamProgram;
using profile::PositionMoveProgram;
using profile::PressProgram;
using profile::Program;
using profile::ProgramKind;
using profile::RotaryCutterProgram;
using profile::SegmentCamProgram;
using profile::SpeedMoveProgram;

template <typename E> constexpr ChoiceOption option(std::string_view key, E value, std::string_view name)
{
    return {key, static_cast<std::uint16_t>(value), name};
}

using profile::Execution;
using profile::MoveDuration;
using profile::RampShape;
using profile::SplineEnds;
constexpr ChoiceOption givenTime =
    option("given_time", MoveDuration::GivenTime, CAMPANEL_TEXT("Recipe", "In a given time"));
constexpr ChoiceOption fastest =
    option("fastest", MoveDuration::Fastest, CAMPANEL_TEXT("Recipe", "As fast as possible"));
constexpr std::array positionDurations{givenTime, fastest};
constexpr std::array speedDurations{
    givenTime, fastest,
    option("over_distance", MoveDuration::OverDistance, CAMPANEL_TEXT("Recipe", "Over a distance"))};
constexpr std::array executions{
    option("cam_points", Execution::CamPoints, CAMPANEL_TEXT("Recipe", "Cam points")),
    option("intervals", Execution::Intervals, CAMPANEL_TEXT("Recipe", "Intervals"))};
constexpr std::array ends{option("natural", SplineEnds::Natural, CAMPANEL_TEXT("Recipe", "Natural")),
                          option("clamped", SplineEnds::Clamped, CAMPANEL_TEXT("Recipe", "Clamped")),
                          option("periodic", SplineEnds::Periodic, CAMPANEL_TEXT("Recipe", "Periodic"))};
constexpr std::array shapes{option("trapezoid", RampShape::Trapezoid, CAMPANEL_TEXT("Recipe", "Trapezoid")),
                            option("s_curve", RampShape::SCurve, CAMPANEL_TEXT("Recipe", "S curve"))};

using profile::RatioMode;
constexpr std::array ratioModes{option("hand", RatioMode::ByHand, CAMPANEL_TEXT("Recipe", "Set by hand")),
                                option("gentle", RatioMode::Gentle, CAMPANEL_TEXT("Recipe", "Gentle")),
                                option("cool", RatioMode::Cool, CAMPANEL_TEXT("Recipe", "Cool")),
                                option("slow", RatioMode::Slow, CAMPANEL_TEXT("Recipe", "Slow")),
                                option("between", RatioMode::Between, CAMPANEL_TEXT("Recipe", "Between"))};

constexpr std::string_view lawName = CAMPANEL_TEXT("Recipe", "Law");
constexpr ChoiceInfo lawChoice{Choice::Law, "law", lawName, {}};
constexpr ChoiceInfo executionChoice{Choice::Execution, "execution", CAMPANEL_TEXT("Recipe", "Execution"),
                                     executions};
constexpr ChoiceInfo rampChoice{Choice::MasterRampShape, "master_ramp_shape",
                                CAMPANEL_TEXT("Recipe", "Shape of the ramp"), shapes};
constexpr std::string_view durationName = CAMPANEL_TEXT("Recipe", "Duration");
constexpr std::array cutterChoices{
    ChoiceInfo{Choice::Law, "speed_law", lawName, {}},
    ChoiceInfo{Choice::Ratios, "ratios", CAMPANEL_TEXT("Recipe", "Ratios"), ratioModes}};
constexpr std::array positionChoices{
    lawChoice, ChoiceInfo{Choice::Duration, "duration", durationName, positionDurations}, executionChoice};
constexpr std::array speedChoices{
    lawChoice, ChoiceInfo{Choice::Duration, "duration", durationName, speedDurations}, executionChoice};
constexpr std::array camChoices{
    ChoiceInfo{Choice::SplineEnds, "ends", CAMPANEL_TEXT("Recipe", "Spline ends"), ends}, rampChoice};
constexpr std::array segmentChoices{rampChoice};

constexpr std::array cutterFields{
    Field::BagLength,   Field::Rate,        Field::BaseSpeed, Field::FilmSpeed, Field::K1,
    Field::K2,          Field::K3,          Field::K4,        Field::SyncRatio, Field::SlicesPerRamp,
    Field::MinSealTime, Field::RampPosition};
constexpr std::array cutterMachine{Field::KnifeRadius, Field::Knives, Field::PulsesPerMotorRev,
                                   Field::GearNumerator, Field::GearDenominator, Field::MaxMotorRpm,
                                   Field::MaxKnifeAcceleration, Field::MaxPulseFrequency, Field::MaxRate,
                                   // Optional: the motor, and the shaft behind it.
                                   Field::MaxTorque, Field::RatedTorque, Field::Inertia, Field::Friction,
                                   Field::NaturalFrequency, Field::DampingRatio, Field::ContactAngle};

constexpr std::array axisMachine{Field::FeedPerMotorRev,  Field::PulsesPerMotorRev, Field::MaxMotorRpm,
                                 Field::MaxAcceleration,  Field::MaxPulseFrequency, Field::MaxTorque,
                                 Field::Inertia,          Field::Friction,          Field::RatedTorque,
                                 Field::NaturalFrequency, Field::DampingRatio};
constexpr std::array positionFields{Field::Distance, Field::MoveTime, Field::CamPoints};
constexpr std::array speedFields{Field::StartSpeed, Field::EndSpeed, Field::MoveTime, Field::Distance,
                                 Field::CamPoints};

constexpr std::array camFields{Field::MasterRate, Field::MasterRamp, Field::MasterRatio, Field::MasterScale,
                               Field::SlaveScale, Field::Phase,      Field::CamPoints};

constexpr std::array pressFields{
    Field::ApproachPosition,  Field::ApproachSpeed, Field::ProbeSpeed,  Field::ProbeForce,  Field::ProbeEnd,
    Field::PressSpeed,        Field::PressPosition, Field::HoldTime,    Field::ReturnSpeed, Field::MaxForce,
    Field::PositionTolerance, Field::MinStopForce,  Field::MaxStopForce};
constexpr std::array pressMachine{Field::FeedPerMotorRev, Field::PulsesPerMotorRev, Field::MaxMotorRpm,
                                  Field::MaxAcceleration, Field::MaxPulseFrequency};

using modbus::EndBehavior;
using modbus::TableLayout;
constexpr std::array stepTable{TableLayout::StepTable};
constexpr std::array camPoints{TableLayout::CamPoints};
constexpr std::array camPointsOrIntervals{TableLayout::CamPoints, TableLayout::Intervals};
constexpr std::array pressStages{TableLayout::PressStages};

template <typename P> Program newProgram()
{
    return P{};
}

void paperCutter(profile::Machine&) {}

// The motor of the servo paper.
void paperAxis(profile::Machine& machine)
{
    machine.pulsesPerMotorRev = 1000;
    machine.maxMotorRpm = 7200;
    machine.maxTorqueNm = 1.33;
    machine.inertiaKgCm2 = 0.2;
    machine.frictionNm = 0.02;
}

void paperPress(profile::Machine& machine)
{
    machine.pulsesPerMotorRev = 1000;
    machine.feedMmPerMotorRev = 10; // 0.01 mm a pulse
    machine.maxAccelerationMmPerS2 = 2000;
}

constexpr std::array<KindInfo, 6> kindTable{{
    {ProgramKind::RotaryCutter, "rotary_cutter", CAMPANEL_TEXT("Recipe", "Rotary cutter"), cutterFields,
     cutterMachine, cutterChoices, "program.", stepTable, EndBehavior::Repeat, "Biscuit 250",
     newProgram<RotaryCutterProgram>, paperCutter},
    {ProgramKind::PositionMove, "position_move", CAMPANEL_TEXT("Recipe", "Position move"), positionFields,
     axisMachine, positionChoices, "position_move.", camPointsOrIntervals, EndBehavior::Stop, "Position move",
     newProgram<PositionMoveProgram>, paperAxis},
    {ProgramKind::SpeedMove, "speed_move", CAMPANEL_TEXT("Recipe", "Speed move"), speedFields, axisMachine,
     speedChoices, "speed_move.", camPointsOrIntervals, EndBehavior::HoldSpeed, "Speed move",
     newProgram<SpeedMoveProgram>, paperAxis},
    {ProgramKind::PointCam, "point_cam", CAMPANEL_TEXT("Recipe", "Point cam"), camFields, axisMachine,
     camChoices, "cam.", camPoints, EndBehavior::Repeat, "Point cam", newProgram<PointCamProgram>, paperAxis,
     &knotList},
    {ProgramKind::Press,
     "press",
     CAMPANEL_TEXT("Recipe", "Press"),
     pressFields,
     pressMachine,
     {},
     "press.",
     pressStages,
     EndBehavior::Repeat,
     "Press",
     newProgram<PressProgram>,
     paperPress},
    {ProgramKind::SegmentCam, "segment_cam", CAMPANEL_TEXT("Recipe", "Segment cam"), camFields, axisMachine,
     segmentChoices, "cam.", camPoints, EndBehavior::Repeat, "Segment cam", newProgram<SegmentCamProgram>,
     paperAxis, &segmentList},
}};

// Calls visit(choice, member) for every choice of the program.
template <typename Visitor> void visitChoices(RotaryCutterProgram& program, Visitor visit)
{
    visit(Choice::Law, program.speedLaw);
    visit(Choice::Ratios, program.ratioMode);
}

template <typename Move, typename Visitor> void visitMove(Move& program, Visitor visit)
{
    visit(Choice::Law, program.law);
    visit(Choice::Duration, program.duration);
    visit(Choice::Execution, program.execution);
}

template <typename Visitor> void visitChoices(PositionMoveProgram& program, Visitor visit)
{
    visitMove(program, visit);
}

template <typename Visitor> void visitChoices(SpeedMoveProgram& program, Visitor visit)
{
    visitMove(program, visit);
}

template <typename Visitor> void visitChoices(PointCamProgram& program, Visitor visit)
{
    visit(Choice::SplineEnds, program.ends);
    visit(Choice::MasterRampShape, program.masterRamp);
}

template <typename Visitor> void visitChoices(PressProgram&, Visitor) {}

template <typename Visitor> void visitChoices(SegmentCamProgram& program, Visitor visit)
{
    visit(Choice::MasterRampShape, program.masterRamp);
}

} // namespace

std::span<const KindInfo> kinds()
{
    return kindTable;
}

const KindInfo& kindInfo(ProgramKind kind)
{
    return kindTable[static_cast<std::size_t>(kind) - 1];
}

const KindInfo* findKind(std::string_view key)
{
    const auto found = std::ranges::find(kindTable, key, &KindInfo::key);
    return found == kindTable.end() ? nullptr : &*found;
}

ChoiceInfo choiceInfo(ProgramKind kind, Choice choice)
{
    const auto choices = kindInfo(kind).choices;
    const auto found = std::ranges::find(choices, choice, &ChoiceInfo::choice);
    return found == choices.end() ? ChoiceInfo{choice, {}, {}, {}} : *found;
}

bool isLawOf(ProgramKind kind, const profile::Law& law)
{
    return kind == ProgramKind::PositionMove ? law.isDisplacementLaw : law.isSpeedLaw;
}

double value(const Program& program, Field field)
{
    return std::visit([field](const auto& inputs) { return profile::value(inputs, field); }, program);
}

void setValue(Program& program, Field field, double value)
{
    std::visit([field, value](auto& inputs) { profile::setValue(inputs, field, value); }, program);
}

std::uint16_t choice(const Program& program, Choice wanted)
{
    std::uint16_t code = 0;
    Program copy = program; // the visitor is shared with setChoice()
    std::visit(
        [&](auto& inputs) {
            visitChoices(inputs, [&](Choice each, auto& member) {
                if (each == wanted)
                    code = static_cast<std::uint16_t>(member);
            });
        },
        copy);
    return code;
}

void setChoice(Program& program, Choice wanted, std::uint16_t code)
{
    std::visit(
        [&](auto& inputs) {
            visitChoices(inputs, [&](Choice each, auto& member) {
                if (each == wanted)
                    member = static_cast<std::remove_reference_t<decltype(member)>>(code);
            });
        },
        program);
}

profile::LawParameters* lawParameters(Program& program)
{
    if (auto* cutter = std::get_if<RotaryCutterProgram>(&program))
        return &cutter->speedLawParameters;
    if (auto* move = std::get_if<PositionMoveProgram>(&program))
        return &move->lawParameters;
    if (auto* move = std::get_if<SpeedMoveProgram>(&program))
        return &move->lawParameters;
    return nullptr;
}

const profile::LawParameters* lawParameters(const Program& program)
{
    return lawParameters(const_cast<Program&>(program)); // read-only
}

bool isRead(const Program& program, Field field)
{
    if (const auto* move = std::get_if<PositionMoveProgram>(&program))
        return (field != Field::MoveTime || move->duration == MoveDuration::GivenTime) &&
               (field != Field::CamPoints || move->execution == Execution::CamPoints);
    if (const auto* move = std::get_if<SpeedMoveProgram>(&program))
        return (field != Field::MoveTime || move->duration == MoveDuration::GivenTime) &&
               (field != Field::Distance || move->duration == MoveDuration::OverDistance) &&
               (field != Field::CamPoints || move->execution == Execution::CamPoints);
    if (const auto* cutter = std::get_if<RotaryCutterProgram>(&program)) {
        if (field == Field::RampPosition)
            return cutter->ratioMode == RatioMode::Between;
        return field > Field::FilmSpeed || profile::isPinned(*cutter, field);
    }
    return true;
}

} // namespace campanel::program
