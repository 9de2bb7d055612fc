// SPDX-License-Identifier: Apache-2.0
// The filter of the logs: spans of time, ids and words, in SQL and for rows that are added later; the mark of
// a clock that was not set.
#include "app/store/database/clock_mark.h"
#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"
#include "app/store/logs/stop_log.h"
#include "app/store/recipes/recipe_library.h"
#include "tests/support/earlier_schema.h"
#include "tests/support/test_program.h"

#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

namespace test_log_filter {

using namespace campanel::store;
using namespace Qt::StringLiterals;

namespace {

AlarmRow alarm(qint64 id, const QString& code, qint64 raisedMs, const QString& detail = {},
               const QString& by = {})
{
    AlarmRow row;
    row.id = id;
    row.code = code;
    row.raisedMs = raisedMs;
    row.detail = detail;
    row.acknowledgedBy = by;
    return row;
}

AuditEntry entry(qint64 timeMs, const QString& what, const QString& object, const QString& after = {},
                 const QString& outcome = u"done"_s)
{
    AuditEntry made;
    made.timeMs = timeMs;
    made.who = u"Anna"_s;
    made.what = what;
    made.object = object;
    made.after = after;
    made.outcome = outcome;
    return made;
}

LogFilter span(qint64 fromMs, qint64 toMs)
{
    LogFilter filter;
    filter.fromMs = fromMs;
    filter.toMs = toMs;
    return filter;
}

LogFilter byId(const QString& id)
{
    LogFilter filter;
    filter.id = id;
    return filter;
}

LogFilter byWord(const QString& word, const QStringList& keys = {})
{
    LogFilter filter;
    filter.word = word;
    filter.keysOfWord = keys;
    return filter;
}

// Creates a log in which the clock is set back at the fourth alarm.
std::unique_ptr<Database> exampleLog(const QTemporaryDir& folder)
{
    auto database = *Database::open(folder.path());
    AlarmChanges changes;
    changes.rows = {alarm(1, u"C-01"_s, 1000, u"axis 1"_s),
                    alarm(2, u"C-08"_s, 2000, u"50% of 3_4 A"_s, u"李伟"_s),
                    alarm(3, u"M-01"_s, 9000, u"Film Jam"_s, u"Anna"_s),
                    alarm(4, u"W-01"_s, 1500, u"501 of 3x4 A"_s), alarm(5, u"C-01"_s, 3000, u"c:\\log"_s)};
    if (!AlarmLog::write(*database, changes))
        qFatal("the log was not written");
    return database;
}

} // namespace

class TestLogFilter : public QObject {
    Q_OBJECT

private slots:
    void alarms_data()
    {
        QTest::addColumn<LogFilter>("filter");
        QTest::addColumn<QList<qint64>>("ids");
        const QList<qint64> none;
        QTest::newRow("all") << LogFilter{} << QList<qint64>{5, 4, 3, 2, 1};
        QTest::newRow("from") << span(2000, 0) << QList<qint64>{5, 3, 2};
        QTest::newRow("to, exclusive") << span(0, 2000) << QList<qint64>{4, 1};
        QTest::newRow("over a clock that was set back") << span(1500, 3001) << QList<qint64>{5, 4, 2};
        QTest::newRow("empty span") << span(3000, 3000) << none;
        QTest::newRow("reversed span") << span(3000, 1000) << none;
        QTest::newRow("nothing in the span") << span(4000, 8000) << none;
        QTest::newRow("id") << byId(u"C-01"_s) << QList<qint64>{5, 1};
        QTest::newRow("id as typed") << byId(u"c 01"_s) << QList<qint64>{5, 1};
        QTest::newRow("its letter") << byId(u"c"_s) << QList<qint64>{5, 2, 1};
        QTest::newRow("its number") << byId(u"01"_s) << QList<qint64>{5, 4, 3, 1};
        QTest::newRow("unknown id") << byId(u"X-77"_s) << none;
        QTest::newRow("id mixed with text") << byId(u"C-01 axis"_s) << none;
        QTest::newRow("id with a sign of SQL") << byId(u"C_0%"_s) << none;
        QTest::newRow("percent") << byWord(u"50%"_s) << QList<qint64>{2};
        QTest::newRow("underscore") << byWord(u"3_4"_s) << QList<qint64>{2};
        QTest::newRow("backslash") << byWord(u"\\"_s) << QList<qint64>{5};
        QTest::newRow("quote") << byWord(u"' OR 1=1 --"_s) << none;
        QTest::newRow("case") << byWord(u"fILM jAM"_s) << QList<qint64>{3};
        QTest::newRow("who acknowledged") << byWord(u"李"_s) << QList<qint64>{2};
        QTest::newRow("a key of the word")
            << byWord(u"drive"_s, {u"C-08"_s, u"W-01"_s}) << QList<qint64>{4, 2};
        LogFilter all = byWord(u"a"_s);
        all.id = u"C"_s;
        all.fromMs = 1500;
        QTest::newRow("all three") << all << QList<qint64>{2};
    }

    void alarms()
    {
        QFETCH(LogFilter, filter);
        QFETCH(QList<qint64>, ids);
        const QTemporaryDir folder;
        const auto database = exampleLog(folder);
        QList<qint64> found;
        const auto matching = alarmTable().page(*database, 0, 100, filter);
        for (const AlarmRow& row : *matching)
            found << row.id;
        QCOMPARE(found, ids);
        QList<qint64> included;
        const auto all = alarmTable().page(*database, 0);
        for (const AlarmRow& row : *all) {
            if (alarmTable().includes(filter, row))
                included << row.id;
        }
        QCOMPARE(included, ids);
        QCOMPARE(alarmTable().csv(*database, filter)->bytes.count('\n'), 1 + ids.size());
    }

    void alarmsByPages()
    {
        const QTemporaryDir folder;
        const auto database = exampleLog(folder);
        const LogFilter filter = byId(u"01"_s);
        QList<qint64> found;
        qint64 before = 0;
        while (true) {
            const auto page = *alarmTable().page(*database, before, 1, filter);
            if (page.isEmpty())
                break;
            before = page.first().id;
            found << before;
        }
        QCOMPARE(found, (QList<qint64>{5, 4, 3, 1}));
    }

    void audit_data()
    {
        QTest::addColumn<LogFilter>("filter");
        QTest::addColumn<QList<qint64>>("rows");
        const QList<qint64> none;
        QTest::newRow("span") << span(2000, 3000) << QList<qint64>{5, 2};
        QTest::newRow("row") << byId(u"3"_s) << QList<qint64>{3};
        QTest::newRow("row, not its digit") << byId(u"30"_s) << none;
        QTest::newRow("register") << byId(u"Mark_Window"_s) << QList<qint64>{4, 2};
        QTest::newRow("underscore is a sign") << byId(u"mark.window"_s) << none;
        QTest::newRow("action") << byId(u"user."_s) << QList<qint64>{1};
        QTest::newRow("row mixed with text") << byId(u"3 a"_s) << none;
        QTest::newRow("value") << byWord(u"12.5 %"_s) << QList<qint64>{2};
        QTest::newRow("user") << byWord(u"anna"_s) << QList<qint64>{5, 4, 3, 2, 1};
        QTest::newRow("key") << byWord(u"x"_s, {u"user.login"_s, u"refused"_s}) << QList<qint64>{4, 1};
        QTest::newRow("not over two texts") << byWord(u"annalanguage"_s) << none;
    }

    void audit()
    {
        QFETCH(LogFilter, filter);
        QFETCH(QList<qint64>, rows);
        const QTemporaryDir folder;
        const auto database = *Database::open(folder.path());
        for (const AuditEntry& each :
             {entry(1000, u"user.login"_s, u"Anna"_s),
              entry(2000, u"parameter.write"_s, u"parameter.mark_window"_s, u"12.5 %"_s),
              entry(9000, u"setting.change"_s, u"language"_s, u"de"_s),
              entry(1500, u"parameter.write"_s, u"parameter.mark_window"_s, u"125"_s, u"refused 7"_s),
              entry(2500, u"command.start"_s, {})})
            QVERIFY(appendAudit(*database, each));
        QList<qint64> found;
        const auto matching = auditTable().page(*database, 0, 100, filter);
        for (const AuditRow& row : *matching)
            found << row.sequence;
        QCOMPARE(found, rows);
        QList<qint64> included;
        const auto all = auditTable().page(*database, 0, 100);
        for (const AuditRow& row : *all) {
            if (auditTable().includes(filter, row))
                included << row.sequence;
        }
        QCOMPARE(included, rows);
        QCOMPARE(auditTable().csv(*database, filter, {}, 100)->bytes.count('\n'), 1 + rows.size());
        QCOMPARE(auditTable().csv(*database, filter, {}, 100)->bytes.count("Z,"),
                 rows.size()); // UTC as in the other files
        const auto two = auditTable().csv(*database, filter, {}, 2);
        QCOMPARE(two->bytes.count('\n'), 1 + std::min<qsizetype>(2, rows.size()));
        QCOMPARE(two->isCut, rows.size() > 2);
        QVERIFY(!auditTable().csv(*database, filter, {}, rows.size())->isCut);
    }

    // Random logs with clocks that jump: SQL and the test of a single row agree.
    void randomFilters()
    {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        const QStringList codes{u"C-01"_s, u"C-10"_s, u"M-01"_s, u"W-99"_s};
        const QStringList texts{u"a%b"_s, u"A_B"_s, u"ÄÖ"_s, u"色标"_s, {}, u"axb"_s};
        const QStringList ids{{}, u"c"_s, u"1"_s, u"C-01"_s, u"99"_s};
        const QStringList words{{}, u"%"_s, u"_"_s, u"a"_s, u"äö"_s, u"ÄÖ"_s, u"标"_s};
        const QTemporaryDir folder;
        const auto database = *Database::open(folder.path());
        AlarmChanges changes;
        for (int i = 1; i <= 200; ++i)
            changes.rows << alarm(i, codes[random.bounded(4)], 1 + random.bounded(500),
                                  texts[random.bounded(6)]);
        QVERIFY(AlarmLog::write(*database, changes));
        for (int i = 0; i < 300; ++i) {
            LogFilter filter =
                span(random.bounded(2) * random.bounded(500), random.bounded(2) * random.bounded(500));
            filter.id = ids[random.bounded(5)];
            filter.word = words[random.bounded(7)];
            if (random.bounded(3) == 0)
                filter.keysOfWord << u"M-01"_s;
            QList<qint64> wanted;
            for (auto row = changes.rows.crbegin(); row != changes.rows.crend(); ++row) {
                if (alarmTable().includes(filter, *row))
                    wanted << row->id;
            }
            QList<qint64> found;
            const auto matching = alarmTable().page(*database, 0, 1000, filter);
            for (const AlarmRow& row : *matching)
                found << row.id;
            QCOMPARE(found, wanted);
        }
    }

    void doubtfulTimes()
    {
        const qint64 day = 86'400'000;
        const qint64 now = earliestRecordMs + 30 * day;
        QVERIFY(isTimeDoubtful(0, 0));
        QVERIFY(isTimeDoubtful(earliestRecordMs - 1, 0));
        QVERIFY(!isTimeDoubtful(earliestRecordMs, 0));
        QVERIFY(!isTimeDoubtful(now, now));
        QVERIFY2(!isTimeDoubtful(now - maxSetBackMs, now), "a time server corrects a clock by seconds");
        QVERIFY(isTimeDoubtful(now - maxSetBackMs - 1, now));
        QVERIFY(isTimeDoubtful(now, now, ClockState::NotSet));
        QVERIFY(!isTimeDoubtful(now, now + 365 * day, ClockState::Proven));
        QVERIFY(isTimeDoubtful(earliestRecordMs - 1, 0, ClockState::Proven));
    }

    // A clock that runs years ahead writes one record of each kind, then it is set right.
    void aProofEndsTheMarkOfWhatComesAfterAClockThatRanAhead()
    {
        constexpr qint64 day = 86'400'000;
        constexpr qint64 now = earliestRecordMs + 30 * day;
        constexpr qint64 ahead = now + 1825 * day;
        const QTemporaryDir folder;
        const auto database = *Database::open(folder.path());
        AlarmChanges alarms;
        alarms.rows << alarm(1, u"C-01"_s, now - day) << alarm(2, u"C-01"_s, ahead);
        QVERIFY(AlarmLog::write(*database, alarms));
        StopChanges states;
        for (const qint64 beginMs : {now - day, ahead}) {
            StateInterval interval;
            interval.id = interval.stop = states.intervals.size() + 1;
            interval.beginMs = beginMs;
            states.intervals << interval;
        }
        QVERIFY(StopLog::write(*database, states));
        RecipeLibrary library(*database);
        campanel::program::Recipe recipe;
        QVERIFY(!library.save(recipe, u"Anna"_s, ahead)->isClockDoubtful);
        QVERIFY(appendAudit(*database, entry(ahead, u"user.login"_s, u"Anna"_s)));
        QVERIFY(isTimeDoubtful(now, *newestRecordMs(*database))); // and so for five years

        QVERIFY(noteClockProven(*database, now));
        QCOMPARE(*newestRecordMs(*database), now);
        const auto rows = *alarmTable().page(*database, 0);
        QVERIFY(rows[0].isClockDoubtful && !rows[1].isClockDoubtful);
        const auto intervals = StopLog::between(*database, 0, ahead + day)->intervals;
        QVERIFY(!intervals[0].isClockDoubtful && intervals[1].isClockDoubtful);
        QVERIFY(library.newest()->first().isClockDoubtful);
        QCOMPARE(verifyChain(*database)->fault(), ChainCheck::Fault::None);
        // The next records tell the time again, also those of the trail.
        QVERIFY(appendAudit(*database, entry(now + 2 * day, u"user.login"_s, u"Anna"_s)));
        QCOMPARE(*newestRecordMs(*database), now + 2 * day);
        alarms.rows = {alarm(3, u"C-01"_s, now + 3 * day)};
        QVERIFY(AlarmLog::write(*database, alarms));
        QCOMPARE(*newestRecordMs(*database), now + 3 * day);
    }

    void marksAreKeptExportedAndHashed()
    {
        const QTemporaryDir folder;
        const auto database = *Database::open(folder.path());
        QCOMPARE(*newestRecordMs(*database), 0);
        AlarmRow marked = alarm(1, u"C-01"_s, 5000);
        marked.isClockDoubtful = true;
        AlarmChanges changes;
        changes.rows << marked << alarm(2, u"C-01"_s, 4000);
        QVERIFY(AlarmLog::write(*database, changes));
        QCOMPARE(*newestRecordMs(*database), 4000); // without the marked one
        QCOMPARE(AlarmLog::begin(*database)->newestMs, 4000);
        const auto page = *alarmTable().page(*database, 0);
        QVERIFY(!page[0].isClockDoubtful && page[1].isClockDoubtful);
        const QByteArray alarms = alarmTable().csv(*database, {})->bytes;
        QVERIFY(alarms.contains(",,set\n") && alarms.contains(",,not set\n"));

        AuditEntry first = entry(7000, u"user.login"_s, u"Anna"_s);
        first.isClockDoubtful = true;
        QVERIFY(appendAudit(*database, first));
        QVERIFY(appendAudit(*database, entry(8000, u"user.logout"_s, u"Anna"_s)));
        QCOMPARE(*newestRecordMs(*database), 8000);
        const auto rows = *auditTable().page(*database, 0, 10);
        QVERIFY(!rows[0].entry.isClockDoubtful && rows[1].entry.isClockDoubtful);
        QVERIFY(auditTable().csv(*database, {})->bytes.contains(",not set\n"));
        QCOMPARE(verifyChain(*database)->fault(), ChainCheck::Fault::None);
        QVERIFY(database->execute(u"UPDATE audit SET clock_doubtful = 0 WHERE sequence = 1"_s));
        QCOMPARE(verifyChain(*database)->fault(), ChainCheck::Fault::Altered);
    }

    void trailOfAnOlderSchemaIsRead()
    {
        const QTemporaryDir folder;
        {
            const auto database = *Database::open(folder.path());
            QVERIFY(appendAudit(*database, entry(7000, u"user.login"_s, u"Anna"_s)));
            QVERIFY(campanel::test::goBackTo(*database, 5));
        }
        const QString path = folder.filePath(u"campanel.sqlite"_s);
        {
            const auto old = Database::openReadOnly(path);
            QVERIFY(old);
            QCOMPARE(auditTable().page(**old, 0, 10)->size(), 1);
            QCOMPARE(verifyChain(**old)->rows(), 1);
        }
        const auto database = *Database::open(folder.path());
        QCOMPARE(database->opening().migratedFrom, 5);
        QCOMPARE(verifyChain(*database)->fault(), ChainCheck::Fault::None);
    }
};

CAMPANEL_TEST(TestLogFilter)

} // namespace test_log_filter

#include "test_log_filter.moc"
