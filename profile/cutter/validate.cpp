// SPDX-License-Identifier: Apache-2.0
// Validates inputs against the table of fields, the law's own parameters, and the order of the ratios.
#include "profile/cutter/validate.h"

#include "profile/laws/laws.h"

#include <bit>

namespace campanel::profile::detail {
namespace {

constexpr std::array ratioFields{Field::K1, Field::K2, Field::K3, Field::K4};
constexpr std::array machineFields{
    Field::KnifeRadius,     Field::Knives,           Field::PulsesPerMotorRev,    Field::GearNumerator,
    Field::GearDenominator, Field::MaxMotorRpm,      Field::MaxKnifeAcceleration, Field::MaxPulseFrequency,
    Field::MaxRate,         Field::ContactAngle,     Field::TimerClock,           Field::TimerBits,
    Field::RowCapacity,     Field::MaxTorque,        Field::RatedTorque,          Field::Inertia,
    Field::Friction,        Field::NaturalFrequency, Field::DampingRatio};
constexpr std::array axisFields{Field::PulsesPerMotorRev, Field::FeedPerMotorRev,   Field::MaxMotorRpm,
                                Field::MaxAcceleration,   Field::MaxTorque,         Field::Inertia,
                                Field::Friction,          Field::MaxPulseFrequency, Field::TimerClock,
                                Field::RatedTorque,       Field::NaturalFrequency,  Field::DampingRatio};

bool isCycleValue(Field field)
{
    return field == Field::BagLength || field == Field::Rate || field == Field::BaseSpeed ||
           field == Field::FilmSpeed;
}

// Refuses a timer that overflows before the shortest interval between pulses.
std::optional<Refusal> findNarrowTimer(const Machine& machine)
{
    if (minTimerConstant(machine) <= maxTimerConstant(machine))
        return std::nullopt;
    Refusal refusal = outOfRange(Field::TimerBits, machine.timerBits);
    refusal.allowed =
        static_cast<double>(std::bit_width(static_cast<std::uint64_t>(minTimerConstant(machine))));
    return refusal;
}

std::optional<Refusal> findWrongOrder(const RotaryCutterProgram& program)
{
    for (std::size_t i = 0; i + 1 < program.k.size(); ++i) {
        if (program.k[i] > program.k[i + 1])
            continue;
        Refusal refusal;
        refusal.limit = Limit::RatioOrder;
        refusal.field = ratioFields[i + 1];
        refusal.actual = program.k[i + 1];
        refusal.allowed = program.k[i];
        return refusal;
    }
    return std::nullopt;
}

} // namespace

Refusal outOfRange(Field field, double value)
{
    const FieldInfo& f = info(field);
    Refusal refusal;
    refusal.limit = Limit::FieldRange;
    refusal.field = field;
    refusal.actual = value;
    refusal.allowed = value > f.max ? f.max : f.min;
    refusal.unit = f.unit;
    return refusal;
}

std::optional<Refusal> findInvalidLaw(LawId id, const LawParameters& parameters, LawUse use)
{
    const Law* law = findLaw(id);
    const bool isSuitable =
        law != nullptr && (use == LawUse::Speed ? law->isSpeedLaw : law->isDisplacementLaw);
    if (!isSuitable) {
        Refusal refusal;
        refusal.limit = Limit::LawUnknown;
        refusal.actual = static_cast<double>(id);
        return refusal;
    }
    for (std::size_t i = 0; i < law->parameters.size(); ++i) {
        const LawParameterInfo& parameter = law->parameters[i];
        const double given = parameters[i];
        if (given >= parameter.min && given <= parameter.max)
            continue;
        Refusal refusal;
        refusal.limit = Limit::LawParameter;
        refusal.actual = given;
        refusal.allowed = given > parameter.max ? parameter.max : parameter.min;
        refusal.lawParameter = parameter.id;
        return refusal;
    }
    return std::nullopt;
}

std::optional<Refusal> findInvalidAxis(const Machine& machine)
{
    for (const Field field : axisFields) {
        if (!inRange(field, value(machine, field)))
            return outOfRange(field, value(machine, field));
    }
    return std::nullopt;
}

std::optional<Refusal> findInvalid(const RotaryCutterProgram& program, const Machine& machine)
{
    if (!isCycleValue(program.pinned[0]) || !isCycleValue(program.pinned[1]) ||
        program.pinned[0] == program.pinned[1]) {
        Refusal refusal;
        refusal.limit = Limit::PinnedPair;
        refusal.field = program.pinned[1];
        return refusal;
    }
    for (const Field field : machineFields) {
        if (!inRange(field, value(machine, field)))
            return outOfRange(field, value(machine, field));
    }
    if (auto refusal = findNarrowTimer(machine))
        return refusal;
    for (const Field field :
         {program.pinned[0], program.pinned[1], Field::K1, Field::K2, Field::K3, Field::K4, Field::SyncRatio,
          Field::SlicesPerRamp, Field::MinSealTime, Field::RampPosition}) {
        if (!inRange(field, value(program, field)))
            return outOfRange(field, value(program, field));
    }
    if (auto refusal = findInvalidLaw(program.speedLaw, program.speedLawParameters, LawUse::Speed))
        return refusal;
    return findWrongOrder(program);
}

} // namespace campanel::profile::detail
