// SPDX-License-Identifier: Apache-2.0
// The dead time of a mark sensor, found in the marks of made-up starts and stops whose formulas stand here.
#include "app/program/dead_time_estimate.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>

namespace test_dead_time_estimate {

using campanel::modbus::MarkEdge;
using campanel::modbus::MarkVerdict;
using campanel::program::DeadTime;
using campanel::program::DeadTimeEstimate;

namespace {

// A film that runs at v1, speeds up evenly to v2, runs, slows down again: marks at its multiples of the
// pitch, seen late by `deadMs` and moved by slip x acceleration.
struct Film {
    double pitchMm = 300.0;
    double deadMs = 1.0;
    double knownMs = 0.0; // what the controller takes off
    double slipMm = 0.05; // per m/s^2
    double noiseMm = 0.05;
    double slow = 0.1; // m/s
    double fast = 1.5;
    double acceleration = 1.875;
    int steadyMarks = 10;
};

class Source {
public:
    Source(const Film& film, DeadTimeEstimate& estimate)
        : m_film(film)
        , m_estimate(estimate)
    {
    }

    void run(int marks, double acceleration)
    {
        for (int i = 0; i < marks; ++i)
            pass(acceleration);
    }
    void ramp(double to)
    {
        const double acceleration = std::copysign(m_film.acceleration, to - m_speed);
        const double wayMm = std::abs(to * to - m_speed * m_speed) / (2.0 * m_film.acceleration) * 1000.0;
        const double end = m_placeMm + wayMm;
        const double from = m_speed;
        const double start = m_placeMm;
        while (m_nextMm < end) {
            m_speed =
                std::sqrt(std::max(0.0, from * from + 2.0 * acceleration * (m_nextMm - start) / 1000.0));
            pass(acceleration);
        }
        m_placeMm = end;
        m_speed = to;
    }
    void setSpeed(double speed) { m_speed = speed; }

private:
    void pass(double acceleration)
    {
        std::normal_distribution<double> noise(0.0, m_film.noiseMm);
        m_placeMm = m_nextMm;
        m_nextMm += m_film.pitchMm;
        const double restMs = m_film.deadMs - m_film.knownMs;
        const double seenMm = m_placeMm + restMs * m_speed + m_film.slipMm * acceleration + noise(m_random);
        m_estimate.take({++m_number, static_cast<std::uint32_t>(std::llround(seenMm * 1000.0)), 0.0, m_speed,
                         acceleration, MarkVerdict::Taken, m_film.knownMs});
    }

    Film m_film;
    DeadTimeEstimate& m_estimate;
    std::mt19937_64 m_random{7};
    double m_placeMm = 0.0;
    double m_nextMm = 0.0;
    double m_speed = 0.0;
    std::uint32_t m_number = 0;
};

void startsAndStops(const Film& film, DeadTimeEstimate& estimate, int count)
{
    Source source(film, estimate);
    source.setSpeed(film.slow);
    for (int i = 0; i < count; ++i) {
        source.run(film.steadyMarks, 0.0);
        source.ramp(film.fast);
        source.run(film.steadyMarks, 0.0);
        source.ramp(film.slow);
    }
}

} // namespace

class TestDeadTimeEstimate : public QObject {
    Q_OBJECT

private slots:
    // Twenty starts and stops from 0.1 to 1.5 m/s with a film that slips 0.05 mm for each m/s^2.
    void findsItToATwentieth_data()
    {
        QTest::addColumn<double>("deadMs");
        QTest::addColumn<double>("knownMs");
        for (const double deadMs : {0.0, 0.5, 1.0, 2.0, 10.0}) {
            QTest::addRow("%g ms, unknown", deadMs) << deadMs << 0.0;
            QTest::addRow("%g ms, 1.2 ms taken off", deadMs) << deadMs << 1.2;
        }
    }
    void findsItToATwentieth()
    {
        QFETCH(double, deadMs);
        QFETCH(double, knownMs);
        DeadTimeEstimate estimate;
        startsAndStops({.deadMs = deadMs, .knownMs = knownMs}, estimate, 20);
        const auto found = estimate.estimate();
        QVERIFY(found);
        QVERIFY2(std::abs(found->ms - deadMs) <= 0.05, qPrintable(QString::number(found->ms)));
        QVERIFY2(found->marginMs <= 0.05, qPrintable(QString::number(found->marginMs)));
        QVERIFY2(std::abs(found->ms - deadMs) <= 3 * found->marginMs,
                 qPrintable(QString::number(found->marginMs)));
        const auto offered = estimate.offered(knownMs);
        QCOMPARE(offered.has_value(), deadMs != knownMs);
        if (offered)
            QVERIFY(std::abs(*offered - deadMs) <= 0.05);
    }

    // Without ramps, or with too few of them, nothing is known.
    void offersNothingBeforeItKnows()
    {
        DeadTimeEstimate estimate;
        startsAndStops({.fast = 0.1}, estimate, 50);
        QVERIFY(!estimate.estimate());
        startsAndStops({.noiseMm = 0.3}, estimate, 1);
        QVERIFY(!estimate.offered(0.0));
    }

    // Marks that were not taken, and numbers that are missing, are no distances.
    void ignoresFalseMarks()
    {
        DeadTimeEstimate estimate;
        startsAndStops({}, estimate, 20);
        const double before = estimate.estimate()->ms;
        for (std::uint32_t i = 0; i < 100; ++i)
            estimate.take({1'000'000 + i, i * 300'000u, 0.0, i % 2 == 0 ? 0.5 : 1.0, 0.0,
                           MarkVerdict::OutsideWindow, 0.0});
        for (std::uint32_t i = 0; i < 100; ++i)
            estimate.take(
                {2'000'000 + 2 * i, i * 310'000u, 0.0, i % 2 == 0 ? 0.5 : 1.0, 0.0, MarkVerdict::Taken, 0.0});
        QCOMPARE(estimate.estimate()->ms, before);
    }

    // A sensor that gets slower is followed.
    void followsASlowerSensor()
    {
        DeadTimeEstimate estimate;
        startsAndStops({.deadMs = 1.0}, estimate, 100);
        startsAndStops({.deadMs = 1.5}, estimate, 200);
        const auto offered = estimate.offered(1.0);
        QVERIFY(offered);
        QVERIFY2(std::abs(*offered - 1.5) < 0.1, qPrintable(QString::number(*offered)));
    }

    // Only what moves the cut visibly is a drift, and it ends well below the limit.
    void noticesADrift()
    {
        DeadTimeEstimate estimate;
        QVERIFY(!estimate.drift(1.0, false));
        startsAndStops({.deadMs = 1.5}, estimate, 40);
        QVERIFY(estimate.drift(1.0, false));
        QVERIFY(estimate.drift(2.0, false));
        QVERIFY(!estimate.drift(0.0, false)); // none entered
        QVERIFY(!estimate.drift(1.5, false));
        const double limit = estimate.estimate()->ms - 0.17;
        QVERIFY(!estimate.drift(limit, false));
        QVERIFY(estimate.drift(limit, true));
        QVERIFY(!estimate.drift(estimate.estimate()->ms - 0.1, true));
    }
};

CAMPANEL_TEST(TestDeadTimeEstimate)

} // namespace test_dead_time_estimate

#include "test_dead_time_estimate.moc"
