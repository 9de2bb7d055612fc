// SPDX-License-Identifier: Apache-2.0
// The properties of every solved or refused move, for tests with seeded random moves.
#pragma once

#include "profile/laws/laws.h"
#include "profile/model/axis_motion.h"
#include "profile/model/torque.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace campanel::profile::test {

inline bool near(double a, double b, double relative)
{
    return std::abs(a - b) <= relative * std::max({std::abs(a), std::abs(b), 1.0});
}

// Returns the motor of the servo paper on the default axis.
inline Machine paperMotor()
{
    Machine machine;
    machine.maxTorqueNm = 1.33;
    machine.inertiaKgCm2 = 0.2;
    machine.frictionNm = 0.02;
    return machine;
}

class RandomValues {
public:
    explicit RandomValues(unsigned seed)
        : m_random(seed)
    {
    }

    std::size_t pick(std::size_t count)
    {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(m_random);
    }
    double uniform(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(m_random);
    }
    // Returns a number on the field's grid, uniform over the decades; of either sign where the field has
    // both.
    double decades(Field field, double from, double to)
    {
        const double magnitude = std::exp(uniform(std::log(from), std::log(to)));
        const bool isNegative = info(field).min < 0 && pick(2) == 0;
        return snapToGrid(field, isNegative ? -magnitude : magnitude);
    }
    LawParameters parametersOf(const Law& law)
    {
        LawParameters parameters{};
        for (std::size_t i = 0; i < law.parameters.size(); ++i)
            parameters[i] = uniform(law.parameters[i].min, law.parameters[i].max);
        return parameters;
    }
    Machine machine()
    {
        Machine m;
        m.pulsesPerMotorRev = 100 + static_cast<int>(pick(20000));
        m.feedMmPerMotorRev = decades(Field::FeedPerMotorRev, 1, 1000);
        m.maxMotorRpm = decades(Field::MaxMotorRpm, 100, 10000);
        m.maxAccelerationMmPerS2 = decades(Field::MaxAcceleration, 100, 500000);
        m.maxPulseFrequencyHz = pick(2) == 0 ? 200000 : 500000;
        m.maxTorqueNm = decades(Field::MaxTorque, 0.1, 100);
        m.ratedTorqueNm = pick(3) == 0 ? 0 : decades(Field::RatedTorque, 0.05, 50);
        m.inertiaKgCm2 = pick(10) == 0 ? 0 : decades(Field::Inertia, 0.01, 100);
        m.frictionNm = pick(10) == 0 ? 0 : decades(Field::Friction, 0.001, 0.2);
        if (m.frictionNm == m.maxTorqueNm) // no torque is left, but by an amount that cannot be measured
            m.frictionNm = 0;
        if (m.ratedTorqueNm <= m.frictionNm) // no motion is possible
            m.ratedTorqueNm = 0;
        return m;
    }

private:
    std::mt19937 m_random;
};

inline bool isBeyondLimits(const MotionPoint& p, const Machine& m, double room)
{
    constexpr double roundingMmPerS = 1e-9;
    const double speed = std::abs(p.velocityMmPerS);
    const TorqueLoad load = axisLoad(m);
    // At a standstill, the direction of the motion before or behind it counts.
    const double torqueNm = speed > roundingMmPerS
                                ? std::abs(load.at(p.velocityMmPerS, p.accelerationMmPerS2))
                                : std::abs(load.at(-p.accelerationMmPerS2, p.accelerationMmPerS2));
    return speed * 60 / m.feedMmPerMotorRev > m.maxMotorRpm * (1 + room) ||
           speed * m.pulsesPerMotorRev / m.feedMmPerMotorRev > m.maxPulseFrequencyHz * (1 + room) ||
           std::abs(p.accelerationMmPerS2) > m.maxAccelerationMmPerS2 * (1 + room) ||
           (m.maxTorqueNm > 0 && torqueNm > m.maxTorqueNm * (1 + room));
}

// Checks by sampling: within the peaks, and within the machine's limits exactly when no limit is reported as
// exceeded.
inline void verifyAgainstSamples(const AxisMotion& solved, const Machine& machine)
{
    constexpr int samples = 200;
    const Peaks& peaks = solved.peaks;
    const double duration = solved.motion.durationS();
    for (int i = 0; i <= samples; ++i) {
        const MotionPoint p = solved.motion.at(duration * i / samples);
        QVERIFY(std::abs(p.velocityMmPerS) <= peaks.speedMmPerS * (1 + 1e-8));
        QVERIFY(std::abs(p.accelerationMmPerS2) <= peaks.accelerationMmPerS2 * (1 + 1e-8));
        QVERIFY(std::abs(p.jerkMmPerS3) <= peaks.jerkMmPerS3 * (1 + 1e-8));
        if (solved.broken.empty())
            QVERIFY2(!isBeyondLimits(p, machine, 1e-8), qPrintable(QStringLiteral("%1 s: %2 mm/s, %3 mm/s^2")
                                                                       .arg(duration * i / samples)
                                                                       .arg(p.velocityMmPerS)
                                                                       .arg(p.accelerationMmPerS2)));
    }
    for (const Refusal& refusal : solved.broken) {
        QVERIFY(refusal.actual > refusal.allowed);
        if (refusal.limit == Limit::RmsTorque) { // has no place
            QVERIFY(!refusal.timeS && refusal.brokenDuring.empty());
            QCOMPARE(refusal.actual, solved.peaks.rmsTorqueNm);
            continue;
        }
        QVERIFY(!refusal.brokenDuring.empty());
        // Just beside: at standstill there is no friction.
        QVERIFY(isBeyondLimits(solved.motion.at(*refusal.timeS), machine, 0) ||
                isBeyondLimits(solved.motion.at(*refusal.timeS + 1e-9 * duration), machine, -1e-6) ||
                isBeyondLimits(solved.motion.at(*refusal.timeS - 1e-9 * duration), machine, -1e-6));
        for (const TimeSpan& span : refusal.brokenDuring) {
            QVERIFY(span.fromS >= 0 && span.toS <= duration * (1 + 1e-12) && span.toS > span.fromS);
            // Not the middle: spans before and after a sudden zero are joined into one.
            QVERIFY(isBeyondLimits(solved.motion.at((3 * span.fromS + span.toS) / 4), machine, 0));
        }
    }
}

// Returns true when the program is feasible even without the tolerance of the limits.
template <typename Program> bool isClearlyFeasible(const Program& program, const Machine& machine)
{
    constexpr double clear = 1 - 2e-9;
    const auto solved = solve(program, machine);
    const AxisAllowance allowed = axisAllowance(machine);
    const bool isCool = !(machine.ratedTorqueNm > 0) || !solved ||
                        !(solved->peaks.rmsTorqueNm > machine.ratedTorqueNm * clear);
    return isCool && solved && solved->peaks.speedMmPerS <= allowed.speedMmPerS * clear &&
           solved->peaks.accelerationMmPerS2 <= machine.maxAccelerationMmPerS2 * clear &&
           solved->peaks.extremes.speedingMmPerS2 <= allowed.accelerationMmPerS2 * clear &&
           solved->peaks.extremes.slowingMmPerS2 <= allowed.slowingMmPerS2 * clear;
}

// Checks each suggestion: it is on its grid and corrects the program; the previous grid point does not.
template <typename Program>
void verifySuggestions(const Program& program, const Machine& machine, const Refusal& refusal)
{
    for (const Suggestion& s : refusal.nearest) {
        Program mended = program;
        Machine mendedMachine = machine;
        setValue(mended, s.field, s.value);
        setValue(mendedMachine, s.field, s.value);
        QVERIFY2(isFeasible(mended, mendedMachine), describe(refusal).c_str());
        QCOMPARE(snapToGrid(s.field, s.value), s.value);
        const double present = value(program, s.field);
        const double step = info(s.field).resolution() * (s.value > present ? -1 : 1);
        const double before = snapToGrid(s.field, s.value + step);
        if (!std::isfinite(present) || std::abs(s.value - present) < 1.5 * std::abs(step) ||
            before == s.value)
            continue;
        setValue(mended, s.field, before);
        QVERIFY2(!isClearlyFeasible(mended, machine),
                 describe(refusal).append(" Or ").append(std::to_string(before)).c_str());
    }
}

} // namespace campanel::profile::test
