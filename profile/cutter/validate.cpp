// SPDX-License-Identifier: Apache-2.0
// Validates inputs against the table of fields, the law's own parameters, and the order of the ratios.
#include "profile/cutter/validate.h"

#include "profile/laws/laws.h"

#include <bit>

namespace campanel::profile::detail {
namespace {

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
        refusal.field = static_cast<Field>(static_cast<std::size_t>(Field::K1) + i + 1);
        refusal.actual = program.k[i + 1];
        refusal.allowed = program.k[i];
        return refusal;
    }
    return std::nullopt;
}

} // namespace

bool hasDescendingRatios(const RotaryCutterProgram& program)
{
    return !findWrongOrder(program);
}

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

std::optional<Refusal> findInvalid(const RotaryCutterProgram& program, const Machine& machine)
{
    if (!isCycleField(program.pinned[0]) || !isCycleField(program.pinned[1]) ||
        program.pinned[0] == program.pinned[1]) {
        Refusal refusal;
        refusal.limit = Limit::PinnedPair;
        refusal.field = program.pinned[1];
        return refusal;
    }
    if (auto refusal = findInvalidMachine(machine, machine_use::knife))
        return refusal;
    if (auto refusal = findNarrowTimer(machine))
        return refusal;
    const auto isGiven = [&program](const Member<RotaryCutterProgram>& member) {
        return !isCycleField(member.field) || isPinned(program, member.field);
    };
    if (auto refusal = findOutOfRange(program, isGiven))
        return refusal;
    if (auto refusal = findInvalidLaw(program.speedLaw, program.speedLawParameters, LawUse::Speed))
        return refusal;
    return findWrongOrder(program);
}

} // namespace campanel::profile::detail
