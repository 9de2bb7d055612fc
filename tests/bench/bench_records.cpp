// SPDX-License-Identifier: Apache-2.0
// Ten million bags and full rings of trends: the waiting time of the page, the size of a bag on the disk, and
// that neither file nor process grows with more bags.
#include "bench_pages.h"

#include "app/panel/controller/controller.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"
#include "app/panel/trends/trends.h"
#include "app/shell/memory.h"
#include "app/store/logs/bag_log.h"
#include "app/store/logs/trend_schema.h"
#include "tests/looks/demo_link.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileInfo>
#include <QTemporaryDir>

#include <stdexcept>

namespace campanel::bench {
namespace {

using namespace Qt::StringLiterals;
using panel::Trends;

constexpr qint64 bags = store::BagLog::bagsKept;
constexpr qint64 bagMs = 200; // 300 a minute
constexpr qint64 bagsPerStatement = 500'000;

void must(const store::Database::Result& done)
{
    if (!done)
        throw std::runtime_error(done.error().detail.toStdString());
}

double megabytes(const QString& path)
{
    return static_cast<double>(QFileInfo(path).size()) / 1e6;
}

// Adds bags up to `endMs` like a controller that follows marks.
void fillBags(store::Database& database, qint64 endMs)
{
    must(database.execute(u"INSERT INTO program VALUES (1, 'Biscuit 250', 3, 250000, ?)"_s, {endMs}));
    const QString some =
        uR"(INSERT INTO bag WITH RECURSIVE n(i) AS (VALUES(?1) UNION ALL SELECT i + 1 FROM n WHERE i < ?2)
        SELECT ?3 + i * 200, 1, (i * 7919) % 601 - 300, 1 + (i % 400 = 0), (i * 104729) % 401 - 200,
               (i * 1299709) % 1201 - 600, 300000, 1, 0 FROM n)"_s;
    for (qint64 first = 0; first < bags; first += bagsPerStatement)
        must(database.execute(some, {first, first + bagsPerStatement - 1, endMs - bags * bagMs}));
    must(database.execute(u"UPDATE ring SET held = ? WHERE name = 'bag'"_s, {bags}));
    must(database.execute(u"INSERT INTO ring_era VALUES ('bag', 0, ?, ?)"_s, {endMs - bags * bagMs, endMs}));
    must(database.execute(u"PRAGMA wal_checkpoint(TRUNCATE)"_s));
}

// Adds all six quantities from the deviations of the bags, and a year of hours.
void fillTrends(store::Database& database, qint64 endMs)
{
    using Log = store::TrendLog;
    for (const Log::Level level : {Log::Level::Second, Log::Level::Minute, Log::Level::Hour}) {
        const qint64 length = Log::lengthMs(level);
        const qint64 buckets = Log::rowsKept(level) / store::trendQuantities;
        const QString fill =
            uR"(INSERT INTO %1 WITH RECURSIVE n(i) AS (VALUES(?1) UNION ALL SELECT i + 1 FROM n WHERE i < ?2),
            q(k) AS (VALUES(0), (1), (2), (3), (4), (5))
            SELECT i * 8 + k, 300, (i * 7919) % 601, 27000000, -300 - i % 7, 300 + i % 11, 299, 0 FROM n, q)"_s
                .arg(Log::table(level));
        must(database.execute(fill, {endMs / length - buckets, endMs / length - 1}));
        must(database.execute(u"UPDATE ring SET held = ? WHERE name = ?"_s,
                              {Log::rowsKept(level), Log::table(level)}));
        must(database.execute(u"INSERT INTO ring_era VALUES (?1, 0, ?2, ?3)"_s,
                              {Log::table(level), (endMs / length - buckets) * 8, endMs / length * 8 - 1}));
    }
    must(database.execute(u"PRAGMA wal_checkpoint(TRUNCATE)"_s));
}

// The panel's objects without its window.
struct Panel {
    explicit Panel(const QString& folder, qint64 nowMs)
        : settings(folder + u"/settings.ini"_s, nullptr)
        , machine(link, settings, nullptr)
        , records(folder, nullptr)
        , trends(machine, settings, records, folder, nullptr)
        , wallMs(nowMs)
    {
        trends.setWallClock([this] { return wallMs; });
    }

    looks::DemoLink link{nullptr};
    panel::Settings settings;
    panel::Controller machine;
    panel::DatabaseService records;
    panel::Trends trends;
    qint64 wallMs;

    // Waits until no request is left: opening causes another request.
    void settle()
    {
        for (int round = 0; round < 2; ++round) {
            QEventLoop untilAnswered;
            trends.store().run(
                &untilAnswered, [](store::Database&) { return true; }, [&](bool) { untilAnswered.quit(); });
            untilAnswered.exec();
        }
    }
    // Returns the time from the request to the display.
    double askMs(const std::function<void()>& ask)
    {
        QEventLoop untilShown;
        QObject::connect(&trends, &Trends::shownChanged, &untilShown, &QEventLoop::quit);
        QElapsedTimer timer;
        timer.start();
        ask();
        untilShown.exec();
        return static_cast<double>(timer.nsecsElapsed()) / 1e6;
    }
};

// Writes like a running machine: 25 bags in five seconds, the oldest ones are deleted.
void addBags(store::Database& database, qint64 fromMs, int batches)
{
    constexpr int bagsOfABatch = 25;
    for (int batch = 0; batch < batches; ++batch) {
        QList<store::Bag> more;
        QList<store::TrendPart> parts;
        for (int i = 0; i < bagsOfABatch; ++i) {
            store::Bag bag;
            bag.timeMs = fromMs + (batch * bagsOfABatch + i) * bagMs;
            bag.programName = u"Biscuit 250"_s;
            bag.programVersion = 3;
            bag.setLengthMm = 250;
            bag.deviationMm = 0.05;
            more << bag;
            store::TrendPart part{bag.timeMs / 1000, store::TrendQuantity::Deviation, {}};
            part.bucket.add(bag.deviationMm, true);
            parts << part;
        }
        const auto kept = database.transaction([&]() -> tl::expected<void, store::StoreError> {
            if (const auto added = store::BagLog(database).add(more); !added)
                return added;
            return store::TrendLog(database).add(parts);
        });
        if (!kept)
            throw std::runtime_error(kept.error().detail.toStdString());
    }
}

std::unique_ptr<store::Database> opened(const QString& folder)
{
    auto database = store::Database::open(folder, store::trendDatabase());
    if (!database)
        throw std::runtime_error(database.error().detail.toStdString());
    return std::move(*database);
}

} // namespace

Figures measureRecords()
{
    shell::keepMemoryFlat();
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"trends.sqlite"_s);
    const qint64 nowMs = QDateTime::currentMSecsSinceEpoch() / 1000 * 1000;
    double bytesPerBag = 0;
    {
        const auto database = opened(folder.path());
        fillBags(*database, nowMs);
        bytesPerBag = megabytes(path) * 1e6 / static_cast<double>(bags);
        fillTrends(*database, nowMs);
    }
    const double fullMb = megabytes(path);
    Figures figures = measurePages(folder.path());

    Panel panel(folder.path(), nowMs);
    panel.trends.showSpan(3'600'000);
    for (const int quantity : {Trends::Rate}) // a third one
        panel.trends.toggle(quantity);
    const double openMs = panel.askMs([&] {
        panel.trends.open();
        panel.trends.setWatched(true);
    });
    panel.settle();
    std::vector<double> hours;
    std::vector<double> weeks;
    for (int i = 0; i < 20; ++i) {
        hours.push_back(panel.askMs([&] { panel.trends.showSpan(3'600'000); }));
        weeks.push_back(panel.askMs([&] { panel.trends.showSpan(7 * 86'400'000.0); }));
    }
    const double monthMs = panel.askMs([&] { panel.trends.showSpan(30 * 86'400'000.0); });

    const auto database = opened(folder.path());
    const auto readMany = [&panel](int times) {
        for (int i = 0; i < times; ++i)
            (void)panel.askMs([&] { panel.trends.showSpan(i % 2 == 0 ? 3'600'000.0 : 7 * 86'400'000.0); });
    };
    addBags(*database, nowMs, 1000); // both caches are full now
    readMany(100);
    const double beforeMb = residentMb(QCoreApplication::applicationPid());
    QElapsedTimer timer;
    timer.start();
    constexpr int batches = 4000;
    addBags(*database, nowMs + 10'000'000, batches);
    const double batchMs = static_cast<double>(timer.elapsed()) / batches;
    readMany(200);
    const double grownMb = residentMb(QCoreApplication::applicationPid()) - beforeMb;
    must(database->execute(u"PRAGMA wal_checkpoint(TRUNCATE)"_s));
    const Figures ofTheStore{
        {"Trends, file and last hour opened with 10 million bags", openMs, pageLimitMs, "ms", "a page", true},
        {"Trends, last hour, three curves (median)", quantile(hours, 0.5), pageLimitMs, "ms", "a page", true},
        {"Trends, 7 days, three curves (median)", quantile(weeks, 0.5), pageLimitMs, "ms", "a page", true},
        {"Trends, 7 days, three curves (slowest of 20)", quantile(weeks, 1.0), pageLimitMs, "ms", "a page",
         true},
        {"Trends, 30 days, three curves", monthMs, pageLimitMs, "ms", "a page", true},
        {"bag on disk", bytesPerBag, 40, "bytes", "a row", true},
        {"10 million bags and full trends on disk", fullMb, 400, "MB", "bounded", true},
        {"file after 100 000 bags more", megabytes(path) - fullMb, 2, "MB", "bounded", true},
        {"25 bags of 5 s kept, the oldest gone", batchMs, 50, "ms", "1 % of the time", true},
        {"resident memory grown by 100 000 bags and 200 readings", grownMb, 2, "MB", "flat", true}};
    figures.insert(figures.end(), ofTheStore.begin(), ofTheStore.end());
    return figures;
}

} // namespace campanel::bench
