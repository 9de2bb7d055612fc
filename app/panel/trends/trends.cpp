// SPDX-License-Identifier: Apache-2.0
#include "app/panel/trends/trends.h"

#include "app/panel/records/database_service.h"
#include "app/store/logs/trend_export.h"
#include "app/store/logs/trend_schema.h"

#include <QDateTime>
#include <QPointF>

#include <algorithm>
#include <cmath>
#include <memory>

namespace campanel::panel {

namespace {

using store::StoreError;
using store::TrendQuantity;

static_assert(static_cast<int>(TrendQuantity::JamResidue) == Trends::JamResidue);

constexpr qint64 shortestStepMs = 1000; // for a window that follows the time
constexpr qint64 longestStepMs = 30'000;
constexpr qint64 stepsInAWindow = 600;
constexpr qint64 bagsInMemory = 20'000; // when the file cannot be opened
constexpr qint64 maxBagsExported = 200'000;
// The distance from which bags have a gap between them: bags come one by one, other values many times a
// second.
constexpr qint64 gapOfBagsMs = 15'000;
constexpr qint64 gapOfStatusMs = 3000;
constexpr qint64 gapOfResidueMs = 3'600'000; // once in 1000 bags

tl::expected<void, StoreError> keep(store::Database& database, const TrendRecorder::Batch& batch)
{
    if (batch.isEmpty())
        return {};
    return database.transaction([&]() -> tl::expected<void, StoreError> {
        store::BagLog bags(database, database.isInMemory() ? bagsInMemory : store::BagLog::bagsKept);
        if (const auto added = bags.add(batch.bags); !added)
            return added;
        return store::TrendLog(database).add(batch.parts);
    });
}

qint64 gapOf(TrendQuantity quantity)
{
    switch (quantity) {
    case TrendQuantity::BagLength:
    case TrendQuantity::Deviation:
    case TrendQuantity::MarkError:
        return gapOfBagsMs;
    case TrendQuantity::JamResidue:
        return gapOfResidueMs;
    case TrendQuantity::FollowingError:
    case TrendQuantity::Rate:
    case TrendQuantity::Latency:
        break;
    }
    return gapOfStatusMs;
}

// Returns means, lowest and highest values; a point without a value is a gap.
QList<QList<QPointF>> linesOf(const store::TrendCurve& curve, qint64 columnMs)
{
    QList<QList<QPointF>> lines(3);
    const qint64 gap = std::max(gapOf(curve.quantity), columnMs);
    const double half = static_cast<double>(columnMs) / 2;
    qint64 before = 0;
    for (const store::TrendColumn& column : curve.columns) {
        const double middle = static_cast<double>(column.startMs) + half;
        const bool isGap = !lines[0].isEmpty() && column.startMs - before > gap;
        const double values[]{column.bucket.mean(), column.bucket.lowest(), column.bucket.highest()};
        for (qsizetype i = 0; i < lines.size(); ++i) {
            if (isGap)
                lines[i] << QPointF(static_cast<double>(before) + 2 * half, std::nan(""));
            lines[i] << QPointF(middle, values[i]);
        }
        before = column.startMs;
    }
    return lines;
}

QVariantMap mapOf(const store::TrendStatistics& statistics)
{
    return {{QStringLiteral("count"), statistics.count()},
            {QStringLiteral("mean"), statistics.mean()},
            {QStringLiteral("scatter"), statistics.deviation()},
            {QStringLiteral("low"), statistics.lowest()},
            {QStringLiteral("high"), statistics.highest()},
            {QStringLiteral("within"), statistics.shareWithin()}};
}

} // namespace

Trends::Trends(Controller& controller, Settings& settings, DatabaseService& records, const QString& folder,
               QObject* parent)
    : Watched(parent)
    , m_records(records)
    , m_recorder(controller, settings, records)
    , m_clock(&QDateTime::currentMSecsSinceEpoch)
    , m_store(folder, store::trendDatabase())
    , m_csv(
          m_store, [this] { return csvJob(); }, [this](const StoreError& error) { reportError(error); }, this)
    , m_toMs(m_clock())
{
    connect(&m_store, &store::StoreThread::opened, this, &Trends::takeOpening);
    connect(&m_writeTimer, &QTimer::timeout, this, &Trends::write);
    m_writeTimer.start(writePeriodMs);
    connect(&m_followTimer, &QTimer::timeout, this, &Trends::follow);
    connect(this, &Watched::watchedChanged, this, [this] {
        if (!watched())
            return m_followTimer.stop();
        setWindow(m_isLive ? m_clock() : m_toMs, m_spanMs, m_isLive);
        refresh();
    });
}

Trends::~Trends()
{
    m_isWriting = false;
    write(); // the store completes all jobs before its end
}

void Trends::setWallClock(const TrendRecorder::WallClock& clock)
{
    m_clock = clock;
    m_recorder.setWallClock(clock);
    follow();
}

void Trends::toggle(int quantity)
{
    if (quantity < 0 || quantity >= store::trendQuantities || m_chosen == QList<int>{quantity})
        return;
    if (m_chosen.removeAll(quantity) == 0) {
        if (m_chosen.size() == maxChosen)
            m_chosen.removeLast();
        m_chosen << quantity;
        std::ranges::sort(m_chosen);
    }
    m_curves = {};
    m_statistics.clear();
    emit chosenChanged();
    emit shownChanged();
    refresh();
}

void Trends::showSpan(double spanMs)
{
    const qint64 span = std::clamp(std::llround(spanMs), 0LL + shortestSpanMs, 0LL + longestSpanMs);
    if (m_isLive)
        setWindow(m_clock(), span, true);
    else
        showWindow(fromMs() + (this->spanMs() - static_cast<double>(span)) / 2,
                   toMs() - (this->spanMs() - static_cast<double>(span)) / 2);
    refresh();
}

void Trends::showWindow(double fromMs, double toMs)
{
    const qint64 span = std::clamp(std::llround(toMs - fromMs), 0LL + shortestSpanMs, 0LL + longestSpanMs);
    const qint64 middle = std::llround(fromMs + (toMs - fromMs) / 2);
    const qint64 now = m_clock();
    setWindow(std::min(now, middle + span / 2), span, middle + span / 2 >= now);
    refresh();
}

void Trends::showNow()
{
    setWindow(m_clock(), m_spanMs, true);
    refresh();
}

void Trends::setWindow(qint64 toMs, qint64 spanMs, bool isLive)
{
    m_toMs = toMs;
    m_spanMs = spanMs;
    m_isLive = isLive;
    if (watched() && isLive)
        m_followTimer.start(
            static_cast<int>(std::clamp(spanMs / stepsInAWindow, shortestStepMs, longestStepMs)));
    else
        m_followTimer.stop();
    emit windowChanged();
}

void Trends::follow()
{
    if (m_isLive)
        setWindow(m_clock(), m_spanMs, true);
    refresh();
}

store::TrendQuestion Trends::question() const
{
    store::TrendQuestion question{m_toMs - m_spanMs, m_toMs};
    for (const int quantity : m_chosen)
        question.quantities << static_cast<TrendQuantity>(quantity);
    return question;
}

// Writes the collected data first, so that the answer contains it.
void Trends::refresh()
{
    if (!watched())
        return;
    if (m_isAsked) {
        m_isWanted = true;
        return;
    }
    m_isAsked = true;
    m_store.run(
        this,
        [batch = m_recorder.take(), question = question()](store::Database& database) {
            const auto kept = keep(database, batch);
            return Answer{kept, store::readTrends(database, question)};
        },
        [this](const Answer& answer) { takeAnswer(answer); });
}

void Trends::takeAnswer(const Answer& answer)
{
    m_isAsked = false;
    takeKept(answer.kept);
    if (!answer.window)
        reportError(answer.window.error());
    else if (answer.window->curves.size() == m_chosen.size() &&
             std::ranges::equal(answer.window->curves, m_chosen, {}, [](const store::TrendCurve& curve) {
                 return static_cast<int>(curve.quantity);
             }))
        show(*answer.window);
    if (std::exchange(m_isWanted, false))
        refresh();
}

void Trends::show(const store::TrendWindow& window)
{
    auto lines = std::make_shared<QList<QList<QPointF>>>();
    m_statistics.clear();
    bool isEmpty = true;
    for (const store::TrendCurve& curve : window.curves) {
        lines->append(linesOf(curve, window.columnMs));
        m_statistics << mapOf(curve.statistics);
        isEmpty = isEmpty && curve.statistics.count() == 0;
    }
    m_curves = QVariant::fromValue(std::shared_ptr<const QList<QList<QPointF>>>(std::move(lines)));
    m_columnMs = window.columnMs;
    m_isClockDoubtful = window.isClockDoubtful;
    m_content = !window.hasAny ? NothingYet : isEmpty ? NothingHere : Shown;
    emit shownChanged();
}

void Trends::write()
{
    if (!m_isWriting)
        flush();
}

void Trends::flush()
{
    TrendRecorder::Batch batch = m_recorder.take();
    if (batch.isEmpty())
        return;
    m_isWriting = true;
    m_store.run(
        this, [batch = std::move(batch)](store::Database& database) { return keep(database, batch); },
        [this](const tl::expected<void, StoreError>& kept) {
            m_isWriting = false;
            takeKept(kept);
        });
}

void Trends::takeKept(const tl::expected<void, StoreError>& kept)
{
    if (kept)
        m_hasComplained = false;
    else
        reportError(kept.error());
}

// Reports an error once: a full disk fails every five seconds.
void Trends::reportError(const StoreError& error)
{
    if (std::exchange(m_hasComplained, true))
        return;
    if (error.kind == StoreError::Kind::Damaged)
        m_store.beginAnew();
    else
        m_records.reportError(error);
}

void Trends::takeOpening(const store::StoreThread::Report& report)
{
    m_hasComplained = false;
    if (report.error)
        reportError(*report.error);
    else if (!report.opening.damagedKeptAs.isEmpty())
        m_records.reportError({StoreError::Kind::TrendsAnew, {}, report.opening.damagedKeptAs});
    refresh();
}

CsvExport::Job Trends::csvJob()
{
    flush();
    const QString notice =
        tr("Single bags are left out: more than %1. Show a shorter time.").arg(maxBagsExported);
    return [question = question(), bagsName = tr("bags"), trendsName = tr("trends"),
            notice](store::Database& database, const store::CsvDialect& dialect) -> CsvExport::Made {
        const auto bags = store::bagsCsv(database, question.fromMs, question.toMs, maxBagsExported, dialect);
        const auto window = store::readTrends(database, question);
        if (!bags || !window)
            return tl::unexpected(bags ? window.error() : bags.error());
        CsvExport::Files files;
        if (!bags->isEmpty())
            files.files << csvFile(bagsName, *bags);
        else if (store::BagLog(database)
                     .countBetween(question.fromMs, question.toMs, maxBagsExported + 1)
                     .value_or(0) > maxBagsExported)
            files.notice = notice;
        files.files << csvFile(trendsName,
                               store::trendsCsv(*window, question.fromMs, question.toMs, dialect));
        return files;
    };
}

} // namespace campanel::panel
