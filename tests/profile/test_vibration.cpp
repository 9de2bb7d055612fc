// SPDX-License-Identifier: Apache-2.0
// Vibration: published numbers, an integration of the same mode for random cams, refused natural frequencies.
#include "random_cams.h"
#include "random_segments.h"
#include "recipes.h"

#include "profile/cam/point_cam.h"
#include "profile/cutter/limits.h"
#include "profile/model/vibration.h"
#include "profile/moves/position_move.h"
#include "profile/segments/segment_cam.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace test_vibration {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

constexpr unsigned seed = 20261124;

Recipe shaftRecipe(double naturalFrequencyHz, std::array<double, 4> k)
{
    Recipe recipe = checkRecipe(150, 200);
    recipe.program.k = k;
    recipe.machine.naturalFrequencyHz = naturalFrequencyHz;
    recipe.machine.dampingRatio = 0.05;
    return recipe;
}

// The mode itself, x'' = w^2 (u - x) - 2 z w x', by Runge-Kutta in small steps.
class IntegratedMode {
public:
    IntegratedMode(const MotionProfile& motion, double frequencyHz, double damping)
        : m_motion(motion)
        , m_w(2 * std::numbers::pi * frequencyHz)
        , m_damping(damping)
        , m_position(motion.at(0).positionMm)
        , m_speed(motion.at(0).velocityMmPerS)
    {
    }

    // Advances over one cycle; the error inside the window goes to low and high.
    void cycle(double fromS, double toS, double& low, double& high)
    {
        const double cycleS = m_motion.durationS();
        const double net = m_motion.at(cycleS).positionMm - m_motion.at(0).positionMm;
        const int steps = static_cast<int>(std::ceil(cycleS * std::max(4000 / cycleS, 100 * m_w / 6.28)));
        const double h = cycleS / steps;
        double before = m_position - m_motion.at(0).positionMm;
        const auto take = [&](double error) {
            low = std::min(low, error);
            high = std::max(high, error);
        };
        for (int i = 0; i < steps; ++i) {
            const double t = i * h;
            step(t, h);
            const double error = m_position - m_motion.at(t + h).positionMm;
            for (const double edge : {fromS, toS}) {
                if (t <= edge && edge <= t + h)
                    take(before + (error - before) * (edge - t) / h);
            }
            if (t >= fromS && t + h <= toS)
                take(error);
            before = error;
        }
        m_position -= net;
    }

private:
    double rate(double t, double x, double v) const
    {
        return m_w * m_w * (m_motion.at(t).positionMm - x) - 2 * m_damping * m_w * v;
    }
    void step(double t, double h)
    {
        const double x = m_position;
        const double v = m_speed;
        const double a1 = rate(t, x, v);
        const double a2 = rate(t + h / 2, x + h / 2 * v, v + h / 2 * a1);
        const double v2 = v + h / 2 * a1;
        const double v3 = v + h / 2 * a2;
        const double a3 = rate(t + h / 2, x + h / 2 * v2, v3);
        const double v4 = v + h * a3;
        const double a4 = rate(t + h, x + h * v3, v4);
        m_position = x + h / 6 * (v + 2 * v2 + 2 * v3 + v4);
        m_speed = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }

    const MotionProfile& m_motion;
    double m_w;
    double m_damping;
    double m_position;
    double m_speed;
};

} // namespace

class TestVibration : public QObject {
    Q_OBJECT

private slots:
    void windowOfTheCheckRecipe_data();
    void windowOfTheCheckRecipe();
    void agreesWithAnIntegration();
    void residualOfMoves();
    void residualAgreesWithAnIntegration();
    void camAgreesWithAnIntegration();
    void unknownModeIsNoNumber();
    void naturalFrequencyBelowTheCycle();
    void naturalFrequencyBelowACam();
};

void TestVibration::windowOfTheCheckRecipe_data()
{
    QTest::addColumn<double>("frequencyHz");
    QTest::addColumn<bool>("isLong");
    QTest::addColumn<double>("errorMm");
    // Calculated with the sum over harmonics: 6.209, 1.720, 0.5222; 1.809, 0.2687, 0.08948.
    QTest::newRow("default ramps, 15 Hz") << 15.0 << false << 6.209;
    QTest::newRow("default ramps, 25 Hz") << 25.0 << false << 1.720;
    QTest::newRow("default ramps, 40 Hz") << 40.0 << false << 0.5222;
    QTest::newRow("longest ramps, 15 Hz") << 15.0 << true << 1.809;
    QTest::newRow("longest ramps, 25 Hz") << 25.0 << true << 0.2687;
    QTest::newRow("longest ramps, 40 Hz") << 40.0 << true << 0.08948;
}

void TestVibration::windowOfTheCheckRecipe()
{
    QFETCH(double, frequencyHz);
    QFETCH(bool, isLong);
    QFETCH(double, errorMm);
    const std::array<double, 4> ratios =
        isLong ? std::array{1000.0, 2.5, 1.6667, 1.001} : std::array{4.0, 2.5, 1.6667, 1.3333};
    const Recipe r = shaftRecipe(frequencyHz, ratios);
    const double found = sealErrorMm(*solve(r.program, r.machine));
    QVERIFY2(std::abs(found / errorMm - 1) < 0.003, qPrintable(QString::number(found)));
}

void TestVibration::agreesWithAnIntegration()
{
    qInfo("seed %u", seed);
    RandomRecipes random(seed);
    int compared = 0;
    double worst = 0;
    while (compared < 100) {
        const Recipe r = random.next();
        const auto cutter = solve(r.program, r.machine);
        if (!cutter || !checkLimits(*cutter).empty())
            continue;
        const double cycleS = cutter->cycle.cycleTimeS;
        const double frequency = random.uniform(1.2, 20) / cycleS;
        const double damping = random.uniform(0.03, 0.4);
        const double fromS = cutter->cycle.tbS;
        const double toS = cutter->cycle.tcS;
        const double found = windowErrorMm(cutter->motion, fromS, toS, {frequency, damping});
        IntegratedMode mode(cutter->motion, frequency, damping);
        // Until what is left of the beginning has decayed to a millionth.
        const int cycles = 2 + static_cast<int>(14 / (damping * 2 * std::numbers::pi * frequency * cycleS));
        double low = 0;
        double high = 0;
        for (int i = 0; i < cycles; ++i) {
            low = std::numeric_limits<double>::max();
            high = std::numeric_limits<double>::lowest();
            mode.cycle(fromS, toS, low, high);
        }
        const double expected = high - low;
        // A thousandth of a micrometer is the rounding of the integration.
        const double difference = std::abs(found - expected) / (expected + 1e-4);
        worst = std::max(worst, difference);
        QVERIFY2(difference < 0.01, qPrintable(QStringLiteral("%1 mm, not %2 mm").arg(found).arg(expected)));
        ++compared;
    }
    qInfo("100 cams, largest difference %.3f %%", 100 * worst);
}

void TestVibration::residualOfMoves()
{
    const auto strokes = [](LawId law, double frequency) {
        MotionProfile motion;
        motion.addDisplacement(0.5, 100, *findLaw(law), {});
        return residualAmplitudeMm(motion, {frequency / 0.5, 0.05}) / 100;
    };
    QVERIFY(std::abs(strokes(LawId::Quintic, 2) - 0.02887) < 0.5e-5);
    QVERIFY(std::abs(strokes(LawId::Quintic, 3) - 0.00570) < 0.5e-5);
    QVERIFY(strokes(LawId::Cycloidal, 2) < 1e-5);
}

// An undamped mode that began at rest keeps its amplitude after the move.
void TestVibration::residualAgreesWithAnIntegration()
{
    for (const Law& law : laws()) {
        if (!law.isDisplacementLaw)
            continue;
        MotionProfile motion;
        motion.addDisplacement(0.4, 50, law, defaultParameters(law));
        MotionProfile observed = motion;
        observed.addConstant(1, 0);
        for (const double frequency : {1.7, 4.3, 11.0}) {
            const double found = residualAmplitudeMm(motion, {frequency, 0.05});
            IntegratedMode mode(observed, frequency, 0);
            double low = 0;
            double high = 0;
            mode.cycle(0.4, 1.4, low, high);
            QVERIFY2(std::abs(found - (high - low) / 2) <= 0.01 * found + 1e-4,
                     qPrintable(QStringLiteral("%1: %2, not %3")
                                    .arg(QLatin1StringView(law.key.data()))
                                    .arg(found)
                                    .arg((high - low) / 2)));
        }
    }
}

// Splines of every end, with their steps of speed at the wrap, and segments with steps at their joints.
void TestVibration::camAgreesWithAnIntegration()
{
    qInfo("seed %u", seed);
    RandomCams splines(seed);
    RandomSegments segments(seed);
    double worst = 0;
    for (int compared = 0; compared < 100;) {
        const auto solved = [&]() -> tl::expected<AxisMotion, Refusal> {
            if (compared % 2 == 0) {
                const auto cam = splines.next();
                return solve(cam.program, cam.machine);
            }
            const auto cam = segments.next();
            return solve(cam.program, cam.machine);
        }();
        if (!solved)
            continue;
        const MotionProfile& motion = solved->motion;
        const double cycleS = motion.durationS();
        const ShaftMode shaft{splines.uniform(1.5, 12) / cycleS, splines.uniform(0.03, 0.3)};
        const double found = cycleErrorMm(motion, shaft);
        IntegratedMode mode(motion, shaft.naturalFrequencyHz, shaft.dampingRatio);
        const double decayPerCycle =
            2 * std::numbers::pi * shaft.naturalFrequencyHz * shaft.dampingRatio * cycleS;
        double low = 0;
        double high = 0;
        for (int cycle = 0; cycle < 2 + static_cast<int>(9 / decayPerCycle); ++cycle) {
            low = std::numeric_limits<double>::max();
            high = std::numeric_limits<double>::lowest();
            mode.cycle(0, cycleS, low, high);
        }
        const double difference = std::abs(found - (high - low)) / (high - low + 0.01);
        worst = std::max(worst, difference);
        QVERIFY2(difference < 0.01,
                 qPrintable(QStringLiteral("%1: %2 mm, not %3 mm").arg(compared).arg(found).arg(high - low)));
        ++compared;
    }
    qInfo("100 cams, largest difference %.3f %%", 100 * worst);
}

void TestVibration::unknownModeIsNoNumber()
{
    const Recipe r = checkRecipe();
    QVERIFY(std::isnan(sealErrorMm(*solve(r.program, r.machine))));
    QVERIFY(checkLimits(*solve(r.program, r.machine)).empty());
    QVERIFY(std::isnan(residualAmplitudeMm(MotionProfile(), {25, 0.05})));
}

void TestVibration::naturalFrequencyBelowTheCycle()
{
    const Recipe r = shaftRecipe(3.2, {4, 2.5, 1.6667, 1.3333}); // 200 bags/min are 3.33 Hz
    const auto cutter = solve(r.program, r.machine);
    const std::vector<Refusal> broken = checkLimits(*cutter);
    QCOMPARE(broken.size(), std::size_t{1});
    const Refusal& refusal = broken.front();
    QCOMPARE(refusal.limit, Limit::NaturalFrequency);
    QCOMPARE(refusal.field, Field::NaturalFrequency);
    QVERIFY(std::abs(refusal.actual - 10.0 / 3) < 1e-9);
    QCOMPARE(refusal.allowed, 3.2);
    QCOMPARE(refusal.nearest.size(), std::size_t{2});
    QCOMPARE(refusal.nearest[0].field, Field::Rate);
    QCOMPARE(refusal.nearest[0].value, 192.0);
    QCOMPARE(refusal.nearest[1].field, Field::NaturalFrequency);
    QCOMPARE(refusal.nearest[1].value, 3.4);
    QCOMPARE(fastestRate(*cutter)->limitedBy, Limit::NaturalFrequency);
}

void TestVibration::naturalFrequencyBelowACam()
{
    PointCamProgram program;
    program.masterRateRevPerMin = 120;
    Machine machine;
    machine.maxMotorRpm = 7200;
    machine.naturalFrequencyHz = 1.5;
    const auto cam = solve(program, machine);
    QVERIFY(cam.has_value());
    QCOMPARE(cam->broken.size(), std::size_t{1});
    QCOMPARE(cam->broken[0].limit, Limit::NaturalFrequency);
    QCOMPARE(cam->broken[0].actual, 2.0);
    QCOMPARE(cam->broken[0].nearest.size(), std::size_t{1});
    QCOMPARE(cam->broken[0].nearest[0].value, 90.0);
    program.masterRateRevPerMin = 90;
    QVERIFY(solve(program, machine)->broken.empty());
}

CAMPANEL_TEST(TestVibration)

} // namespace test_vibration

#include "test_vibration.moc"
