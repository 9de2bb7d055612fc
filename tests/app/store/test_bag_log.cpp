// SPDX-License-Identifier: Apache-2.0
// The ring of bags: data is read back unchanged, the oldest rows are deleted, the clock may be set back, the
// file is opened again, a damaged one is replaced.
#include "app/store/logs/bag_log.h"
#include "app/store/logs/trend_export.h"
#include "app/store/logs/trend_schema.h"
#include "app/store/store_thread.h"
#include "tests/support/earlier_schema.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace test_bag_log {

using namespace campanel::store;
namespace test = campanel::test;
using namespace Qt::StringLiterals;

namespace {

constexpr qint64 start = 1'800'000'000'000;

Bag bagAt(qint64 timeMs, double deviationMm = 0.012)
{
    Bag bag;
    bag.timeMs = timeMs;
    bag.programName = u"Biscuit 250"_s;
    bag.programVersion = 3;
    bag.setLengthMm = 250;
    bag.deviationMm = deviationMm;
    bag.rateBagsPerMin = 300;
    return bag;
}

QList<Bag> all(Database& database)
{
    QList<Bag> bags;
    if (!BagLog(database).forEach(0, 2 * start, [&](const Bag& bag) { bags << bag; }))
        bags.clear();
    return bags;
}

bool add(Database& database, const QList<Bag>& bags, qint64 kept = BagLog::bagsKept)
{
    return database.transaction([&] { return BagLog(database, kept).add(bags); }).has_value();
}

int programs(Database& database)
{
    auto counted = database.execute(u"SELECT count(*) FROM program"_s);
    return counted && counted->next() ? counted->value(0).toInt() : -1;
}

} // namespace

class TestBagLog : public QObject {
    Q_OBJECT

private slots:
    void comesOutAsItWentIn()
    {
        const auto database = Database::inMemory(trendDatabase());
        Bag full = bagAt(start, -0.345);
        full.lengths = 2;
        full.markErrorMm = -0.07;
        full.followingErrorMm = 0.512;
        full.flags = Bag::Tracked | Bag::ProductAcross;
        Bag bare = bagAt(start + 200, 1.5);
        bare.rateBagsPerMin.reset();
        QVERIFY(add(*database, {full, bare}));
        QCOMPARE(all(*database), QList<Bag>({full, bare}));
        QCOMPARE(full.lengthMm(), 499.655);
        QCOMPARE(BagLog(*database).count().value_or(-1), 2);
        QCOMPARE(BagLog(*database).countBetween(start, start + 200, 10).value_or(-1), 1);
    }

    void ringKeepsTheNewest()
    {
        const auto database = Database::inMemory(trendDatabase());
        constexpr qint64 kept = 100;
        for (int batch = 0; batch < 40; ++batch) {
            QList<Bag> bags;
            for (int i = 0; i < 7; ++i)
                bags << bagAt(start + (batch * 7 + i) * 200, 0.001 * i);
            if (batch < 10)
                bags.first().programName = u"an old one"_s;
            QVERIFY(add(*database, bags, kept));
        }
        const QList<Bag> left = all(*database);
        QCOMPARE(left.size(), kept);
        QCOMPARE(left.first().timeMs, start + (40 * 7 - kept) * 200);
        QCOMPARE(left.last().timeMs, start + (40 * 7 - 1) * 200);
        QCOMPARE(BagLog(*database, kept).count().value_or(-1), kept);
        QCOMPARE(programs(*database), 1); // the other one has no bags left
    }

    // Bags of a clock that was set back, or that counts from 1970, are kept: those that were written first
    // go.
    void ringDropsWhatWasWrittenFirst_data()
    {
        QTest::addColumn<qint64>("beginMs");
        QTest::newRow("set back by a second") << start - 1000;
        QTest::newRow("set back into the bags") << start + 10;
        QTest::newRow("set back by a day") << start - 86'400'000;
        QTest::newRow("counted from 1970") << qint64{1000};
    }

    void ringDropsWhatWasWrittenFirst()
    {
        QFETCH(qint64, beginMs);
        const auto database = Database::inMemory(trendDatabase());
        constexpr int kept = 100;
        QList<Bag> bags;
        for (int i = 0; i < kept; ++i)
            bags << bagAt(start + i * 20, 0.001 * i);
        QVERIFY(add(*database, bags, kept));
        for (int i = 0; i < kept; ++i) {
            QVERIFY(add(*database, {bagAt(beginMs + i * 7, 1)}, kept));
            int fresh = 0;
            double oldest = 1;
            for (const Bag& bag : all(*database)) {
                fresh += bag.deviationMm == 1 ? 1 : 0;
                oldest = std::min(oldest, bag.deviationMm);
            }
            QCOMPARE(fresh, i + 1);
            if (fresh < kept)
                QCOMPARE(oldest, 0.001 * (i + 1));
        }
        QCOMPARE(all(*database).size(), kept);
        QCOMPARE(BagLog(*database).count().value_or(-1), kept);
    }

    void clockThatIsSetBackLosesNoBag()
    {
        const auto database = Database::inMemory(trendDatabase());
        QVERIFY(add(*database, {bagAt(start), bagAt(start + 1), bagAt(start + 1000)}));
        QVERIFY(add(*database, {bagAt(start, 0.2), bagAt(start, 0.3)}));
        const QList<Bag> bags = all(*database);
        QCOMPARE(bags.size(), 5);
        QCOMPARE(bags[2].timeMs, start + 2); // the next free milliseconds
        QCOMPARE(bags[2].deviationMm, 0.2);
        QCOMPARE(bags[3].timeMs, start + 3);
    }

    void isFoundAgain()
    {
        const QTemporaryDir folder;
        for (int round = 0; round < 2; ++round) {
            const auto database = Database::open(folder.path(), trendDatabase());
            QVERIFY(database);
            QCOMPARE(all(**database).size(), round);
            QVERIFY(add(**database, {bagAt(start + round)}));
        }
        QVERIFY(QFile::exists(folder.filePath(u"trends.sqlite"_s)));
        QVERIFY(!QFile::exists(folder.filePath(u"campanel.sqlite"_s)));
    }

    void fullDiskKeepsWhatWasThere()
    {
        const QTemporaryDir folder;
        const auto database = Database::open(folder.path(), trendDatabase());
        QVERIFY(database && add(**database, {bagAt(start)}));
        auto pages = (*database)->execute(u"PRAGMA page_count"_s);
        QVERIFY(pages && pages->next());
        const QString limit = u"PRAGMA max_page_count = %1"_s.arg(pages->value(0).toInt());
        pages->finish();
        QVERIFY((*database)->execute(limit));
        QList<Bag> many;
        for (int i = 1; i < 3000; ++i)
            many << bagAt(start + i);
        const auto added = (*database)->transaction([&] { return BagLog(**database).add(many); });
        QVERIFY(!added);
        QCOMPARE(added.error().kind, StoreError::Kind::Full);
        QCOMPARE(all(**database).size(), 1);
        QCOMPARE(BagLog(**database).count().value_or(-1), 1);
    }

    // Only when it is read; then a new one is created, and one damaged file is kept.
    void damagedFileGivesWay()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"trends.sqlite"_s);
        for (int round = 0; round < 2; ++round) {
            {
                const auto database = Database::open(folder.path(), trendDatabase());
                QList<Bag> many;
                for (int i = 0; i < 3000; ++i)
                    many << bagAt(start + i);
                QVERIFY(database && add(**database, many));
            }
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadWrite));
            for (qint64 at = 4096; at < file.size(); at += 4096) {
                file.seek(at);
                file.write(QByteArray(4096, '\x5A'));
            }
            file.close();
            StoreThread store(folder.path(), trendDatabase());
            QSignalSpy opened(&store, &StoreThread::opened);
            store.open();
            std::optional<StoreError> error;
            store.run(
                this,
                [](Database& database) { return BagLog(database).forEach(0, 2 * start, [](const Bag&) {}); },
                [&](const auto& read) { error = read ? std::nullopt : std::optional(read.error()); });
            QTRY_VERIFY(error);
            QCOMPARE(error->kind, StoreError::Kind::Damaged);
            store.beginAnew();
            QTRY_COMPARE(opened.size(), 2);
            QVERIFY(!opened[1][0].value<StoreThread::Report>().opening.damagedKeptAs.isEmpty());
            bool isKept = false;
            store.run(
                this, [](Database& database) { return add(database, {bagAt(start)}); },
                [&](bool added) { isKept = added; });
            QTRY_VERIFY(isKept);
        }
        const QStringList aside = QDir(folder.path())
                                      .entryList({u"trends.sqlite.damaged-*"_s}, QDir::Files)
                                      .filter(QRegularExpression(u"\\d$"_s));
        QCOMPARE(aside.size(), 1);
    }

    void bagsOfAClockThatIsNotSetAreMarked()
    {
        const auto database = Database::inMemory(trendDatabase());
        Bag unset = bagAt(start + 1000);
        unset.flags = Bag::Tracked | Bag::ClockNotSet; // as the panel knows
        QVERIFY(add(*database, {bagAt(start), unset, bagAt(start + 2000)}));
        QVERIFY(!*BagLog(*database).hasClockNotSet(start, start + 1000));
        QVERIFY(*BagLog(*database).hasClockNotSet(start, start + 1001));
        // Before this program existed, and far behind the newest bag; a clock that is set back by seconds is
        // right.
        constexpr qint64 hour = 3'600'000;
        QVERIFY(add(*database, {bagAt(1000), bagAt(start - hour), bagAt(start - 1000)}));
        QList<bool> marks;
        for (const Bag& bag : all(*database))
            marks << (bag.flags & Bag::ClockNotSet);
        QCOMPARE(marks, QList<bool>({true, true, false, false, true, false}));
        QCOMPARE(all(*database)[4].flags & Bag::Tracked, Bag::Tracked);
        const auto csv = bagsCsv(*database, 0, start + 5000, 10);
        QCOMPARE(csv->count(",not set\n"), 3);
        QCOMPARE(csv->count(",set\n"), 3);
    }

    void bagsOfAClockThatRanAheadAreMarkedOnceItIsProven()
    {
        constexpr qint64 day = 86'400'000;
        const auto database = Database::inMemory(trendDatabase());
        QVERIFY(add(*database, {bagAt(start), bagAt(start + 400 * day), bagAt(start + 401 * day)}));
        QVERIFY(add(*database, {bagAt(start + day)}));
        Bag proven = bagAt(start + 2 * day);
        proven.clock = ClockState::Proven;
        QVERIFY(add(*database, {proven, bagAt(start + 3 * day)}));
        QList<bool> marks;
        for (const Bag& bag : all(*database))
            marks << (bag.flags & Bag::ClockNotSet);
        QCOMPARE(marks, QList<bool>({false, true, false, false, true, true}));
        QVERIFY(*BagLog(*database).hasClockNotSet(start + 400 * day, start + 402 * day));
        QVERIFY(!*BagLog(*database).hasClockNotSet(start + 2 * day, start + 4 * day));
    }

    void aFileOfTheEarlierSchemaIsReadAndMarked()
    {
        const QTemporaryDir folder;
        {
            const auto database = *Database::open(folder.path(), test::earlierSchema<&trendDatabase, 1>());
            QVERIFY(database->execute(u"INSERT INTO program VALUES (1, 'Biscuit', 3, 250000, ?)"_s, {start}));
            QVERIFY(
                database->execute(u"INSERT INTO bag VALUES (?, 1, 0, 1, NULL, NULL, NULL, 0)"_s, {start}));
            QVERIFY(database->execute(u"UPDATE ring SET held = 1 WHERE name = 'bag'"_s));
        }
        const auto database = *Database::open(folder.path(), trendDatabase());
        QCOMPARE(database->opening().migratedFrom, 1);
        QVERIFY(add(*database, {bagAt(2000)}));
        QCOMPARE(all(*database).size(), 2);
        QVERIFY(*BagLog(*database).hasClockNotSet(0, start));
        QVERIFY(!*BagLog(*database).hasClockNotSet(start, 2 * start));
        QVERIFY(add(*database, {bagAt(3000)}, 2)); // the bag of the earlier schema goes first
        QCOMPARE(all(*database).first().timeMs, 2000);
    }

    void marksDoNotGrowTheFileBeyondItsLimit()
    {
        const QTemporaryDir folder;
        constexpr int count = 20'000;
        constexpr qint64 maxBytes = 40;
        {
            const auto database = *Database::open(folder.path(), trendDatabase());
            QList<Bag> bags;
            for (int i = 0; i < count; ++i) {
                bags << bagAt(start + i * 200, 0.001 * (i % 500));
                bags.last().markErrorMm = 0.001 * (i % 300);
                bags.last().followingErrorMm = 0.001 * (i % 400);
                bags.last().flags = Bag::Tracked | Bag::ClockNotSet;
            }
            QVERIFY(add(*database, bags));
        }
        const qint64 bytes = QFileInfo(folder.filePath(u"trends.sqlite"_s)).size();
        QVERIFY2(bytes <= maxBytes * count, qPrintable(QString::number(double(bytes) / count)));
    }

    void csvHasALineForEachBag()
    {
        const auto database = Database::inMemory(trendDatabase());
        Bag bag = bagAt(start, -0.5);
        bag.programName = u"a \"quoted\", name"_s;
        bag.flags = Bag::Tracked | Bag::Empty;
        QVERIFY(add(*database, {bag, bagAt(start + 1000)}));
        const auto csv = bagsCsv(*database, start, start + 1000, 10);
        QVERIFY(csv);
        const QList<QByteArray> lines = csv->trimmed().split('\n');
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[0].startsWith("each_bag_utc,each_bag_local,"));
        QVERIFY2(lines[1].startsWith("2027-01-15T08:00:00.000Z,"), lines[1].constData());
        QVERIFY2(
            lines[1].endsWith(",\"a \"\"quoted\"\", name\",3,1,249.500,-0.500,,,300.000,tracked empty,set"),
            lines[1].constData());
        QVERIFY(bagsCsv(*database, start, start + 2000, 1)->isEmpty()); // too many
    }
};

CAMPANEL_TEST(TestBagLog)

} // namespace test_bag_log

#include "test_bag_log.moc"
