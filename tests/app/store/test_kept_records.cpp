// SPDX-License-Identifier: Apache-2.0
// Records of every kind as an earlier panel left them: kept_records.sql is the dump of its database and stays
// as it is; kept_records.csv has its exports, one after the other, and gets a field with each new column.
#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"
#include "app/store/logs/stop_export.h"
#include "app/store/logs/trend_export.h"
#include "app/store/logs/trend_schema.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>

namespace test_kept_records {

using namespace campanel;
using namespace campanel::store;
using namespace Qt::StringLiterals;
using State = StateInterval::State;

namespace {

constexpr qint64 start = 1'790'000'000'000;

AlarmChanges alarms()
{
    AlarmChanges changes;
    changes.rows = {{.id = 1,
                     .code = u"C-01"_s,
                     .raisedMs = start,
                     .end = AlarmRow::End::Returned,
                     .returnedMs = start + 1500,
                     .wantsAcknowledgement = true,
                     .acknowledgedMs = start + 900,
                     .acknowledgedBy = u"Anna, B"_s,
                     .count = 3,
                     .isShelved = true,
                     .detail = u"=axis \"1\""_s},
                    {.id = 2,
                     .code = u"W-05"_s,
                     .raisedMs = start + 2000,
                     .wantsAcknowledgement = false,
                     .acknowledgedBy = {},
                     .detail = {},
                     .isClockDoubtful = true},
                    {.id = 3,
                     .code = u"P-10"_s,
                     .raisedMs = start + 3000,
                     .end = AlarmRow::End::Unknown,
                     .acknowledgedBy = {},
                     .count = 2,
                     .detail = u"色标"_s}};
    changes.shelves = {{u"C-01"_s, start, start + 3'600'000, u"Anna, B"_s}};
    return changes;
}

QList<AuditEntry> auditEntries()
{
    return {{start, u"Anna, B"_s, 2, u"parameter.write"_s, u"parameter.gain"_s, u"-1.5"_s, u"2e-3"_s,
             u"0.002"_s, u"done"_s, false},
            {start + 1, {}, 0, u"user.login"_s, u"Bo"_s, {}, u"@x"_s, {}, u"refused 7"_s, true}};
}

StopChanges states()
{
    return {{{1, 0, State::Running, start, 60'000, u"Biscuit 250"_s, 3, 120.5, 70, 55, 2, 1, 4, false},
             {2, 2, State::Ready, start + 60'000, 30'500, u"Biscuit 250"_s, 3, 0, 70, 0, 0, 0, 0, true},
             {3, 2, State::Suspended, start + 90'500, 1000, {}, 0, 99.9, 70, 0, 0, 0, 0, false}},
            {{2, u"Foil, torn"_s, true, u"Anna, B"_s, start + 70'000}}};
}

QList<Bag> bags()
{
    Bag first;
    first.timeMs = start;
    first.programName = u"Biscuit; 250"_s;
    first.programVersion = 3;
    first.setLengthMm = 250;
    first.lengths = 2;
    first.deviationMm = -0.25;
    first.markErrorMm = 0.125;
    first.followingErrorMm = -0.5;
    first.rateBagsPerMin = 120.5;
    first.flags = Bag::Tracked | Bag::MarkMissed | Bag::ProductAcross | Bag::Empty;
    Bag second;
    second.timeMs = start + 500;
    second.setLengthMm = 250;
    second.flags = Bag::ClockNotSet;
    return {first, second};
}

QByteArray contentOf(const char* name)
{
    QFile file(test::sourcePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Executes the statements of a dump in a new file, without the code of the product.
[[nodiscard]] bool load(const QString& path, const QString& dump)
{
    bool isDone = false;
    {
        QSqlDatabase file = QSqlDatabase::addDatabase(u"QSQLITE"_s, u"dump"_s);
        file.setDatabaseName(path);
        isDone = !dump.isEmpty() && file.open();
        for (const QString& statement : dump.split(u";\n"_s, Qt::SkipEmptyParts))
            isDone = isDone && QSqlQuery(file).exec(statement);
    }
    QSqlDatabase::removeDatabase(u"dump"_s);
    return isDone;
}

// Returns the exports of the database, and those of bags and trends.
QByteArray exportsOf(Database& database, const CsvDialect& dialect)
{
    const auto span = *StopLog::between(database, 0, start + 1'000'000);
    const auto trends = Database::inMemory(trendDatabase());
    const auto added = trends->transaction([&trends]() -> tl::expected<void, StoreError> {
        TrendBucket bucket;
        bucket.add(1.25, true);
        bucket.add(-2, false);
        return BagLog(*trends).add(bags()).and_then([&] {
            return TrendLog(*trends).add({{start / 1000, TrendQuantity::MarkError, bucket}});
        });
    });
    if (!added)
        return {};
    const auto window = *readTrends(*trends, {start, start + 60'000, {TrendQuantity::MarkError}, 400});
    return alarmTable().csv(database, {}, dialect)->bytes + auditTable().csv(database, {}, dialect)->bytes +
           statesCsv(span, dialect) + stopsCsv(span, dialect) +
           *bagsCsv(*trends, 0, start + 1000, 10, dialect) +
           trendsCsv(window, start, start + 60'000, dialect);
}

} // namespace

class TestKeptRecords : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("TZ", "Europe/Berlin");
        tzset();
    }

    void newRecordsAreExportedAsBefore()
    {
        const QTemporaryDir folder;
        const auto database = *Database::open(folder.path());
        QVERIFY(AlarmLog::write(*database, alarms()));
        for (const AuditEntry& entry : auditEntries())
            QVERIFY(appendAudit(*database, entry));
        QVERIFY(StopLog::write(*database, states()));
        QCOMPARE(exportsOf(*database, {}) + exportsOf(*database, {';', ',', true}),
                 contentOf("tests/app/store/kept_records.csv"));
    }

    void theDumpOpensAndHasItsRows()
    {
        const QTemporaryDir folder;
        QVERIFY(load(folder.filePath(u"campanel.sqlite"_s),
                     QString::fromUtf8(contentOf("tests/app/store/kept_records.sql"))));
        const auto database = Database::open(folder.path());
        QVERIFY2(database, database ? "" : qPrintable(database.error().detail));
        constexpr int version = 9; // of the dump
        QCOMPARE((*database)->opening().migratedFrom, schemaVersion() == version ? 0 : version);
        const auto found = *alarmTable().page(**database, 0);
        QCOMPARE(found, (QList<AlarmRow>{alarms().rows[2], alarms().rows[1], alarms().rows[0]}));
        QCOMPARE(AlarmLog::begin(**database)->shelves, *alarms().shelves);
        const auto trail = *auditTable().page(**database, 0, 10);
        QCOMPARE(trail.size(), 2);
        QCOMPARE(trail[0].entry, auditEntries()[1]);
        QCOMPARE(trail[1].entry, auditEntries()[0]);
        const auto check = *verifyChain(**database);
        QCOMPARE(check.rows(), 2);
        QCOMPARE(check.fault(), ChainCheck::Fault::EndUnknown); // without the file beside the database
        const auto span = *StopLog::between(**database, 0, start + 1'000'000);
        QCOMPARE(span.intervals, states().intervals);
        QCOMPARE(span.stops, states().stops);
    }

    // One row of the list is all that a new column needs.
    void aColumnOfALaterVersionIsAddedToTheTable()
    {
        struct Row {
            qint64 id = 0;
            QString text{};
            double more = 0;
        };
        const Table<Row> table{u"thing"_s,
                               1,
                               {{.name = u"id"_s, .member = &Row::id},
                                {.name = u"text"_s, .member = &Row::text, .sought = Sought::Word},
                                {.name = u"more"_s, .member = &Row::more, .since = 2}}};
        std::vector<QStringList> steps{{u"CREATE INDEX thing_text ON thing (text)"_s}};
        table.addSteps(steps);
        QCOMPARE(steps.size(), std::size_t{2});
        QCOMPARE(steps[0], (QStringList{u"CREATE TABLE thing ( id INTEGER PRIMARY KEY, text TEXT NOT NULL)"_s,
                                        u"CREATE INDEX thing_text ON thing (text)"_s}));
        QCOMPARE(steps[1], QStringList{u"ALTER TABLE thing ADD COLUMN more REAL NOT NULL DEFAULT 0"_s});
        const auto database = Database::inMemory();
        for (const QString& statement : steps[0])
            QVERIFY(database->execute(statement));
        QVERIFY(database->execute(u"INSERT INTO thing VALUES (1, 'old')"_s));
        QVERIFY(database->execute(steps[1].first()));
        QVERIFY(table.write(*database, {2, u"new"_s, 1.5}));
        QVERIFY(table.write(*database, {2, u"newer"_s, 2.5}));
        const auto rows = *table.page(*database);
        QCOMPARE(rows.size(), 2);
        QCOMPARE(rows[0].text, u"newer"_s);
        QCOMPARE(rows[0].more, 2.5);
        QCOMPARE(rows[1].more, 0.);
        QVERIFY(table.includes({.word = u"OLD"_s}, rows[1]) && !table.includes({.word = u"OLD"_s}, rows[0]));
        QCOMPARE(table.csv(*database, {.word = u"OLD"_s})->bytes, QByteArray("id,text,more\n1,old,0\n"));
        QVERIFY(table.csv(*database, {})->bytes.contains("\n2,newer,2.5\n"));
    }

    void theDumpIsExportedAsBefore()
    {
        const QTemporaryDir folder;
        QVERIFY(load(folder.filePath(u"campanel.sqlite"_s),
                     QString::fromUtf8(contentOf("tests/app/store/kept_records.sql"))));
        const auto database = *Database::open(folder.path());
        QCOMPARE(exportsOf(*database, {}) + exportsOf(*database, {';', ',', true}),
                 contentOf("tests/app/store/kept_records.csv"));
    }
};

CAMPANEL_TEST(TestKeptRecords)

} // namespace test_kept_records

#include "test_kept_records.moc"
