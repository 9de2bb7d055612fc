// SPDX-License-Identifier: Apache-2.0
// The intervals of the machine's states: each second counts once, whatever the wall clock does; stops are
// whole over quarters, programs and restarts of the panel.
#include "app/panel/stops/state_book.h"
#include "tests/support/test_program.h"

#include <QDateTime>
#include <QRandomGenerator>
#include <QTest>
#include <QTimeZone>

#include <algorithm>

namespace test_state_book {

using namespace campanel;
using namespace std::chrono_literals;
using panel::StateBook;
using store::StateInterval;
using State = StateInterval::State;

namespace {

constexpr qint64 startMs = 1'768'478'400'000; // 2026-01-15 12:00 UTC, a quarter

struct Rig {
    StateBook book;
    link::SteadyTime steady{1h};
    qint64 utcMs = startMs;
    bool isClockDoubtful = false;
    StateBook::Observation seen;
    QMap<qint64, StateInterval> rows;
    QMap<qint64, store::StopRow> stops;
    qint64 passedMs = 0; // observed

    Rig()
    {
        seen.program = QStringLiteral("Biscuit 250");
        seen.state = State::Running;
        book.begin({});
    }
    void note() { book.note(seen, {steady, utcMs, isClockDoubtful}); }
    // Lets time pass with a status every second.
    void pass(std::chrono::milliseconds time)
    {
        for (; time > 0ms; time -= 1s) {
            const std::chrono::milliseconds step = std::min<std::chrono::milliseconds>(time, 1s);
            steady += step;
            utcMs += step.count();
            passedMs += step.count();
            note();
        }
    }
    void setState(State state)
    {
        seen.state = state;
        note();
    }
    // Lets time pass without a status.
    void silence(std::chrono::milliseconds time)
    {
        steady += time;
        utcMs += time.count();
        book.check({steady, utcMs});
    }
    // Takes the changes as the log does.
    void save()
    {
        const store::StopChanges changes = book.takeChanges();
        for (const StateInterval& each : changes.intervals)
            rows[each.id] = each;
        for (const store::StopRow& each : changes.stops)
            stops[each.id] = each;
    }
    [[nodiscard]] qint64 recordedMs()
    {
        save();
        qint64 sum = 0;
        for (const StateInterval& each : rows)
            sum += each.durationMs;
        return sum;
    }
    // Another panel on the same log.
    void restart(std::chrono::milliseconds away)
    {
        save();
        book = StateBook();
        steady = link::SteadyTime{5min};
        utcMs += away.count();
        store::StopLog::Start start;
        start.last = rows.last();
        for (const StateInterval& each : rows)
            start.stopMs += start.last->stop != 0 && each.stop == start.last->stop ? each.durationMs : 0;
        start.hadProgram =
            std::ranges::any_of(rows, [](const StateInterval& each) { return !each.program.isEmpty(); });
        if (stops.contains(start.last->stop))
            start.stop = stops[start.last->stop];
        book.begin(start);
    }
};

} // namespace

class TestStateBook : public QObject {
    Q_OBJECT

private slots:
    // A new panel: somebody reads the wizard, downloads the first recipe, and starts.
    void beforeTheFirstProgramNothingStands()
    {
        Rig rig;
        rig.seen.program.clear();
        rig.setState(State::Idle);
        rig.pass(20min);
        QVERIFY(!rig.book.present());
        QCOMPARE(rig.book.stopMs(), 0);
        QCOMPARE(rig.recordedMs(), 0);
        rig.seen.program = QStringLiteral("Biscuit 250");
        rig.setState(State::Ready);
        rig.pass(1min);
        QCOMPARE(rig.book.stopMs(), 60'000);
        QCOMPARE(rig.recordedMs(), 60'000);
        // A machine that lost its program stands, also for a panel that was restarted meanwhile.
        rig.seen.program.clear();
        rig.setState(State::Idle);
        rig.pass(1min);
        QCOMPARE(rig.book.stopMs(), 120'000);
        rig.restart(10s);
        rig.pass(1min);
        QCOMPARE(rig.book.stopMs(), 179'000); // the first second only begins
    }

    void intervalsOfAClockThatIsNotSetAreMarked()
    {
        Rig rig;
        rig.isClockDoubtful = true;
        rig.setState(State::Ready);
        rig.pass(20min); // over a quarter
        rig.isClockDoubtful = false;
        rig.pass(1min);
        rig.save();
        QList<bool> marks;
        for (const StateInterval& each : rig.rows) {
            QCOMPARE(each.stop, 1);
            marks << each.isClockDoubtful;
        }
        QCOMPARE(marks, QList<bool>({true, true, false}));
        QCOMPARE(rig.recordedMs(), rig.passedMs);
    }

    void intervalsEndWithTheStateAndAtQuarters()
    {
        Rig rig;
        rig.note();
        rig.pass(20min);
        rig.setState(State::Ready);
        rig.pass(30min);
        rig.setState(State::Running);
        rig.pass(1min);
        QCOMPARE(rig.recordedMs(), rig.passedMs);
        const QList<StateInterval> rows = rig.rows.values();
        QCOMPARE(rows.size(), 6);
        QList<qint64> begins;
        for (const StateInterval& each : rows)
            begins << (each.beginMs - startMs) / 60'000;
        QCOMPARE(begins, QList<qint64>({0, 15, 20, 30, 45, 50}));
        QCOMPARE(rows[2].stop, rows[2].id);
        QCOMPARE(rows[3].stop, rows[2].id); // one stop
        QCOMPARE(rows[4].stop, rows[2].id);
        QCOMPARE(rows[5].stop, 0);
        for (const StateInterval& each : rows)
            QVERIFY(each.beginMs / StateBook::quarterMs == (each.endMs() - 1) / StateBook::quarterMs);
    }

    // Random jumps of the wall clock, also far back and over midnight.
    void eachSecondCountsOnce()
    {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        for (int round = 0; round < 50; ++round) {
            Rig rig;
            rig.utcMs += random.bounded(86'400) * 1000LL;
            rig.note();
            for (int i = 0; i < 40; ++i) {
                rig.pass(std::chrono::milliseconds(random.bounded(400'000)));
                if (random.bounded(3) == 0)
                    rig.utcMs += random.bounded(-7'200'000, 7'200'000);
                if (random.bounded(2) == 0)
                    rig.setState(static_cast<State>(random.bounded(8)));
                if (random.bounded(5) == 0)
                    rig.save();
            }
            QVERIFY2(rig.recordedMs() == rig.passedMs, qPrintable(QStringLiteral("seed %1 round %2: %3 of %4")
                                                                      .arg(seed)
                                                                      .arg(round)
                                                                      .arg(rig.recordedMs())
                                                                      .arg(rig.passedMs)));
            for (const StateInterval& each : rig.rows) {
                const bool isInOneQuarter =
                    each.durationMs == 0 ||
                    each.beginMs / StateBook::quarterMs == (each.endMs() - 1) / StateBook::quarterMs;
                QVERIFY2(isInOneQuarter, qPrintable(QString::number(seed)));
            }
        }
    }

    void aClockThatIsSetBackSplitsAnInterval()
    {
        Rig rig;
        rig.note();
        rig.pass(100s);
        rig.utcMs -= 3'600'000;
        rig.pass(50s);
        rig.save();
        const QList<StateInterval> rows = rig.rows.values();
        QCOMPARE(rows.size(), 2);
        QCOMPARE(rows[0].durationMs + rows[1].durationMs, 150'000);
        QVERIFY(rows[1].beginMs < rows[0].beginMs);
    }

    void aStopLastsOverAClockThatIsSet()
    {
        Rig rig;
        rig.note();
        rig.pass(10s);
        rig.setState(State::Ready);
        rig.pass(100s);
        const qint64 stop = rig.book.presentStop().id;
        rig.utcMs += 86'400'000;
        rig.pass(100s);
        QCOMPARE(rig.book.presentStop().id, stop);
        QCOMPARE(rig.book.stopMs(), 200'000);
    }

    // Local time jumps by an hour in Berlin; the intervals know UTC only.
    void daylightSavingAndMidnightChangeNothing()
    {
        const QTimeZone berlin("Europe/Berlin");
        for (const QDate day : {QDate(2026, 3, 28), QDate(2026, 10, 24)}) {
            Rig rig;
            rig.utcMs = QDateTime(day, QTime(22, 0), berlin).toMSecsSinceEpoch();
            const qint64 from = rig.utcMs;
            const qint64 to = QDateTime(day.addDays(1), QTime(6, 0), berlin).toMSecsSinceEpoch();
            rig.note();
            rig.pass(std::chrono::milliseconds(to - from));
            QCOMPARE(rig.recordedMs(), to - from);
            QCOMPARE((to - from) / 3'600'000, day.month() == 3 ? 7 : 9);
        }
    }

    void aSilentLineIsAGap()
    {
        Rig rig;
        rig.note();
        rig.pass(30s);
        rig.silence(4s); // not long enough
        rig.note();
        rig.passedMs += 4000;
        QCOMPARE(rig.recordedMs(), rig.passedMs);
        QCOMPARE(rig.rows.size(), 1);
        rig.silence(60s);
        QVERIFY(!rig.book.present());
        rig.note();
        rig.pass(10s);
        QCOMPARE(rig.recordedMs(), rig.passedMs);
        QCOMPARE(rig.rows.size(), 2);
        QCOMPARE(rig.rows.last().beginMs - rig.rows.first().endMs(), 60'000);
    }

    void aStopGoesOnAfterARestartOfThePanel()
    {
        Rig rig;
        rig.seen.cycles = 100;
        rig.note();
        rig.pass(10s);
        rig.setState(State::Ready);
        rig.pass(100s);
        const qint64 stop = rig.book.presentStop().id;
        QVERIFY(rig.book.answer({stop, QStringLiteral("cleaning"), false, QStringLiteral("Ann"), rig.utcMs}));
        rig.restart(60s);
        rig.note();
        rig.pass(20s);
        QCOMPARE(rig.book.presentStop().id, stop);
        QCOMPARE(rig.book.presentStop().reason, QStringLiteral("cleaning"));
        QCOMPARE(rig.book.stopMs(), 120'000);
        QCOMPARE(rig.recordedMs(), rig.passedMs); // the gap is nothing known
        // The machine ran meanwhile, or nobody knows after so long.
        rig.restart(60s);
        rig.seen.cycles = 150;
        rig.note();
        QVERIFY(rig.book.presentStop().id != stop);
        const qint64 other = rig.book.presentStop().id;
        rig.restart(16min);
        rig.note();
        QVERIFY(rig.book.presentStop().id != other);
    }

    void theMachinesOwnReasonBelongsToTheBegin()
    {
        Rig rig;
        rig.note();
        rig.pass(10s);
        rig.seen.ownReason = QStringLiteral("C-01");
        rig.setState(State::Fault);
        rig.pass(30s);
        QCOMPARE(rig.book.presentStop().reason, QStringLiteral("C-01"));
        rig.save();
        QCOMPARE(rig.stops.size(), 1);
        rig.seen.ownReason.clear();
        rig.setState(State::Ready); // reset
        rig.pass(10s);
        QCOMPARE(rig.book.presentStop().reason, QStringLiteral("C-01"));
        rig.setState(State::Running);
        rig.pass(5s);
        QCOMPARE(rig.book.presentStop().id, 0);
        rig.setState(State::Ready);
        rig.pass(60s);
        rig.seen.ownReason = QStringLiteral("C-08"); // of the standing machine
        rig.setState(State::Fault);
        rig.pass(5s);
        QCOMPARE(rig.book.presentStop().reason, QString());
    }

    void waitingForProductsIsAStopOfItsOwn()
    {
        Rig rig;
        rig.note();
        rig.pass(10s);
        rig.seen.ownReason = QStringLiteral("waiting");
        rig.setState(State::Suspended);
        rig.pass(20s);
        const qint64 waiting = rig.book.presentStop().id;
        QCOMPARE(rig.book.presentStop().reason, QStringLiteral("waiting"));
        rig.seen.ownReason.clear();
        rig.setState(State::Ready);
        rig.pass(20s);
        QVERIFY(rig.book.presentStop().id != waiting);
        QCOMPARE(rig.book.presentStop().reason, QString());
    }

    void piecesBelongToTheirInterval()
    {
        Rig rig;
        rig.book.add({1, 0, 0, 0}); // nothing is known yet
        rig.note();
        rig.pass(10s);
        rig.book.add({3, 1, 1, 0});
        rig.book.add({2, 0, 0, 1});
        rig.setState(State::Ready);
        rig.save();
        QCOMPARE(rig.rows.first().pieces, 5);
        QCOMPARE(rig.rows.first().outOfTolerance, 1);
        QCOMPARE(rig.rows.first().startUpScrap, 1);
        QCOMPARE(rig.rows.first().skipped, 1);
        rig.silence(1min);
        rig.book.add({1, 0, 0, 0}); // a record that came late
        rig.save();
        QCOMPARE(rig.rows.last().pieces, 1);
    }

    void whatWasNotWrittenComesAgain()
    {
        Rig rig;
        rig.note();
        rig.pass(16min);
        const store::StopChanges failed = rig.book.takeChanges();
        QCOMPARE(failed.intervals.size(), 2);
        QVERIFY(!rig.book.hasNews());
        rig.book.putBack(failed);
        QVERIFY(rig.book.hasNews());
        rig.pass(10s);
        QCOMPARE(rig.recordedMs(), rig.passedMs); // the newer one of both
    }

    void waitingRowsAreLimited()
    {
        Rig rig;
        rig.note();
        for (std::size_t i = 0; i < StateBook::maxWaiting + 100; ++i) {
            rig.steady += 100ms;
            rig.utcMs += 100;
            rig.setState(i % 2 == 0 ? State::Ready : State::Running);
        }
        QVERIFY(rig.book.takeChanges().intervals.size() <= static_cast<qsizetype>(StateBook::maxWaiting) + 1);
    }
};

CAMPANEL_TEST(TestStateBook)

} // namespace test_state_book

#include "test_state_book.moc"
