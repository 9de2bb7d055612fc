// SPDX-License-Identifier: Apache-2.0
// Availability, performance and quality of 1000 random shifts, equal to those of the package oee 0.2.0
// (make_oee_golden.py), and what is unknown.
#include "app/panel/stops/shift_summary.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTest>

#include <cmath>
#include <random>

namespace test_oee {

using namespace campanel;
using panel::Oee;
using panel::Production;
using panel::Shift;
using store::StateInterval;

namespace {

constexpr unsigned seed = 20261124; // of make_oee_golden.py
constexpr double tolerance = 1e-9;

class Random {
public:
    qint64 below(qint64 bound) { return static_cast<qint64>(m_engine()) % bound; }

private:
    std::minstd_rand m_engine{seed};
};

// Returns runs and stops in turn; the draws are those of make_oee_golden.py.
store::StopLog::Span randomShift(Random& random)
{
    store::StopLog::Span span;
    qint64 at = 0;
    const auto add = [&](StateInterval interval) {
        interval.id = span.intervals.size() + 1;
        interval.beginMs = at;
        at += interval.durationMs;
        span.intervals << interval;
    };
    const qint64 count = 2 + random.below(8);
    for (qint64 i = 0; i < count; ++i) {
        StateInterval run;
        run.state = StateInterval::State::Running;
        run.durationMs = 1000 + random.below(900'000);
        run.idealPerMin = static_cast<double>(20 + random.below(280));
        const qint64 share = random.below(110);
        run.pieces = run.durationMs * static_cast<qint64>(run.idealPerMin) / 60'000 * share / 100;
        run.outOfTolerance = std::min(random.below(1 + run.pieces / 10), run.pieces);
        const qint64 scrap = run.pieces > 20 ? random.below(4) : 0;
        run.startUpScrap = std::min(scrap, run.pieces - run.outOfTolerance);
        run.skipped = random.below(1 + run.pieces / 20);
        add(run);
        StateInterval stop;
        stop.state = StateInterval::State::Ready;
        stop.durationMs = 1000 + random.below(300'000);
        stop.stop = span.intervals.size() + 1;
        if (random.below(3) == 0)
            span.stops << store::StopRow{stop.stop, QStringLiteral("break"), true, {}, 1};
        add(stop);
    }
    return span;
}

double difference(double value, const QByteArray& wanted)
{
    return std::abs(value - wanted.toDouble());
}

} // namespace

class TestOee : public QObject {
    Q_OBJECT

private slots:
    void aThousandShiftsAreThoseOfThePackage()
    {
        QFile file(test::sourcePath("tests/app/panel/stops/oee_golden.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readLine().trimmed(), QByteArray("availability,performance,quality,oee"));
        Random random;
        double worst = 0;
        for (int i = 0; i < 1000; ++i) {
            const QList<QByteArray> wanted = file.readLine().trimmed().split(',');
            QCOMPARE(wanted.size(), 4);
            const auto summary = panel::summarize(randomShift(random), Shift{0, 100'000'000}, 60'000);
            const Oee oee = panel::oeeOf(summary.production);
            const double far =
                std::max({difference(oee.availability, wanted[0]), difference(oee.performance, wanted[1]),
                          difference(oee.quality, wanted[2]), difference(oee.oee, wanted[3])});
            worst = std::max(worst, far);
            QVERIFY2(far < tolerance, qPrintable(QStringLiteral("shift %1: %2").arg(i).arg(far)));
        }
        QVERIFY(file.atEnd());
        qInfo("largest difference %g", worst);
    }

    // The example in the documentation of the package.
    void publishedExample()
    {
        Production production;
        production.plannedMs = 420 * 60'000;
        production.runMs = (420 - 47) * 60'000;
        production.pieces = 19271;
        production.outOfTolerance = 423;
        production.idealMs = 19271.0 * 60'000 / 60;
        const Oee oee = panel::oeeOf(production);
        QVERIFY(std::abs(oee.availability - 0.888095238) < 1e-8);
        QVERIFY(std::abs(oee.performance - 0.861081323) < 1e-8);
        QVERIFY(std::abs(oee.quality - 0.978049919) < 1e-8);
        QVERIFY(std::abs(oee.oee - 0.74794) < 1e-5);
    }

    void performanceEndsAtOne()
    {
        Production production;
        production.plannedMs = production.runMs = 60'000;
        production.pieces = 100;
        production.idealMs = 61'000;
        const Oee oee = panel::oeeOf(production);
        QCOMPARE(oee.performance, 1.0);
        QVERIFY(oee.rawPerformance > 1);
        QCOMPARE(oee.oee, 1.0);
    }

    void whatIsUnknownIsNoNumber()
    {
        const Oee nothing = panel::oeeOf({});
        QVERIFY(std::isnan(nothing.availability) && std::isnan(nothing.oee));
        Production standing;
        standing.plannedMs = 1000;
        const Oee stood = panel::oeeOf(standing);
        QCOMPARE(stood.availability, 0.0);
        QVERIFY(std::isnan(stood.performance) && std::isnan(stood.quality));
        QCOMPARE(stood.oee, 0.0);
        Production withoutIdeal;
        withoutIdeal.plannedMs = withoutIdeal.runMs = 1000;
        withoutIdeal.pieces = 1;
        withoutIdeal.idealMs = std::nan("");
        const Oee unsure = panel::oeeOf(withoutIdeal);
        QVERIFY(std::isnan(unsure.performance) && std::isnan(unsure.oee));
        QCOMPARE(unsure.quality, 1.0);
    }

    void stopsAreSummedByReason()
    {
        store::StopLog::Span span;
        const auto add = [&](qint64 stop, StateInterval::State state, qint64 beginMs, qint64 durationMs) {
            StateInterval each;
            each.id = span.intervals.size() + 1;
            each.stop = stop;
            each.state = state;
            each.beginMs = beginMs;
            each.durationMs = durationMs;
            span.intervals << each;
        };
        add(0, StateInterval::State::Running, 0, 600'000);
        add(2, StateInterval::State::Ready, 600'000, 300'000);
        add(2, StateInterval::State::Jogging, 900'000, 100'000); // the same stop
        add(0, StateInterval::State::Running, 1'000'000, 200'000);
        add(5, StateInterval::State::Fault, 1'200'000, 50'000);
        add(6, StateInterval::State::Ready, 1'300'000, 20'000);  // short
        add(7, StateInterval::State::Ready, 1'400'000, 600'000); // planned
        span.intervals[0].program = QStringLiteral("Rusk");
        span.intervals[0].version = 2;
        span.intervals[1].program = QStringLiteral("Soap"); // was there and never ran
        span.intervals[3].program = QStringLiteral("Biscuit 250");
        span.intervals[3].version = 4;
        span.stops = {{2, QStringLiteral("material/film_change"), false, {}, 1},
                      {5, QStringLiteral("C-01"), false, {}, 1},
                      {7, QStringLiteral("break"), true, {}, 1}};
        const auto summary = panel::summarize(span, Shift{0, 2'400'000}, 60'000);
        QCOMPARE(summary.programs, QStringList({"Rusk v2", "Biscuit 250 v4"}));
        QCOMPARE(summary.stops.size(), 4);
        QCOMPARE(summary.stops[0].durationMs, 400'000);
        QCOMPARE(summary.knownMs, 1'870'000);
        QCOMPARE(summary.plannedStopMs, 600'000);
        QCOMPARE(summary.stopMs, 470'000);
        QCOMPARE(summary.production.plannedMs, 1'270'000);
        QCOMPARE(summary.production.runMs, 800'000);
        QStringList reasons;
        for (const panel::ReasonShare& each : summary.reasons)
            reasons << (each.isShort ? QStringLiteral("short") : each.reason) + u' ' +
                           QString::number(each.durationMs / 1000);
        QCOMPARE(reasons, QStringList({"break 600", "material/film_change 400", "C-01 50", "short 20"}));
        // The bar: the first quarter runs, and the shares are those of the time.
        QCOMPARE(summary.bar[0].state, StateInterval::State::Running);
        QVERIFY(std::abs(summary.bar[0].width - 0.25) < 0.003);
        double filled = 0;
        for (const panel::BarStretch& each : summary.bar)
            filled += each.width;
        QVERIFY2(std::abs(filled - 1'870'000.0 / 2'400'000) < 0.01, qPrintable(QString::number(filled)));
        // A shift of a day off plans nothing.
        const auto off = panel::summarize(span, Shift{0, 2'400'000, false}, 60'000);
        QCOMPARE(off.production.plannedMs, 0);
        QVERIFY(std::isnan(panel::oeeOf(off.production).oee));
    }
};

CAMPANEL_TEST(TestOee)

} // namespace test_oee

#include "test_oee.moc"
