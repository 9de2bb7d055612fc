// SPDX-License-Identifier: Apache-2.0
// The table of kinds, and one list of members per structure of inputs.
#include "app/program/program_kinds.h"

#include "profile/laws/laws.h"
#include "text/marked.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <variant>

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
constexpr ChoiceInfo lawChoice{Choice::Law, "law", "law", "curve", lawName, {}};
constexpr ChoiceInfo executionChoice{
    Choice::Execution, "execution", "", "curve", CAMPANEL_TEXT("Recipe", "Execution"), executions};
constexpr ChoiceInfo rampChoice{Choice::MasterRampShape,
                                "master_ramp_shape",
                                "ramp_shape",
                                "master",
                                CAMPANEL_TEXT("Recipe", "Shape of the ramp"),
                                shapes};
constexpr std::string_view durationName = CAMPANEL_TEXT("Recipe", "Duration");
constexpr std::array cutterChoices{
    ChoiceInfo{Choice::Law, "speed_law", "law", "curve", lawName, {}},
    ChoiceInfo{Choice::Ratios, "ratios", "", "", CAMPANEL_TEXT("Recipe", "Ratios"), ratioModes}};
constexpr std::array positionChoices{
    lawChoice, ChoiceInfo{Choice::Duration, "duration", "duration", "move", durationName, positionDurations},
    executionChoice};
constexpr std::array speedChoices{
    lawChoice, ChoiceInfo{Choice::Duration, "duration", "duration", "move", durationName, speedDurations},
    executionChoice};
constexpr std::array camChoices{
    ChoiceInfo{Choice::SplineEnds, "ends", "ends", "curve", CAMPANEL_TEXT("Recipe", "Spline ends"), ends},
    rampChoice};
constexpr std::array segmentChoices{rampChoice};

using profile::machineFields;
using profile::memberFields;
namespace machine_use = profile::machine_use;

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
    {ProgramKind::RotaryCutter, "rotary_cutter", CAMPANEL_TEXT("Recipe", "Rotary cutter"),
     memberFields<RotaryCutterProgram>, machineFields<machine_use::knife>, cutterChoices, "program.",
     stepTable, EndBehavior::Repeat, "Biscuit 250", newProgram<RotaryCutterProgram>, paperCutter},
    {ProgramKind::PositionMove, "position_move", CAMPANEL_TEXT("Recipe", "Position move"),
     memberFields<PositionMoveProgram>, machineFields<machine_use::axis>, positionChoices, "position_move.",
     camPointsOrIntervals, EndBehavior::Stop, "Position move", newProgram<PositionMoveProgram>, paperAxis},
    {ProgramKind::SpeedMove, "speed_move", CAMPANEL_TEXT("Recipe", "Speed move"),
     memberFields<SpeedMoveProgram>, machineFields<machine_use::axis>, speedChoices, "speed_move.",
     camPointsOrIntervals, EndBehavior::HoldSpeed, "Speed move", newProgram<SpeedMoveProgram>, paperAxis},
    {ProgramKind::PointCam, "point_cam", CAMPANEL_TEXT("Recipe", "Point cam"), memberFields<PointCamProgram>,
     machineFields<machine_use::axis>, camChoices, "cam.", camPoints, EndBehavior::Repeat, "Point cam",
     newProgram<PointCamProgram>, paperAxis, &knotList},
    {ProgramKind::Press,
     "press",
     CAMPANEL_TEXT("Recipe", "Press"),
     memberFields<PressProgram>,
     machineFields<machine_use::press>,
     {},
     "press.",
     pressStages,
     EndBehavior::Repeat,
     "Press",
     newProgram<PressProgram>,
     paperPress},
    {ProgramKind::SegmentCam, "segment_cam", CAMPANEL_TEXT("Recipe", "Segment cam"),
     memberFields<SegmentCamProgram>, machineFields<machine_use::axis>, segmentChoices, "cam.", camPoints,
     EndBehavior::Repeat, "Segment cam", newProgram<SegmentCamProgram>, paperAxis, &segmentList},
}};

// Calls visit(choice, member) for every choice of the program.
template <typename P, typename Visitor> void visitChoices(P& program, Visitor visit)
{
    if constexpr (requires { program.speedLaw; })
        visit(Choice::Law, program.speedLaw);
    if constexpr (requires { program.law; })
        visit(Choice::Law, program.law);
    if constexpr (requires { program.ratioMode; })
        visit(Choice::Ratios, program.ratioMode);
    if constexpr (requires { program.duration; })
        visit(Choice::Duration, program.duration);
    if constexpr (requires { program.execution; })
        visit(Choice::Execution, program.execution);
    if constexpr (requires { program.ends; })
        visit(Choice::SplineEnds, program.ends);
    if constexpr (requires { program.masterRamp; })
        visit(Choice::MasterRampShape, program.masterRamp);
}

// Returns the parameters of the law of any program, constant or not; null without a law.
auto findLawParameters(auto& program)
{
    return std::visit(
        [](auto& inputs) -> decltype(&std::get<PositionMoveProgram>(program).lawParameters) {
            if constexpr (requires { inputs.speedLawParameters; })
                return &inputs.speedLawParameters;
            else if constexpr (requires { inputs.lawParameters; })
                return &inputs.lawParameters;
            else
                return nullptr;
        },
        program);
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
    return found == choices.end() ? ChoiceInfo{choice, {}, {}, {}, {}, {}} : *found;
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
    std::visit(
        [&](const auto& inputs) {
            visitChoices(inputs, [&](Choice each, auto& member) {
                if (each == wanted)
                    code = static_cast<std::uint16_t>(member);
            });
        },
        program);
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
    return findLawParameters(program);
}

const profile::LawParameters* lawParameters(const Program& program)
{
    return findLawParameters(program);
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
        return !profile::isCycleField(field) || profile::isPinned(*cutter, field);
    }
    return true;
}

} // namespace campanel::program
