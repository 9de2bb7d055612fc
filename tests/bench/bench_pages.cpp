// SPDX-License-Identifier: Apache-2.0
// The time from the touch of a page's key to the painted page with its data, at 1024x600 on the software
// renderer, with the maximum of data on the disk.
#include "bench_pages.h"

#include "app/store/database/database.h"
#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"
#include "tests/looks/demo_link.h"
#include "tests/looks/touch_driver.h"
#include "tests/support/alarm_fill.h"

#include <QElapsedTimer>
#include <QEventLoop>

#include <functional>
#include <stdexcept>

namespace campanel::bench {
namespace {

using namespace Qt::StringLiterals;

constexpr int openings = 20;

void fillAlarms(const QString& folder)
{
    const auto database = store::Database::open(folder);
    if (!database || !test::fillAlarmLog(**database, store::AlarmLog::capacity))
        throw std::runtime_error("the log of alarms cannot be filled");
}

// Adds rows of the audit trail, one a minute.
void fillAudit(const QString& folder)
{
    const auto database = store::Database::open(folder);
    const bool isFilled =
        database &&
        (*database)->execute(u"WITH RECURSIVE n (i) AS (VALUES (1) UNION ALL SELECT i + 1 FROM n WHERE i < "
                             "100000) INSERT INTO audit (sequence, time_ms, who, level, what, object, "
                             "before, after, read_back, outcome, previous, hash) SELECT i, 1700000000000 + "
                             "60000 * i, 'Anna', 2, 'parameter.write', 'parameter.mark_window', i, i + 1, "
                             "i + 1, 'done', zeroblob(32), zeroblob(32) FROM n"_s);
    if (!isFilled)
        throw std::runtime_error("the audit trail cannot be filled");
}

// Filters that find nothing or a single row have to look at every row.
std::vector<double> filterMs(const QString& folder)
{
    const auto database = store::Database::open(folder);
    std::vector<double> times;
    const auto timed = [&times](const auto& read) {
        QElapsedTimer timer;
        timer.start();
        if (!read())
            throw std::runtime_error("a log cannot be read");
        times.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    };
    store::LogFilter word;
    word.word = u"not in any text"_s;
    store::LogFilter id;
    id.id = u"X-77"_s;
    store::LogFilter hour;
    hour.fromMs = 1'700'000'000'000 + 500'000'000;
    hour.toMs = hour.fromMs + 3'600'000;
    for (const store::LogFilter& filter : {word, id, hour}) {
        timed([&] { return store::alarmTable().page(**database, 0, store::logPageRows, filter); });
        timed([&] { return store::auditTable().page(**database, 0, 100, filter); });
    }
    return times;
}

class Pages {
public:
    explicit Pages(const QString& folder)
        : m_panel(m_link, {folder + u"/pages.ini"_s, folder})
    {
        if (!m_panel.load(QSize(1024, 600)))
            throw std::runtime_error("the panel's window cannot be loaded");
        m_panel.window().show();
        m_panel.open();
        m_touch.settle();
    }

    // Opens Run first.
    double openTrendsMs()
    {
        leave();
        bool isShown = false;
        const auto connection =
            QObject::connect(&m_panel.trends(), &panel::Trends::shownChanged, [&] { isShown = true; });
        const double ms = timedMs([&] {
            m_touch.tap(u"nav_trends"_s);
            awaitData([&] { return isShown; });
        });
        QObject::disconnect(connection);
        return ms;
    }

    // The history is on the page's second sheet, which is displayed again when the page is opened again.
    double openAlarmsMs()
    {
        leave();
        return timedMs([&] {
            m_touch.tap(u"nav_alarms"_s);
            if (!m_panel.alarms().history()->watched())
                m_touch.tap(u"alarmsHistory"_s);
            awaitData([this] { return m_panel.alarms().history()->rows()->count() > 0; });
        });
    }

private:
    void leave()
    {
        m_touch.tap(u"nav_run"_s);
        m_touch.settle();
    }

    double timedMs(const std::function<void()>& open)
    {
        QElapsedTimer timer;
        timer.start();
        open();
        (void)m_touch.grab();
        if (!m_touch.complaints().isEmpty())
            throw std::runtime_error(m_touch.complaints().constFirst().toStdString());
        return static_cast<double>(timer.nsecsElapsed()) / 1e6;
    }

    static void awaitData(const std::function<bool()>& isThere)
    {
        constexpr qint64 patienceMs = 10000;
        QElapsedTimer timer;
        timer.start();
        QEventLoop loop;
        while (!isThere()) {
            if (timer.elapsed() > patienceMs)
                throw std::runtime_error("a page got no data");
            loop.processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
        }
    }

    looks::DemoLink m_link{nullptr};
    shell::Panel m_panel;
    looks::TouchDriver m_touch{m_panel};
};

Figures figuresOf(const std::string& page, double firstMs, const std::vector<double>& againMs)
{
    return {{page + ", opened for the first time", firstMs, pageLimitMs, "ms", "a page", true},
            {page + ", opened again (slowest of " + std::to_string(openings) + ")", quantile(againMs, 1.0),
             pageLimitMs, "ms", "a page", true}};
}

} // namespace

Figures measurePages(const QString& folder)
{
    fillAlarms(folder);
    fillAudit(folder);
    Pages pages(folder);
    const double firstTrendsMs = pages.openTrendsMs();
    const double firstAlarmsMs = pages.openAlarmsMs();
    std::vector<double> trendsMs;
    std::vector<double> alarmsMs;
    for (int opening = 0; opening < openings; ++opening) {
        trendsMs.push_back(pages.openTrendsMs());
        alarmsMs.push_back(pages.openAlarmsMs());
    }
    Figures figures = figuresOf("Trends with 10 million bags", firstTrendsMs, trendsMs);
    for (const Figure& figure : figuresOf("Alarms with 100 000 in the history", firstAlarmsMs, alarmsMs))
        figures.push_back(figure);
    figures.push_back({"alarms and audit of 100 000 rows filtered (slowest of 6)",
                       quantile(filterMs(folder), 1.0), pageLimitMs, "ms", "a page", true});
    return figures;
}

} // namespace campanel::bench
