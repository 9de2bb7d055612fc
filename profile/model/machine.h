// SPDX-License-Identifier: Apache-2.0
// The machine that a program runs on: knife, drive, gear, limits, and the controller's pulse timer and table
// size.
#pragma once

#include "profile/model/members.h"

#include <algorithm>
#include <cstdint>
#include <span>

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

// The kinds of machine that have a number. A person enters it unless it comes from the controller.
namespace machine_use {
inline constexpr unsigned knife = 1;
inline constexpr unsigned axis = 2; // of a move or a cam
inline constexpr unsigned press = 4;
inline constexpr unsigned fromController = 8;
inline constexpr unsigned scale = 16; // it ties pulses to travel
inline constexpr unsigned motor = knife | axis;
inline constexpr unsigned all = knife | axis | press;
} // namespace machine_use

template <>
inline constexpr std::array membersOf<Machine>{
    Member<Machine>{Field::KnifeRadius, &Machine::knifeRadiusMm, machine_use::knife | machine_use::scale},
    Member<Machine>{Field::Knives, &Machine::knives, machine_use::knife | machine_use::scale},
    Member<Machine>{Field::FeedPerMotorRev, &Machine::feedMmPerMotorRev,
                    machine_use::axis | machine_use::press | machine_use::scale},
    Member<Machine>{Field::PulsesPerMotorRev, &Machine::pulsesPerMotorRev,
                    machine_use::all | machine_use::scale},
    Member<Machine>{Field::GearNumerator, &Machine::gearNumerator, machine_use::knife | machine_use::scale},
    Member<Machine>{Field::GearDenominator, &Machine::gearDenominator,
                    machine_use::knife | machine_use::scale},
    Member<Machine>{Field::MaxMotorRpm, &Machine::maxMotorRpm, machine_use::all},
    Member<Machine>{Field::MaxKnifeAcceleration, &Machine::maxKnifeAccelerationMmPerS2, machine_use::knife},
    Member<Machine>{Field::MaxAcceleration, &Machine::maxAccelerationMmPerS2,
                    machine_use::axis | machine_use::press},
    Member<Machine>{Field::MaxPulseFrequency, &Machine::maxPulseFrequencyHz, machine_use::all},
    Member<Machine>{Field::MaxRate, &Machine::maxRateBagsPerMin, machine_use::knife},
    Member<Machine>{Field::MaxTorque, &Machine::maxTorqueNm, machine_use::motor},
    Member<Machine>{Field::RatedTorque, &Machine::ratedTorqueNm, machine_use::motor},
    Member<Machine>{Field::Inertia, &Machine::inertiaKgCm2, machine_use::motor},
    Member<Machine>{Field::Friction, &Machine::frictionNm, machine_use::motor},
    Member<Machine>{Field::NaturalFrequency, &Machine::naturalFrequencyHz, machine_use::motor},
    Member<Machine>{Field::DampingRatio, &Machine::dampingRatio, machine_use::motor},
    Member<Machine>{Field::ContactAngle, &Machine::contactAngleDeg, machine_use::knife},
    Member<Machine>{Field::TimerClock, &Machine::timerClockHz,
                    machine_use::motor | machine_use::fromController},
    Member<Machine>{Field::TimerBits, &Machine::timerBits, machine_use::knife | machine_use::fromController},
    Member<Machine>{Field::RowCapacity, &Machine::rowCapacity,
                    machine_use::knife | machine_use::fromController},
};

// The numbers that a person enters for this use.
template <unsigned use>
inline constexpr auto machineFields = [] {
    constexpr auto isEntered = [](const Member<Machine>& member) {
        return (member.uses & use) != 0 && (member.uses & machine_use::fromController) == 0;
    };
    return fieldsOf<Machine, std::ranges::count_if(membersOf<Machine>, isEntered)>(isEntered);
}();

// Returns true when a pulse is the same travel on both machines, compared by those of `used` that say so.
[[nodiscard]] bool isSameScale(const Machine& left, const Machine& right, std::span<const Field> used);

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
