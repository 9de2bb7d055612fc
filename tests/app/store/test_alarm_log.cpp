// SPDX-License-Identifier: Apache-2.0
// The log of alarms: written, changed, read by pages, bounded, found after a crash; with 100 000 rows.
#include "alarm_fill.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace test_alarm_log {

using namespace campanel::store;
using namespace Qt::StringLiterals;
using campanel::test::fillAlarmLog;

namespace {

std::unique_ptr<Database> opened(const QTemporaryDir& folder)
{
    auto database = Database::open(folder.path());
    return database ? std::move(*database) : nullptr;
}

AlarmRow row(qint64 id, const QString& code = u"C-01"_s)
{
    AlarmRow row;
    row.id = id;
    row.code = code;
    row.raisedMs = 1000 * id;
    return row;
}

bool write(Database& database, const QList<AlarmRow>& rows)
{
    AlarmChanges changes;
    changes.rows = rows;
    return AlarmLog::write(database, changes).has_value();
}

QList<AlarmRow> page(Database& database, qint64 before = 0, int rows = logPageRows)
{
    return alarmTable().page(database, before, rows).value_or(QList<AlarmRow>());
}

int number(Database& database, const QString& statement)
{
    auto found = database.execute(statement);
    return found && found->next() ? found->value(0).toInt() : -1;
}

} // namespace

class TestAlarmLog : public QObject {
    Q_OBJECT

private slots:
    void everyFieldComesBack()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        AlarmRow full = row(1, u"W-03"_s);
        full.end = AlarmRow::End::Returned;
        full.returnedMs = 7;
        full.wantsAcknowledgement = false;
        full.acknowledgedMs = 8;
        full.acknowledgedBy = u"王"_s;
        full.count = 12;
        full.isShelved = true;
        full.detail = QString(1000, u'x');
        QVERIFY(write(*database, {full, row(2)}));
        const QList<AlarmRow> found = page(*database);
        QCOMPARE(found.size(), 2);
        QCOMPARE(found[0].id, 2);
        QCOMPARE(found[0].end, AlarmRow::End::Active);
        QCOMPARE(found[0].acknowledgedMs, 0);
        QCOMPARE(found[1].code, u"W-03"_s);
        QCOMPARE(found[1].raisedMs, 1000);
        QCOMPARE(found[1].end, AlarmRow::End::Returned);
        QCOMPARE(found[1].returnedMs, 7);
        QVERIFY(!found[1].wantsAcknowledgement);
        QCOMPARE(found[1].acknowledgedMs, 8);
        QCOMPARE(found[1].acknowledgedBy, u"王"_s);
        QCOMPARE(found[1].count, 12);
        QVERIFY(found[1].isShelved);
        QCOMPARE(found[1].detail.size(), AlarmLog::detailLength);
    }

    void rowWrittenAgainIsChanged()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        AlarmRow alarm = row(1);
        QVERIFY(write(*database, {alarm}));
        alarm.end = AlarmRow::End::Returned;
        alarm.returnedMs = 5;
        alarm.count = 3;
        QVERIFY(write(*database, {alarm}));
        const QList<AlarmRow> found = page(*database);
        QCOMPARE(found.size(), 1);
        QCOMPARE(found[0].returnedMs, 5);
        QCOMPARE(found[0].count, 3);
    }

    void acknowledgingCoversTheEarlierOnes()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        AlarmRow notice = row(2);
        notice.wantsAcknowledgement = false;
        QVERIFY(write(*database, {row(1), notice, row(3, u"C-02"_s), row(4), row(5)}));
        AlarmChanges changes;
        changes.acknowledgements = {{u"C-01"_s, 4, 99, u"Li"_s}};
        QVERIFY(AlarmLog::write(*database, changes));
        QList<qint64> times;
        for (const AlarmRow& found : page(*database))
            times << found.acknowledgedMs;
        QCOMPARE(times, (QList<qint64>{0, 99, 0, 0, 99}));
    }

    void whatWasActiveAtACrashHasAnUnknownEnd()
    {
        const QTemporaryDir folder;
        {
            const auto database = opened(folder);
            AlarmRow gone = row(1);
            gone.end = AlarmRow::End::Returned;
            gone.returnedMs = 3;
            AlarmChanges changes;
            changes.rows = {gone, row(2)};
            changes.shelves = QList<AlarmShelf>{{u"L-03"_s, 10, 20, u"Li"_s}};
            QVERIFY(AlarmLog::write(*database, changes));
        }
        const auto database = opened(folder);
        const auto start = AlarmLog::begin(*database);
        QVERIFY(start);
        QCOMPARE(start->lastId, 2);
        QCOMPARE(start->shelves.size(), 1);
        QCOMPARE(start->shelves[0].code, u"L-03"_s);
        QCOMPARE(start->shelves[0].untilMs, 20);
        QCOMPARE(start->shelves[0].by, u"Li"_s);
        QCOMPARE(page(*database)[0].end, AlarmRow::End::Unknown);
        QCOMPARE(page(*database)[1].end, AlarmRow::End::Returned);
    }

    void pagesFollowOneAnotherWithoutAGap()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        QVERIFY(fillAlarmLog(*database, 1000));
        qint64 before = 0;
        qint64 expected = 1000;
        for (int i = 0; i < 5; ++i) {
            const QList<AlarmRow> found = page(*database, before);
            QCOMPARE(found.size(), logPageRows);
            for (const AlarmRow& alarm : found)
                QCOMPARE(alarm.id, expected--);
            before = found.last().id;
        }
        QVERIFY(page(*database, before).isEmpty());
    }

    void hundredThousandAreReadByPages()
    {
        const QTemporaryDir folder;
        {
            const auto database = opened(folder);
            QVERIFY(fillAlarmLog(*database, AlarmLog::capacity));
            QVERIFY(write(*database, {row(AlarmLog::capacity + 1)}));
        }
        const auto database = opened(folder);
        const auto start = AlarmLog::begin(*database);
        const QList<AlarmRow> newest = page(*database);
        const QList<AlarmRow> middle = page(*database, AlarmLog::capacity / 2);
        QVERIFY(start && newest.size() == logPageRows && middle.size() == logPageRows);
        QCOMPARE(newest[0].end, AlarmRow::End::Unknown);
    }

    void boundedInRowsAndOnTheDisk()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        QVERIFY(fillAlarmLog(*database, AlarmLog::capacity));
        const int pages = number(*database, u"PRAGMA page_count"_s);
        qint64 id = AlarmLog::capacity;
        QElapsedTimer timer;
        timer.start();
        for (int batch = 0; batch < 40; ++batch) {
            QList<AlarmRow> rows;
            for (int i = 0; i < 500; ++i)
                rows << row(++id);
            QVERIFY(write(*database, rows));
        }
        qInfo("20 000 rows into the full ring: %lld ms", timer.elapsed());
        QCOMPARE(number(*database, u"SELECT count(*) FROM alarm"_s), static_cast<int>(AlarmLog::capacity));
        QCOMPARE(number(*database, u"SELECT min(id) FROM alarm"_s),
                 static_cast<int>(id - AlarmLog::capacity + 1));
        // Its indices contain the open alarms: these 20 000 are all active and unacknowledged.
        const int after = number(*database, u"PRAGMA page_count"_s);
        QVERIFY2(after < pages * 1.15, qPrintable(u"%1 then %2"_s.arg(pages).arg(after)));
        QVERIFY(QFileInfo(database->path() + u"-wal"_s).size() < 8'000'000);
    }

    void olderRowOutsideTheRingDoesNotComeBack()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        QVERIFY(fillAlarmLog(*database, AlarmLog::capacity + 10));
        QVERIFY(write(*database, {row(AlarmLog::capacity + 11), row(5)}));
        QCOMPARE(number(*database, u"SELECT count(*) FROM alarm"_s), static_cast<int>(AlarmLog::capacity));
        QCOMPARE(number(*database, u"SELECT count(*) FROM alarm WHERE id = 5"_s), 0);
    }

    void fullDiskChangesNothing()
    {
        const QTemporaryDir folder;
        const auto database = opened(folder);
        QVERIFY(write(*database, {row(1)}));
        QVERIFY(number(*database, u"PRAGMA max_page_count = 1"_s) > 0); // the present number
        QList<AlarmRow> rows;
        for (qint64 id = 1; id < 2000; ++id) {
            rows << row(id);
            rows.last().detail = QString(AlarmLog::detailLength, u'x');
        }
        AlarmChanges changes;
        changes.rows = rows;
        const auto refused = AlarmLog::write(*database, changes);
        QVERIFY(!refused);
        QCOMPARE(refused.error().kind, StoreError::Kind::Full);
        QCOMPARE(page(*database).size(), 1);
        QVERIFY(page(*database)[0].detail.isEmpty());
    }
};

CAMPANEL_TEST(TestAlarmLog)

} // namespace test_alarm_log

#include "test_alarm_log.moc"
