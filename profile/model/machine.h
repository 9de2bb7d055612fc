// SPDX-License-Identifier: Apache-2.0
// The machine that a program runs on: knife, drive, gear, limits, and the controller's pulse timer and table
// size.
#pragma once

#include "profile/model/fields.h"

#include <cstdint>

namespace campanel::profile {

struct Machine {
    double knifeRadiusMm = info(Field::KnifeRadius).defaultValue; // to the knife's tip
    int knives = 1;
    int pulsesPerMotorRev = 10000; // K
    int gearNumerator = 1;         // Z = numerator / denominator motor revolutions per knife revolution
    int gearDenominator = 1;
    double maxMotorRpm = info(Field::MaxMotorRpm).defaultValue;
    double maxKnifeAccelerationMmPerS2 = info(Field::MaxKnifeAcceleration).defaultValue;
    double maxPulseFrequencyHz =
        info(Field::MaxPulseFrequency).defaultValue; // 200 kHz open collector, 500 kHz line driver
    double maxRateBagsPerMin = info(Field::MaxRate).defaultValue;
    double contactAngleDeg = info(Field::ContactAngle).defaultValue; // of the sealing jaws; 0: a thin knife

    // An axis other than the knife axis: a linear motion.
    double feedMmPerMotorRev = info(Field::FeedPerMotorRev).defaultValue;
    double maxAccelerationMmPerS2 = info(Field::MaxAcceleration).defaultValue;

    // The motor and what it turns, for the knife as for other axes. Inertia and friction are those of the
    // whole axis, referred to the motor shaft. Limits and inertia are unknown while they are 0.
    double maxTorqueNm = info(Field::MaxTorque).defaultValue;
    double ratedTorqueNm = info(Field::RatedTorque).defaultValue;
    double inertiaKgCm2 = info(Field::Inertia).defaultValue;
    double frictionNm = info(Field::Friction).defaultValue;
    // The lowest mode of the shaft behind the motor.
    double naturalFrequencyHz = info(Field::NaturalFrequency).defaultValue; // 0: unknown
    double dampingRatio = info(Field::DampingRatio).defaultValue;           // of critical damping

    // The figures from the controller's identity block.
    std::uint32_t timerClockHz = 8000000;
    int timerBits = 16;
    int rowCapacity = 2048;

    bool operator==(const Machine&) const = default;
};

[[nodiscard]] double value(const Machine& machine, Field field); // field must be one of the machine's
void setValue(Machine& machine, Field field, double value);      // integers are rounded

// The pulses of one cycle as an exact rational: whole + remainder / divisor, remainder < divisor.
struct PulsesPerCycle {
    std::int64_t whole = 0;
    std::int64_t remainder = 0;
    std::int64_t divisor = 1;

    [[nodiscard]] double asDouble() const
    {
        return static_cast<double>(whole) + static_cast<double>(remainder) / static_cast<double>(divisor);
    }
};

[[nodiscard]] PulsesPerCycle pulsesPerCycle(const Machine& machine); // K Z / N
[[nodiscard]] double strokeMm(const Machine& machine);               // h = 2 pi R / N
[[nodiscard]] double pulsesPerMm(const Machine& machine);            // K Z / (2 pi R), eq. 10 of the paper
[[nodiscard]] double motorRpmPerMmPerS(const Machine& machine);      // 60 Z / (2 pi R)

// The same figures for an axis other than the knife axis.
[[nodiscard]] double axisPulsesPerMm(const Machine& machine);  // K / feed
[[nodiscard]] double axisRpmPerMmPerS(const Machine& machine); // 60 / feed

// Returns the limits of the timer constant, in ticks per pulse. The minimum also limits the frequency: clock
// / smallest <= max.
[[nodiscard]] std::int64_t minTimerConstant(const Machine& machine);
[[nodiscard]] std::int64_t maxTimerConstant(const Machine& machine);
[[nodiscard]] double pulseFrequencyLimitHz(const Machine& machine);

} // namespace campanel::profile
