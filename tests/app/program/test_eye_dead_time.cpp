// SPDX-License-Identifier: Apache-2.0
// The dead time of a product eye, measured with one part at two speeds. What is true stands here; the places
// with their expected results were computed apart, with Python.
#include "app/program/eye_dead_time.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <cmath>
#include <random>

namespace test_eye_dead_time {

using campanel::modbus::EyeEdge;
using campanel::program::EyeDeadTime;

namespace {

constexpr double stepsPerPitch = 65536.0;

// A part that begins and ends at places of the pitch, seen late by a time of each edge.
struct Part {
    double begin = 0.2;
    double end = 0.5;
    double beginMs = 1.0;
    double endMs = 2.5;
    double knownMs = 0.0;  // what the controller takes off
    double scatter = 4e-4; // 0.2 mm of 500
    double jitterOfSpeed = 0.002;
};

class Source {
public:
    explicit Source(EyeDeadTime& measurement)
        : m_measurement(measurement)
    {
    }
    void pass(const Part& part, double perS, int times)
    {
        for (int i = 0; i < times; ++i) {
            see(part, perS, part.begin, part.beginMs, true);
            see(part, perS, part.end, part.endMs, false);
        }
    }
    void restart() { m_number = 0; }

private:
    void see(const Part& part, double perS, double place, double lateMs, bool begins)
    {
        std::normal_distribution<double> normal;
        const double at = place + (lateMs - part.knownMs) / 1000.0 * perS + part.scatter * normal(m_random);
        const double turn = at - std::floor(at);
        const double speed = perS * (1.0 + part.jitterOfSpeed * normal(m_random));
        m_measurement.take({++m_number, static_cast<std::uint16_t>(std::lround(turn * stepsPerPitch)), speed,
                            begins, part.knownMs});
    }

    EyeDeadTime& m_measurement;
    std::mt19937 m_random{3};
    std::uint32_t m_number = 0;
};

} // namespace

class TestEyeDeadTime : public QObject {
    Q_OBJECT

private slots:
    // Twelve edges at each of two speeds; mean difference and its standard deviation by Python.
    void agreesWithNumbersComputedApart()
    {
        constexpr std::array<int, 12> slow{13180, 13172, 13169, 13177, 13183, 13165,
                                           13174, 13179, 13170, 13176, 13168, 13181};
        constexpr std::array<int, 12> fast{13370, 13379, 13366, 13361, 13375, 13383,
                                           13372, 13367, 13378, 13364, 13371, 13376};
        EyeDeadTime measurement;
        std::uint32_t number = 0;
        const auto see = [&](int place, double perS) {
            measurement.take({++number, static_cast<std::uint16_t>(place), perS, true, 0.0});
        };
        see(slow[0], 1.0); // the first edge at a speed is not known to be at an even one
        for (const int place : slow)
            see(place, 1.0);
        see(fast[0], 4.0);
        for (const int place : fast)
            see(place, 4.0);
        const auto found = measurement.measured(EyeDeadTime::Begin);
        QVERIFY(found);
        QVERIFY2(std::abs(found->ms - 1.003689236) < 1e-6, qPrintable(QString::number(found->ms, 'g', 12)));
        QVERIFY2(std::abs(found->marginMs - 0.012866325) < 1e-6,
                 qPrintable(QString::number(found->marginMs, 'g', 12)));
        QVERIFY(!measurement.measured(EyeDeadTime::End));
    }

    void findsBothEdges_data()
    {
        QTest::addColumn<double>("begin");
        QTest::addColumn<double>("knownMs");
        QTest::newRow("none entered") << 0.2 << 0.0;
        QTest::newRow("0.8 ms taken off") << 0.2 << 0.8;
        QTest::newRow("across the beginning of the pitch") << 0.999 << 0.0;
        QTest::newRow("entered too long") << 0.2 << 6.0;
    }
    void findsBothEdges()
    {
        QFETCH(double, begin);
        QFETCH(double, knownMs);
        EyeDeadTime measurement;
        Source source(measurement);
        const Part part{.begin = begin, .knownMs = knownMs};
        source.pass(part, 1.0, 40);
        QVERIFY(!measurement.measured(EyeDeadTime::Begin)); // one speed says nothing
        source.pass(part, 4.0, 40);
        for (const auto& [edge, ms] :
             {std::pair(EyeDeadTime::Begin, part.beginMs), std::pair(EyeDeadTime::End, part.endMs)}) {
            const auto found = measurement.measured(edge);
            QVERIFY(found);
            QVERIFY2(std::abs(found->ms - ms) <= std::max(3 * found->marginMs, 0.02),
                     qPrintable(QString::number(found->ms)));
            QVERIFY2(found->marginMs < 0.06, qPrintable(QString::number(found->marginMs)));
            const auto offered = measurement.offered(edge, knownMs);
            QVERIFY(offered && std::abs(*offered - ms) <= 0.15);
            QVERIFY(!measurement.offered(edge, ms)); // as entered
        }
    }

    // Products that lie with 2 mm of scatter on a pitch of 500 mm, however many.
    void scatteredProductsAreNotOffered_data()
    {
        QTest::addColumn<int>("edges");
        QTest::newRow("120 edges") << 30;
        QTest::newRow("800 edges") << 200;
    }
    void scatteredProductsAreNotOffered()
    {
        QFETCH(int, edges);
        EyeDeadTime measurement;
        Source source(measurement);
        const Part products{.scatter = 2.0 / 500.0};
        source.pass(products, 1.0, edges);
        source.pass(products, 5.0, edges);
        const auto found = measurement.measured(EyeDeadTime::Begin);
        QVERIFY(found);
        QVERIFY2(found->marginMs > EyeDeadTime::maxMarginMs, qPrintable(QString::number(found->marginMs)));
        QVERIFY(!measurement.offered(EyeDeadTime::Begin, 0.0));
        QVERIFY(!measurement.offered(EyeDeadTime::End, 0.0));
    }

    // The place of another part says nothing of the eye.
    void anotherPartIsNotMixedIn()
    {
        EyeDeadTime measurement;
        Source source(measurement);
        source.pass({.scatter = 2.0 / 500.0}, 5.0, 60); // products, then one part
        source.pass({.begin = 0.21, .end = 0.51}, 1.0, 40);
        QVERIFY(!measurement.offered(EyeDeadTime::Begin, 0.0));
        source.pass({.begin = 0.4, .end = 0.7}, 1.0, 40); // fixed elsewhere
        QVERIFY(!measurement.measured(EyeDeadTime::Begin));
        source.pass({.begin = 0.4, .end = 0.7}, 4.0, 40);
        const auto offered = measurement.offered(EyeDeadTime::Begin, 0.0);
        QVERIFY(offered && std::abs(*offered - 1.0) < 0.15);
        source.pass({.begin = 0.43, .end = 0.73}, 6.0, 1100); // much later
        QVERIFY(!measurement.measured(EyeDeadTime::Begin));
    }

    void aRestartedControllerBeginsAnew()
    {
        EyeDeadTime measurement;
        Source source(measurement);
        source.pass({}, 1.0, 40);
        source.restart();
        source.pass({.begin = 0.6, .end = 0.9}, 4.0, 40);
        QVERIFY(!measurement.measured(EyeDeadTime::Begin));
    }

    void anEdgeBehindAChangeOfSpeedDoesNotCount()
    {
        EyeDeadTime measurement;
        Source source(measurement);
        for (int i = 0; i < 100; ++i)
            source.pass({.jitterOfSpeed = 0.0}, i % 2 == 0 ? 1.0 : 4.0, 1);
        QVERIFY(!measurement.measured(EyeDeadTime::Begin));
    }
};

CAMPANEL_TEST(TestEyeDeadTime)

} // namespace test_eye_dead_time

#include "test_eye_dead_time.moc"
