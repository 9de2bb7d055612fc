// SPDX-License-Identifier: Apache-2.0
// Constants derived from the machine's parameters.
#include "profile/model/machine.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace campanel::profile {
namespace {

double knifeCircumferenceMm(const Machine& machine)
{
    return 2 * std::numbers::pi * machine.knifeRadiusMm;
}

double gearRatio(const Machine& machine)
{
    return static_cast<double>(machine.gearNumerator) / machine.gearDenominator;
}

} // namespace

bool isSameScale(const Machine& left, const Machine& right, std::span<const Field> used)
{
    return std::ranges::all_of(membersOf<Machine>, [&](const Member<Machine>& member) {
        const bool isCompared =
            (member.uses & machine_use::scale) != 0 && std::ranges::find(used, member.field) != used.end();
        const double step = info(member.field).resolution();
        return !isCompared || std::abs(member.get(left) - member.get(right)) < step / 2;
    });
}

PulsesPerCycle pulsesPerCycle(const Machine& machine)
{
    const std::int64_t numerator = std::int64_t{machine.pulsesPerMotorRev} * machine.gearNumerator;
    const std::int64_t denominator = std::int64_t{machine.gearDenominator} * machine.knives;
    const std::int64_t common = std::gcd(numerator, denominator);
    const std::int64_t divisor = denominator / common;
    return {numerator / denominator, numerator / common % divisor, divisor};
}

double strokeMm(const Machine& machine)
{
    return knifeCircumferenceMm(machine) / machine.knives;
}

double pulsesPerMm(const Machine& machine)
{
    return machine.pulsesPerMotorRev * gearRatio(machine) / knifeCircumferenceMm(machine);
}

double motorRpmPerMmPerS(const Machine& machine)
{
    return 60 * gearRatio(machine) / knifeCircumferenceMm(machine);
}

std::int64_t minTimerConstant(const Machine& machine)
{
    return static_cast<std::int64_t>(std::ceil(machine.timerClockHz / machine.maxPulseFrequencyHz));
}

std::int64_t maxTimerConstant(const Machine& machine)
{
    return (std::int64_t{1} << machine.timerBits) - 1;
}

double pulseFrequencyLimitHz(const Machine& machine)
{
    return static_cast<double>(machine.timerClockHz) / static_cast<double>(minTimerConstant(machine));
}

double axisPulsesPerMm(const Machine& machine)
{
    return machine.pulsesPerMotorRev / machine.feedMmPerMotorRev;
}

double axisRpmPerMmPerS(const Machine& machine)
{
    constexpr double secondsPerMinute = 60;
    return secondsPerMinute / machine.feedMmPerMotorRev;
}

} // namespace campanel::profile
