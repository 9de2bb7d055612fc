// SPDX-License-Identifier: Apache-2.0
// Constants derived from the machine's parameters.
#include "profile/model/machine.h"

#include "profile/model/bounds.h"

#include <cmath>
#include <limits>
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

double value(const Machine& machine, Field field)
{
    switch (field) {
    case Field::KnifeRadius:
        return machine.knifeRadiusMm;
    case Field::Knives:
        return machine.knives;
    case Field::PulsesPerMotorRev:
        return machine.pulsesPerMotorRev;
    case Field::GearNumerator:
        return machine.gearNumerator;
    case Field::GearDenominator:
        return machine.gearDenominator;
    case Field::MaxMotorRpm:
        return machine.maxMotorRpm;
    case Field::MaxKnifeAcceleration:
        return machine.maxKnifeAccelerationMmPerS2;
    case Field::MaxPulseFrequency:
        return machine.maxPulseFrequencyHz;
    case Field::MaxRate:
        return machine.maxRateBagsPerMin;
    case Field::ContactAngle:
        return machine.contactAngleDeg;
    case Field::TimerClock:
        return machine.timerClockHz;
    case Field::TimerBits:
        return machine.timerBits;
    case Field::RowCapacity:
        return machine.rowCapacity;
    case Field::FeedPerMotorRev:
        return machine.feedMmPerMotorRev;
    case Field::MaxAcceleration:
        return machine.maxAccelerationMmPerS2;
    case Field::MaxTorque:
        return machine.maxTorqueNm;
    case Field::Inertia:
        return machine.inertiaKgCm2;
    case Field::Friction:
        return machine.frictionNm;
    case Field::RatedTorque:
        return machine.ratedTorqueNm;
    case Field::NaturalFrequency:
        return machine.naturalFrequencyHz;
    case Field::DampingRatio:
        return machine.dampingRatio;
    default:
        return std::numeric_limits<double>::quiet_NaN();
    }
}

void setValue(Machine& machine, Field field, double value)
{
    const auto asInt = [value] { return wholeOf(value); };
    switch (field) {
    case Field::KnifeRadius:
        machine.knifeRadiusMm = value;
        break;
    case Field::Knives:
        machine.knives = asInt();
        break;
    case Field::PulsesPerMotorRev:
        machine.pulsesPerMotorRev = asInt();
        break;
    case Field::GearNumerator:
        machine.gearNumerator = asInt();
        break;
    case Field::GearDenominator:
        machine.gearDenominator = asInt();
        break;
    case Field::MaxMotorRpm:
        machine.maxMotorRpm = value;
        break;
    case Field::MaxKnifeAcceleration:
        machine.maxKnifeAccelerationMmPerS2 = value;
        break;
    case Field::MaxPulseFrequency:
        machine.maxPulseFrequencyHz = value;
        break;
    case Field::MaxRate:
        machine.maxRateBagsPerMin = value;
        break;
    case Field::ContactAngle:
        machine.contactAngleDeg = value;
        break;
    case Field::TimerClock:
        machine.timerClockHz = static_cast<std::uint32_t>(maxOf(asInt(), 0));
        break;
    case Field::TimerBits:
        machine.timerBits = asInt();
        break;
    case Field::RowCapacity:
        machine.rowCapacity = asInt();
        break;
    case Field::FeedPerMotorRev:
        machine.feedMmPerMotorRev = value;
        break;
    case Field::MaxAcceleration:
        machine.maxAccelerationMmPerS2 = value;
        break;
    case Field::MaxTorque:
        machine.maxTorqueNm = value;
        break;
    case Field::Inertia:
        machine.inertiaKgCm2 = value;
        break;
    case Field::Friction:
        machine.frictionNm = value;
        break;
    case Field::RatedTorque:
        machine.ratedTorqueNm = value;
        break;
    case Field::NaturalFrequency:
        machine.naturalFrequencyHz = value;
        break;
    case Field::DampingRatio:
        machine.dampingRatio = value;
        break;
    default:
        break;
    }
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
