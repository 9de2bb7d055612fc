// SPDX-License-Identifier: Apache-2.0
// Peaks of every form of segment against dense sampling, steps of the acceleration, and exceeded limits with
// their place and time spans.
#include "move_checks.h"

#include "profile/cutter/sampling.h"
#include "tests/support/test_program.h"

namespace test_axis_motion {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

const Law& quintic()
{
    return *findLaw(LawId::Quintic);
}

// Returns a motion that rises, runs, and returns by cubic pieces, with an added speed in between.
MotionProfile mixedMotion()
{
    MotionProfile motion;
    motion.addRamp(0.4, 0, 300, *findLaw(LawId::HalfModifiedSine), {}, false);
    motion.addConstant(0.2, 300);
    motion.addDisplacement(0.5, -120, quintic(), {}, 300);
    motion.addRamp(0.3, 300, -100, *findLaw(LawId::HalfModifiedSine), {}, true);
    motion.addCubic(0.8, -100, -50, 400);
    return motion;
}

Peaks sampledPeaks(const MotionProfile& motion)
{
    Peaks seen;
    constexpr int samples = 100000;
    for (const Segment& segment : motion.segments()) {
        for (int i = 0; i <= samples; ++i) {
            const MotionPoint p = segment.at(segment.startS + segment.durationS * i / samples);
            seen.speedMmPerS = std::max(seen.speedMmPerS, std::abs(p.velocityMmPerS));
            seen.accelerationMmPerS2 = std::max(seen.accelerationMmPerS2, std::abs(p.accelerationMmPerS2));
            seen.jerkMmPerS3 = std::max(seen.jerkMmPerS3, std::abs(p.jerkMmPerS3));
        }
    }
    return seen;
}

Machine strongMachine()
{
    Machine machine = paperMotor();
    machine.maxMotorRpm = 20000;
    machine.maxAccelerationMmPerS2 = 1e7;
    machine.maxTorqueNm = 1000;
    machine.maxPulseFrequencyHz = 4e6;
    return machine;
}

const Refusal* find(const std::vector<Refusal>& broken, Limit limit)
{
    const auto found =
        std::find_if(broken.begin(), broken.end(), [limit](const Refusal& r) { return r.limit == limit; });
    return found == broken.end() ? nullptr : &*found;
}

std::vector<Refusal> check(const MotionProfile& motion, const Machine& machine)
{
    return checkAxis(motion, axisPeaks(motion, machine), machine);
}

} // namespace

class TestAxisMotion : public QObject {
    Q_OBJECT

private slots:
    void peaksAgreeWithSampling_data();
    void peaksAgreeWithSampling();
    void peaksOfAMixedMotion();
    void parabolaTurnsInside();
    void jerkIsInfiniteAtSteps();
    void unitsOfTheMotor();
    void nothingMoves();
    void spansOfSpeed();
    void spansOnBothSidesOfZero();
    void spansOfATrapezoid();
    void frictionAlone();
    void pulseFrequencyOfTheTimer();
    void curvesKeepBothSidesOfAJoint();
};

void TestAxisMotion::peaksAgreeWithSampling_data()
{
    QTest::addColumn<int>("law");
    QTest::addColumn<bool>("isDisplacement");
    QTest::addColumn<bool>("isMirrored");
    for (const Law& law : laws()) {
        const std::string key(law.key);
        QTest::newRow((key + " ramp").c_str()) << static_cast<int>(law.id) << false << false;
        QTest::newRow((key + " ramp mirrored").c_str()) << static_cast<int>(law.id) << false << true;
        if (law.isDisplacementLaw)
            QTest::newRow((key + " displacement").c_str()) << static_cast<int>(law.id) << true << false;
    }
}

void TestAxisMotion::peaksAgreeWithSampling()
{
    QFETCH(int, law);
    QFETCH(bool, isDisplacement);
    QFETCH(bool, isMirrored);
    const Law& used = *findLaw(static_cast<LawId>(law));
    MotionProfile motion;
    if (isDisplacement)
        motion.addDisplacement(0.7, -90, used, defaultParameters(used), 20);
    else
        motion.addRamp(0.7, 500, -200, used, defaultParameters(used), isMirrored);
    const Peaks peaks = axisPeaks(motion, Machine());
    const Peaks seen = sampledPeaks(motion);
    QVERIFY(near(peaks.speedMmPerS, seen.speedMmPerS, 1e-8));
    QVERIFY(near(peaks.accelerationMmPerS2, seen.accelerationMmPerS2, 1e-6));
    if (std::isfinite(peaks.jerkMmPerS3))
        QVERIFY(near(peaks.jerkMmPerS3, seen.jerkMmPerS3, 1e-6));
    const MotionPoint fastest = motion.at(peaks.speedTimeS);
    const MotionPoint hardest = motion.at(peaks.accelerationTimeS);
    QVERIFY(near(std::abs(fastest.velocityMmPerS), peaks.speedMmPerS, 1e-9));
    QVERIFY(near(std::abs(hardest.accelerationMmPerS2), peaks.accelerationMmPerS2, 1e-9));
}

void TestAxisMotion::peaksOfAMixedMotion()
{
    const MotionProfile motion = mixedMotion();
    const Peaks peaks = axisPeaks(motion, Machine());
    const Peaks seen = sampledPeaks(motion);
    QVERIFY(near(peaks.speedMmPerS, seen.speedMmPerS, 1e-9));
    QVERIFY(near(peaks.accelerationMmPerS2, seen.accelerationMmPerS2, 1e-8));
    QCOMPARE(peaks.accelerationMmPerS2, 120 * 10 / std::sqrt(3.0) / 0.25);
    QVERIFY(std::isinf(peaks.jerkMmPerS3)); // the cubic begins with an acceleration
}

void TestAxisMotion::parabolaTurnsInside()
{
    MotionProfile motion; // v = -100 - 50 t + 200 t^2 has its minimum at t = 1/8
    motion.addCubic(0.5, -100, -50, 400);
    const Peaks peaks = axisPeaks(motion, Machine());
    QCOMPARE(peaks.speedMmPerS, 103.125);
    QCOMPARE(peaks.speedTimeS, 0.125);
    QCOMPARE(peaks.accelerationMmPerS2, 150.0);
    QCOMPARE(peaks.accelerationTimeS, 0.5);
}

void TestAxisMotion::jerkIsInfiniteAtSteps()
{
    const auto jerk = [](auto add) {
        MotionProfile motion;
        add(motion);
        return axisPeaks(motion, Machine()).jerkMmPerS3;
    };
    const auto displacement = [&jerk](LawId id) {
        const Law& law = *findLaw(id);
        return jerk([&](MotionProfile& m) { m.addDisplacement(2, 100, law, defaultParameters(law)); });
    };
    const auto ramp = [&jerk](LawId id, bool isMirrored) {
        const Law& law = *findLaw(id);
        return jerk([&](MotionProfile& m) { m.addRamp(2, 0, 100, law, defaultParameters(law), isMirrored); });
    };
    QCOMPARE(displacement(LawId::Quintic), 100 * 60 / 8.0);
    QVERIFY(std::isinf(displacement(LawId::Cubic))); // from rest and to rest
    QVERIFY(std::isinf(displacement(LawId::Harmonic)));
    QVERIFY(std::isinf(displacement(LawId::Parabolic)));
    QCOMPARE(ramp(LawId::Cubic, false), 100 * 6 / 4.0);
    QCOMPARE(ramp(LawId::Parabolic, false), 100 * 4 / 4.0);
    QVERIFY(std::isinf(ramp(LawId::Exponential, false)));
    QVERIFY(std::isinf(ramp(LawId::Exponential, true)));
    // A closed cam may repeat: there is no step when it ends as it began.
    QCOMPARE(jerk([](MotionProfile& m) {
                 m.addCubic(1, 0, 6, -12);
                 m.addCubic(1, 0, -6, 12);
             }),
             12.0);
    QVERIFY(std::isinf(jerk([](MotionProfile& m) {
        m.addCubic(1, 0, 6, -12);
        m.addCubic(1, 0, -5, 10);
    })));
}

void TestAxisMotion::unitsOfTheMotor()
{
    MotionProfile motion;
    motion.addDisplacement(1, 6000, quintic(), {});
    const Peaks peaks = axisPeaks(motion, paperMotor()); // 100 mm and 10 000 pulses per revolution
    QCOMPARE(peaks.speedMmPerS, 11250.0);
    QCOMPARE(peaks.motorRpm, 6750.0);
    QCOMPARE(peaks.pulseFrequencyHz, 1125000.0);
    QVERIFY(near(peaks.accelerationMmPerS2, 34641.016, 1e-7));
    // 0.2 kg cm^2 at 2 pi 346.41 rad/s^2, and 0.02 Nm of friction.
    QVERIFY(near(peaks.torqueNm, 0.2e-4 * 2 * std::acos(-1.0) * 346.41016 + 0.02, 1e-8));
}

void TestAxisMotion::nothingMoves()
{
    MotionProfile motion;
    QCOMPARE(axisPeaks(motion, Machine()).speedMmPerS, 0.0);
    motion.addDisplacement(1, 0, *findLaw(LawId::Parabolic), {});
    motion.addRamp(1, 0, 0, *findLaw(LawId::Cubic), {}, false);
    motion.addCubic(1, 0, 0, 0);
    const Peaks peaks = axisPeaks(motion, Machine());
    QCOMPARE(peaks.speedMmPerS, 0.0);
    QCOMPARE(peaks.accelerationMmPerS2, 0.0);
    QCOMPARE(peaks.jerkMmPerS3, 0.0);
    QVERIFY(check(motion, Machine()).empty());
}

void TestAxisMotion::spansOfSpeed()
{
    Machine machine = strongMachine();
    machine.maxMotorRpm = 3000; // 5000 mm/s
    MotionProfile motion;
    motion.addDisplacement(1, 6000, quintic(), {});
    const std::vector<Refusal> broken = check(motion, machine);
    QCOMPARE(broken.size(), std::size_t{1});
    const Refusal& refusal = broken.front();
    QCOMPARE(refusal.limit, Limit::MotorSpeed);
    QCOMPARE(refusal.field, Field::MaxMotorRpm);
    QCOMPARE(refusal.actual, 6750.0);
    QCOMPARE(refusal.allowed, 3000.0);
    QCOMPARE(*refusal.timeS, 0.5);
    QCOMPARE(refusal.brokenDuring.size(), std::size_t{1});
    const TimeSpan span = refusal.brokenDuring.front();
    QVERIFY(near(motion.at(span.fromS).velocityMmPerS, 5000, 1e-8));
    QVERIFY(near(motion.at(span.toS).velocityMmPerS, 5000, 1e-8));
    QVERIFY(near(span.fromS + span.toS, 1, 1e-8));
    QVERIFY(!isWithinLimits(axisPeaks(motion, machine), machine));
    machine.maxMotorRpm = 6750;
    QVERIFY(check(motion, machine).empty());
    QVERIFY(isWithinLimits(axisPeaks(motion, machine), machine));
}

void TestAxisMotion::spansOnBothSidesOfZero()
{
    Machine machine = strongMachine();
    machine.maxMotorRpm = 600; // 1000 mm/s
    MotionProfile motion;
    motion.addRamp(2, -2000, 1500, *findLaw(LawId::Cubic), {}, false);
    const std::vector<Refusal> broken = check(motion, machine);
    QCOMPARE(broken.size(), std::size_t{1});
    const auto& spans = broken.front().brokenDuring;
    QCOMPARE(spans.size(), std::size_t{2});
    QCOMPARE(spans[0].fromS, 0.0);
    QVERIFY(near(motion.at(spans[0].toS).velocityMmPerS, -1000, 1e-8));
    QVERIFY(near(motion.at(spans[1].fromS).velocityMmPerS, 1000, 1e-8));
    QCOMPARE(spans[1].toS, 2.0);
}

void TestAxisMotion::spansOfATrapezoid()
{
    const Law& law = *findLaw(LawId::Trapezoid);
    const Law& parabola = *findLaw(LawId::Parabolic);
    MotionProfile motion;
    motion.addDisplacement(1, 600, law, {0.2, 0}); // 3750 mm/s^2 during the first and the last fifth
    Machine machine = strongMachine();
    machine.maxAccelerationMmPerS2 = 3000;
    machine.maxTorqueNm = 0.024;
    const std::vector<Refusal> broken = check(motion, machine);
    QCOMPARE(broken.size(), std::size_t{2});
    const Refusal* acceleration = find(broken, Limit::AxisAcceleration);
    QVERIFY(acceleration != nullptr);
    QCOMPARE(acceleration->brokenDuring.size(), std::size_t{2});
    QVERIFY(near(acceleration->brokenDuring[0].toS, 0.2, 1e-9));
    QVERIFY(near(acceleration->brokenDuring[1].fromS, 0.8, 1e-9));
    QCOMPARE(acceleration->brokenDuring[1].toS, 1.0);
    const Refusal* torque = find(broken, Limit::MotorTorque); // 0.0247 Nm; friction helps to brake
    QVERIFY(torque != nullptr);
    QCOMPARE(torque->brokenDuring.size(), std::size_t{1});
    QVERIFY(near(torque->brokenDuring[0].toS, 0.2, 1e-9));
    MotionProfile always;
    always.addDisplacement(1, 1000, parabola, {});
    QCOMPARE(check(always, machine).front().brokenDuring.size(), std::size_t{1});
}

void TestAxisMotion::frictionAlone()
{
    Machine machine = strongMachine();
    machine.frictionNm = 2;
    machine.maxTorqueNm = 1.5;
    MotionProfile motion;
    motion.addConstant(3, 10);
    const std::vector<Refusal> broken = check(motion, machine);
    QCOMPARE(broken.size(), std::size_t{1});
    QCOMPARE(broken.front().limit, Limit::MotorTorque);
    QCOMPARE(broken.front().brokenDuring.front().toS, 3.0);
    QVERIFY(axisAllowance(machine).accelerationMmPerS2 < 0);
    machine.frictionNm = 1.5; // no torque is left to accelerate
    QCOMPARE(axisAllowance(machine).accelerationMmPerS2, 0.0);
    QVERIFY(check(motion, machine).empty());
    MotionProfile gentle;
    gentle.addDisplacement(100, 0.001, quintic(), {});
    QCOMPARE(check(gentle, machine).front().limit, Limit::MotorTorque);
    machine.frictionNm = 2;
    machine.inertiaKgCm2 = 0; // unknown, and so is the torque
    QCOMPARE(axisAllowance(machine).accelerationMmPerS2, machine.maxAccelerationMmPerS2);
    QVERIFY(std::isnan(axisPeaks(motion, machine).torqueNm));
    QVERIFY(check(motion, machine).empty());
}

void TestAxisMotion::pulseFrequencyOfTheTimer()
{
    Machine machine = strongMachine();
    machine.maxPulseFrequencyHz = 300000; // 27 ticks of 8 MHz: 296 296 Hz
    MotionProfile motion;
    motion.addConstant(1, 2980); // 298 000 Hz
    const std::vector<Refusal> broken = check(motion, machine);
    QCOMPARE(broken.size(), std::size_t{1});
    QCOMPARE(broken.front().limit, Limit::PulseFrequency);
    QCOMPARE(broken.front().allowed, 8e6 / 27);
    QCOMPARE(axisAllowance(machine).speedMmPerS, 8e6 / 27 / 100);
}

void TestAxisMotion::curvesKeepBothSidesOfAJoint()
{
    const MotionProfile motion = mixedMotion();
    const Curves curves = sampleCurves(motion, 100, 500);
    QCOMPARE(curves.timeS.front(), 0.0);
    QCOMPARE(curves.timeS.back(), motion.durationS());
    const double joint = motion.segments()[4].startS;
    const auto after = std::upper_bound(curves.timeS.begin(), curves.timeS.end(), joint);
    const auto i = static_cast<std::size_t>(after - curves.timeS.begin());
    QCOMPARE(curves.timeS[i - 2], joint);
    QCOMPARE(curves.timeS[i - 1], joint);
    QVERIFY(std::abs(curves.accelerationMmPerS2[i - 2]) < 1e-9);
    QCOMPARE(curves.accelerationMmPerS2[i - 1], -50.0);
    QCOMPARE(curves.frequencyHz[i - 1], -10000.0);
}

CAMPANEL_TEST(TestAxisMotion)

} // namespace test_axis_motion

#include "test_axis_motion.moc"
