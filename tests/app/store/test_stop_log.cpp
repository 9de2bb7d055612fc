// SPDX-License-Identifier: Apache-2.0
// The log of states and stops: rewriting, spans, the ring, an update of the database, and the CSV files.
#include "app/store/database/clock_mark.h"
#include "app/store/logs/stop_export.h"
#include "app/store/recipes/recipe_library.h"
#include "tests/support/earlier_schema.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

namespace test_stop_log {

using namespace campanel::store;
using namespace Qt::StringLiterals;
using State = StateInterval::State;

namespace {

StateInterval interval(qint64 id, qint64 stop, State state, qint64 beginMs, qint64 durationMs)
{
    StateInterval made;
    made.id = id;
    made.stop = stop;
    made.state = state;
    made.beginMs = beginMs;
    made.durationMs = durationMs;
    made.program = u"Biscuit 250"_s;
    made.version = 3;
    made.idealPerMin = 120.5;
    return made;
}

qint64 countOf(Database& database, const QString& table)
{
    auto counted = database.execute(u"SELECT count(*) FROM %1"_s.arg(table));
    return counted && counted->next() ? counted->value(0).toLongLong() : -1;
}

} // namespace

class TestStopLog : public QObject {
    Q_OBJECT

private slots:
    void anIntervalIsWrittenAgainAndReadBack()
    {
        const QTemporaryDir folder;
        {
            const auto database = Database::open(folder.path());
            QVERIFY(database);
            QVERIFY(!StopLog::begin(**database)->last);
            StateInterval open = interval(1, 1, State::Ready, 1000, 500);
            QVERIFY(StopLog::write(**database, {{open}, {}}));
            open.durationMs = 60'000;
            open.pieces = 7;
            open.outOfTolerance = 2;
            open.startUpScrap = 1;
            open.skipped = 3;
            open.cycles = 99;
            const StopRow stop{1, u"cleaning"_s, true, u"Ann"_s, 1500};
            QVERIFY(StopLog::write(**database, {{open}, {stop}}));
            QVERIFY(StopLog::write(**database, {{interval(2, 1, State::Jogging, 61'000, 4000)}, {}}));
        }
        const auto database = Database::open(folder.path());
        QVERIFY(database);
        const auto start = StopLog::begin(**database);
        QVERIFY(start && start->last && start->stop);
        QCOMPARE(start->last->id, 2);
        QCOMPARE(start->stop->reason, u"cleaning"_s);
        QVERIFY(start->stop->isPlanned);
        QCOMPARE(start->stopMs, 64'000);
        QCOMPARE(start->stopBeginMs, 1000);
        const auto span = StopLog::between(**database, 0, 61'000);
        QVERIFY(span);
        QCOMPARE(span->intervals.size(), 1);
        QCOMPARE(span->intervals[0].durationMs, 60'000);
        QCOMPARE(span->intervals[0].pieces, 7);
        QCOMPARE(span->intervals[0].cycles, 99);
        QCOMPARE(span->intervals[0].idealPerMin, 120.5);
        QCOMPARE(span->stops.size(), 1);
        QCOMPARE(span->stops[0].by, u"Ann"_s);
        QVERIFY(!StopLog::stop(**database, 5)->has_value());
    }

    // A stop stays as long as one of its intervals.
    void theOldestIntervalsGo()
    {
        const QTemporaryDir folder;
        const auto database = Database::open(folder.path());
        QVERIFY(database);
        constexpr qint64 capacity = 50;
        for (qint64 id = 1; id <= 120; ++id) {
            const qint64 stop = id - id % 10 == 0 ? 1 : id - id % 10; // of ten intervals each
            const StopChanges changes{{interval(id, stop, State::Ready, id * 1000, 1000)},
                                      {{stop, u"break"_s, true, {}, 1}}};
            QVERIFY(StopLog::write(**database, changes, capacity));
        }
        QCOMPARE(countOf(**database, u"state_interval"_s), capacity);
        const auto span = StopLog::between(**database, 0, 1'000'000);
        QVERIFY(span);
        QCOMPARE(span->intervals.first().id, 71);
        QCOMPARE(span->intervals.last().id, 120);
        QCOMPARE(span->stops.first().id, 70);
        QCOMPARE(countOf(**database, u"stop"_s), span->stops.size());
    }

    void aDatabaseOfAnEarlierVersionGetsTheTables()
    {
        const QTemporaryDir folder;
        constexpr int before = 4;
        {
            const auto database = Database::open(folder.path());
            QVERIFY(database);
            QVERIFY(campanel::test::goBackTo(**database, before));
        }
        const auto database = Database::open(folder.path());
        QVERIFY(database);
        QCOMPARE((*database)->opening().migratedFrom, before);
        QVERIFY(StopLog::write(**database, {{interval(1, 0, State::Running, 0, 1)}, {}}));
    }

    void aDatabaseOfTheEarlierSchemaGetsTheMark()
    {
        const QTemporaryDir folder;
        constexpr int before = 6;
        {
            const auto database = *Database::open(folder.path());
            QVERIFY(StopLog::write(*database, {{interval(1, 1, State::Ready, 1000, 500)}, {}}));
            QVERIFY(RecipeLibrary(*database).save({}, u"Anna"_s, earliestRecordMs));
            QVERIFY(campanel::test::goBackTo(*database, before));
        }
        const auto database = *Database::open(folder.path());
        QCOMPARE(database->opening().migratedFrom, before);
        StateInterval marked = interval(2, 1, State::Ready, 1500, 500);
        marked.isClockDoubtful = true;
        QVERIFY(StopLog::write(*database, {{marked}, {}}));
        const auto span = *StopLog::between(*database, 0, 5000);
        QCOMPARE(span.intervals.size(), 2);
        QVERIFY2(!span.intervals[0].isClockDoubtful, "nothing is known of earlier rows");
        QVERIFY(span.intervals[1].isClockDoubtful);
        const QByteArray states = statesCsv(span);
        QVERIFY(states.contains(",set\n") && states.contains(",not set\n"));
        QVERIFY2(stopsCsv(span).endsWith(",set\n"), "the begin of the stop counts");
        QVERIFY(!RecipeLibrary(*database).newest()->first().isClockDoubtful);
    }

    void statesAndStopsAsCsv()
    {
        StopLog::Span span;
        span.intervals = {interval(1, 0, State::Running, 1'768'478'400'000, 60'000),
                          interval(2, 2, State::Ready, 1'768'478'460'000, 30'500),
                          interval(3, 2, State::Suspended, 1'768'478'490'500, 1000)};
        span.intervals[0].pieces = 55;
        span.intervals[0].outOfTolerance = 2;
        span.stops = {{2, u"Foil, torn"_s, false, u"Ann"_s, 1'768'478'470'000}};
        const QList<QByteArray> states = statesCsv(span).split('\n');
        QCOMPARE(states.size(), 5); // the heading, three lines and the end
        QVERIFY2(states[1].startsWith("2026-01-15T12:00:00.000Z,"), states[1]);
        QVERIFY2(states[1].endsWith(",60.000,running,,Biscuit 250,3,120.500,55,2,0,0,set"), states[1]);
        QVERIFY2(states[3].contains(",1.000,suspended,2,"), states[3]);
        const QList<QByteArray> stops = stopsCsv(span).split('\n');
        QCOMPARE(stops.size(), 3);
        QVERIFY2(stops[1].startsWith("2,2026-01-15T12:01:00.000Z,"), stops[1]);
        QVERIFY2(stops[1].endsWith(",31.500,ready,\"Foil, torn\",no,Ann,2026-01-15T12:01:10.000Z,set"),
                 stops[1]);
    }
};

CAMPANEL_TEST(TestStopLog)

} // namespace test_stop_log

#include "test_stop_log.moc"
