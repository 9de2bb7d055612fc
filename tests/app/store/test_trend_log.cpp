// SPDX-License-Identifier: Apache-2.0
// Trends in three levels of detail against a plain calculation over all values; rings, gaps, the selected
// level, the clock set back.
#include "app/store/database/ring.h"
#include "app/store/logs/trend_export.h"
#include "app/store/logs/trend_schema.h"
#include "app/store/logs/trend_window.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <map>
#include <random>

namespace test_trend_log {

using namespace campanel::store;
using Level = TrendLog::Level;

namespace {

constexpr qint64 start = 1'800'000'000; // s; a whole hour
constexpr qint64 msPerS = 1000;

struct Value {
    qint64 second = 0;
    double value = 0;
};

bool add(Database& database, const QList<TrendPart>& parts)
{
    return database.transaction([&] { return TrendLog(database).add(parts); }).has_value();
}

TrendPart part(qint64 second, std::initializer_list<double> values,
               TrendQuantity quantity = TrendQuantity::Deviation)
{
    TrendPart part{second, quantity, {}};
    for (const double value : values)
        part.bucket.add(value, std::abs(value) <= 0.5);
    return part;
}

std::map<qint64, TrendBucket> buckets(Database& database, Level level)
{
    std::map<qint64, TrendBucket> found;
    const auto read = TrendLog(database).forEach(
        level, 0, 2 * start * msPerS, {TrendQuantity::Deviation},
        [&](qint64 startMs, TrendQuantity, const TrendBucket& bucket) { found[startMs] = bucket; });
    return read ? found : std::map<qint64, TrendBucket>();
}

// Mean and standard deviation in two passes over the plain numbers.
struct Plain {
    explicit Plain(const std::vector<double>& values)
    {
        for (const double value : values) {
            mean += value / static_cast<double>(values.size());
            low = std::min(low, value);
            high = std::max(high, value);
        }
        for (const double value : values)
            deviation += (value - mean) * (value - mean) / static_cast<double>(values.size() - 1);
        deviation = std::sqrt(deviation);
    }
    double mean = 0;
    double deviation = 0;
    double low = 1e9;
    double high = -1e9;
};

} // namespace

class TestTrendLog : public QObject {
    Q_OBJECT

private slots:
    void agreesWithAPlainCalculation()
    {
        const unsigned seed = std::random_device{}();
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::normal_distribution<double> scatter(250, 0.3);
        const auto database = Database::inMemory(trendDatabase());
        std::vector<double> values;
        std::map<qint64, std::vector<double>> ofMinutes;
        for (int batch = 0; batch < 50; ++batch) {
            QList<TrendPart> parts;
            for (int i = 0; i < 20; ++i) {
                const qint64 second = start + std::uniform_int_distribution<qint64>(0, 3599)(random);
                const double value = std::round(scatter(random) * 1000) / 1000;
                parts << part(second, {value});
                values.push_back(value);
                ofMinutes[second / 60].push_back(value);
            }
            QVERIFY(add(*database, parts));
        }
        const auto minutes = buckets(*database, Level::Minute);
        QCOMPARE(minutes.size(), ofMinutes.size());
        for (const auto& [minute, plain] : ofMinutes) {
            const TrendBucket bucket = minutes.at(minute * 60 * msPerS);
            QCOMPARE(bucket.count, static_cast<qint64>(plain.size()));
            QVERIFY(std::abs(bucket.mean() - (plain.size() > 1 ? Plain(plain).mean : plain[0])) < 1e-9);
        }
        const auto window =
            readTrends(*database, {start * msPerS, (start + 3600) * msPerS, {TrendQuantity::Deviation}, 400});
        QVERIFY(window);
        const TrendStatistics& statistics = window->curves[0].statistics;
        const Plain plain(values);
        QCOMPARE(statistics.count(), static_cast<double>(values.size()));
        QVERIFY(std::abs(statistics.mean() - plain.mean) < 1e-9);
        QVERIFY2(std::abs(statistics.deviation() - plain.deviation) < 1e-9,
                 qPrintable(QString::number(statistics.deviation() - plain.deviation)));
        QCOMPARE(statistics.lowest(), plain.low);
        QCOMPARE(statistics.highest(), plain.high);
    }

    void shareWithinIsCounted()
    {
        const auto database = Database::inMemory(trendDatabase());
        QVERIFY(add(*database, {part(start, {0.1, 0.6, -0.5, -0.51})}));
        const auto window =
            readTrends(*database, {start * msPerS, (start + 60) * msPerS, {TrendQuantity::Deviation}, 400});
        QCOMPARE(window->curves[0].statistics.shareWithin(), 0.5);
        QVERIFY(window->hasAny);
    }

    void quantitiesDoNotMix()
    {
        const auto database = Database::inMemory(trendDatabase());
        QVERIFY(add(*database, {part(start, {1}, TrendQuantity::Rate),
                                part(start, {2}, TrendQuantity::Latency), part(start, {3})}));
        const auto window = readTrends(
            *database,
            {start * msPerS, (start + 60) * msPerS, {TrendQuantity::Latency, TrendQuantity::Rate}, 400});
        QCOMPARE(window->curves.size(), 2);
        QCOMPARE(window->curves[0].statistics.mean(), 2.0);
        QCOMPARE(window->curves[1].statistics.mean(), 1.0);
    }

    void ringsKeepTheNewest()
    {
        const QTemporaryDir folder;
        const auto opened = Database::open(folder.path(), trendDatabase());
        QVERIFY(opened);
        Database& database = **opened;
        // The ring's capacity in hours for one quantity, and 50 more.
        const qint64 hours = TrendLog::rowsKept(Level::Hour) + 50;
        QVERIFY(database.execute(
            QStringLiteral("INSERT INTO trend_hour WITH RECURSIVE n(i) AS (VALUES(0) UNION ALL "
                           "SELECT i + 1 FROM n WHERE i < ?) SELECT i * 8 + 1, 1, 1, 1, 1, 1, 1, 0 FROM n"),
            {hours - 2}));
        QVERIFY(database.execute(QStringLiteral("INSERT INTO ring_era VALUES ('trend_hour', 0, 0, ?)"),
                                 {(hours - 2) * 8 + 1}));
        QVERIFY(database.execute(QStringLiteral("UPDATE ring SET held = ? WHERE name = 'trend_hour'"),
                                 {hours - 1}));
        QVERIFY(add(database, {part((hours - 1) * 3600, {0.1})}));
        const auto left = buckets(database, Level::Hour);
        QCOMPARE(static_cast<qint64>(left.size()), TrendLog::rowsKept(Level::Hour));
        QCOMPARE(left.begin()->first, 50 * 3600 * msPerS);
        QCOMPARE(rowsOf(database, TrendLog::table(Level::Hour)).value_or(-1),
                 TrendLog::rowsKept(Level::Hour));
    }

    // The clock may be set back by any time, or count from 1970 with a dead battery: what is written now is
    // kept, and what was written first is deleted.
    void ringsDropWhatWasWrittenFirst_data()
    {
        QTest::addColumn<qint64>("setBackS");
        QTest::newRow("not at all") << qint64{0};
        QTest::newRow("an hour") << qint64{3600};
        QTest::newRow("twenty hours") << qint64{20 * 3600};
        QTest::newRow("to the beginning of time") << start;
        QTest::newRow("from ten years ahead") << -qint64{87'600 * 3600};
    }

    void ringsDropWhatWasWrittenFirst()
    {
        QFETCH(qint64, setBackS);
        const auto database = Database::inMemory(trendDatabase()); // keeps a tenth
        const qint64 kept = TrendLog::rowsKept(Level::Second) / 10;
        const auto write = [&](qint64 fromS, qint64 count) {
            QList<TrendPart> parts;
            for (qint64 i = 0; i < count; ++i)
                parts << part(fromS + i, {0.1});
            QVERIFY(add(*database, parts));
        };
        // A full ring, then a tenth more by the clock that was set; then so many that nothing else is left.
        write(start, kept / 2);
        write(start + kept / 2, kept / 2);
        const qint64 laterS = start + kept - setBackS + (setBackS == 3600 ? kept : 0);
        const qint64 few = kept / 10;
        write(laterS, few);
        const auto seconds = buckets(*database, Level::Second);
        QCOMPARE(static_cast<qint64>(seconds.size()), kept);
        QVERIFY(seconds.contains(laterS * msPerS));
        QVERIFY2(!seconds.contains(start * msPerS), "what was written first");
        QVERIFY(seconds.contains((start + few) * msPerS));
        QVERIFY(seconds.contains((start + kept - 1) * msPerS));
        write(laterS + few, kept - few);
        QCOMPARE(rowsOf(*database, TrendLog::table(Level::Second)).value_or(-1), kept);
        QVERIFY(!buckets(*database, Level::Second).contains((start + kept - 1) * msPerS) || setBackS == 0);
        auto eras =
            database->execute(QStringLiteral("SELECT count(*) FROM ring_era WHERE name = 'trend_second'"));
        QVERIFY(eras && eras->next());
        QCOMPARE(eras->value(0).toInt(), 1); // the other one has no rows left
    }

    // Quantities of one second that come in two batches, in any order: no clock was set back.
    void laterQuantitiesOfAMomentBeginNoEra()
    {
        const auto database = Database::inMemory(trendDatabase());
        QVERIFY(add(*database, {part(start, {1}, TrendQuantity::Latency)}));
        QVERIFY(add(*database, {part(start, {1}, TrendQuantity::BagLength)}));
        auto eras = database->execute(QStringLiteral("SELECT max(era) FROM ring_era"));
        QVERIFY(eras && eras->next());
        QCOMPARE(eras->value(0).toInt(), 0);
    }

    // A bucket of a clock that counted from 1970 is as old as it can be, and says nothing of the present
    // ones.
    void aWrongClockDoesNotChooseTheLevel()
    {
        const auto database = Database::inMemory(trendDatabase());
        QVERIFY(add(*database, {part(1000, {1}), part(start, {1})}));
        QVERIFY(database->execute(QStringLiteral("DELETE FROM trend_second WHERE slot > 8008")));
        const qint64 from = start * msPerS;
        const auto window = readTrends(*database, {from, from + 600'000, {TrendQuantity::Deviation}, 400});
        QCOMPARE(window->level, Level::Minute);
    }

    void isFoundAgainAndGoesOn()
    {
        const QTemporaryDir folder;
        for (const double value : {0.1, 0.3}) {
            const auto database = Database::open(folder.path(), trendDatabase());
            QVERIFY(database && add(**database, {part(start, {value})}));
        }
        const auto database = Database::open(folder.path(), trendDatabase());
        const TrendBucket bucket = buckets(**database, Level::Second).at(start * msPerS);
        QCOMPARE(bucket.count, 2);
        QCOMPARE(bucket.mean(), 0.2);
        QCOMPARE(bucket.lowest(), 0.1);
        QCOMPARE(bucket.highest(), 0.3);
        QCOMPARE(rowsOf(**database, TrendLog::table(Level::Second)).value_or(-1), 1);
    }

    void clockSetBackJoinsWhatIsThere()
    {
        const auto database = Database::inMemory(trendDatabase());
        QVERIFY(add(*database, {part(start, {0.1}), part(start + 3600, {0.2})}));
        QVERIFY(add(*database, {part(start, {0.5}), part(start - 7200, {0.4})}));
        const auto seconds = buckets(*database, Level::Second);
        QCOMPARE(seconds.size(), std::size_t(3));
        QCOMPARE(seconds.at(start * msPerS).count, 2);
        QCOMPARE(seconds.begin()->first, (start - 7200) * msPerS);
    }

    void columnsHaveNoValuesWhereNothingWasRecorded()
    {
        const auto database = Database::inMemory(trendDatabase());
        QVERIFY(add(*database, {part(start, {1}), part(start + 1, {3}), part(start + 300, {2})}));
        const auto window =
            readTrends(*database, {start * msPerS, (start + 600) * msPerS, {TrendQuantity::Deviation}, 100});
        QCOMPARE(window->level, Level::Second);
        QCOMPARE(window->columnMs, 6000);
        const QList<TrendColumn>& columns = window->curves[0].columns;
        QCOMPARE(columns.size(), 2);
        QCOMPARE(columns[0].bucket.mean(), 2.0);
        QCOMPARE(columns[0].bucket.highest(), 3.0);
        QCOMPARE(columns[1].startMs, (start + 300) * msPerS);
    }

    void levelSuitsSpanAndAge_data()
    {
        QTest::addColumn<qint64>("span");
        QTest::addColumn<qint64>("age");
        QTest::addColumn<int>("level");
        QTest::newRow("ten minutes") << qint64(600) << qint64(0) << int(Level::Second);
        QTest::newRow("ten minutes of yesterday") << qint64(600) << qint64(86400) << int(Level::Minute);
        QTest::newRow("ten minutes of the month before last")
            << qint64(600) << qint64(60 * 86400) << int(Level::Hour);
        QTest::newRow("eight hours") << qint64(8 * 3600) << qint64(0) << int(Level::Minute);
        QTest::newRow("a week") << qint64(7 * 86400) << qint64(0) << int(Level::Minute);
        QTest::newRow("a month") << qint64(30 * 86400) << qint64(0) << int(Level::Hour);
    }

    void levelSuitsSpanAndAge()
    {
        QFETCH(qint64, span);
        QFETCH(qint64, age);
        QFETCH(int, level);
        const qint64 to = (start - age) * msPerS;
        const qint64 day = 86'400'000;
        const qint64 from = to - span * msPerS;
        const auto first = [from](qint64 keptMs) { return std::max(from, start * msPerS - keptMs); };
        QCOMPARE(int(levelFor(from, to, {first(4 * 3'600'000), first(31 * day), first(366 * day)})), level);
    }

    // A log that began an hour ago has no coarser levels before that.
    void youngLogIsReadBySeconds()
    {
        const qint64 first = start * msPerS - 3'600'000;
        QCOMPARE(levelFor(first - 600'000, first + 600'000, {first + 30'000, first, first}), Level::Second);
        QCOMPARE(levelFor(0, 1000, {}), Level::Hour);
    }

    void csvSaysWhatEachLineIs()
    {
        const auto database = Database::inMemory(trendDatabase());
        QVERIFY(add(*database, {part(start, {1, 2}), part(start + 60, {3})}));
        const qint64 from = start * msPerS;
        const auto window = readTrends(*database, {from, from + 60'000, {TrendQuantity::Deviation}, 400});
        const QList<QByteArray> lines = trendsCsv(*window, from, from + 60'000).trimmed().split('\n');
        QCOMPARE(lines.size(), 2); // not the minute after
        QVERIFY(lines[0].startsWith("stretch_begin_utc,stretch_begin_local,stretch_s,quantity"));
        QVERIFY2(lines[1].startsWith("2027-01-15T08:00:00.000Z,") &&
                     lines[1].endsWith(",1,deviation_mm,2,1.500,1.000,2.000"),
                 lines[1].constData());
    }
};

CAMPANEL_TEST(TestTrendLog)

} // namespace test_trend_log

#include "test_trend_log.moc"
