// SPDX-License-Identifier: Apache-2.0
// The pages Trends and Stops; the second one is opened from the first.
#include "tests/looks/screen_lists.h"

#include "app/store/logs/bag_log.h"
#include "tests/looks/test_window.h"

#include <QEventLoop>

#include <algorithm>
#include <cmath>
#include <random>

namespace campanel::looks {

namespace {

using store::TrendPart;
using store::TrendQuantity;

constexpr unsigned trendSeed = 11;
constexpr qint64 msPerSecond = 1000;
constexpr qint64 secondsOfNow = 600;
constexpr qint64 secondsOfPause = 70; // of endOfPause
constexpr qint64 endOfPause = 150;    // before now
constexpr qint64 tenMinutes = 600;
constexpr qint64 tenMinutesOfAWeek = 7 * 24 * 6;

qint64 nowMs()
{
    return QDateTime(QDate(2026, 1, 15), QTime(14, 7)).toMSecsSinceEpoch();
}

// Adds the values of one bag, with variations that depend on `second`.
void addSecond(QList<TrendPart>& parts, qint64 second, std::mt19937& random)
{
    std::normal_distribution<double> scatter(0, 0.06);
    const double drift = 0.09 * std::sin(static_cast<double>(second) / 170.0);
    const double deviation = drift + scatter(random);
    const bool isWithin = std::abs(deviation) <= 0.5;
    const auto add = [&](TrendQuantity quantity, std::initializer_list<double> values) {
        TrendPart part{second, quantity, {}};
        for (const double value : values)
            part.bucket.add(value, isWithin);
        parts << part;
    };
    add(TrendQuantity::BagLength, {250 + deviation});
    add(TrendQuantity::Deviation, {deviation});
    add(TrendQuantity::MarkError, {0.4 * deviation + scatter(random)});
    const double lag = 0.4 + scatter(random);
    add(TrendQuantity::FollowingError, {lag, -lag / 3, lag / 2});
    add(TrendQuantity::Rate, {60});
    add(TrendQuantity::Latency, {8.1 + scatter(random), 8.4, 9.9 + std::abs(20 * scatter(random))});
}

// Returns the last ten minutes second by second with a pause, and one second in ten minutes for the shifts of
// the last week.
QList<TrendPart> demoTrends()
{
    std::mt19937 random(trendSeed);
    QList<TrendPart> parts;
    const qint64 now = nowMs() / msPerSecond;
    for (qint64 back = tenMinutesOfAWeek; back > 0; --back) {
        const qint64 second = now - back * tenMinutes;
        const int hour = QDateTime::fromSecsSinceEpoch(second).time().hour();
        if (hour >= 6 && hour < 22)
            addSecond(parts, second, random);
    }
    for (qint64 back = secondsOfNow; back > 0; --back) {
        if (back < endOfPause || back >= endOfPause + secondsOfPause)
            addSecond(parts, now - back, random);
    }
    return parts;
}

QList<store::Bag> demoBags()
{
    QList<store::Bag> bags;
    for (int i = 60; i > 0; --i) {
        store::Bag bag;
        bag.timeMs = nowMs() - i * msPerSecond;
        bag.programName = QStringLiteral("Biscuit 250");
        bag.programVersion = 3;
        bag.setLengthMm = 250;
        bag.deviationMm = 0.01 * (i % 7);
        bags << bag;
    }
    return bags;
}

// Deletes the recorded trends, which depend on earlier screens.
tl::expected<void, store::StoreError> deleteTrends(store::Database& database)
{
    for (const char* table :
         {"bag", "program", "trend_second", "trend_minute", "trend_hour", "clock_unset"}) {
        if (const auto done = database.execute(QStringLiteral("DELETE FROM %1").arg(QLatin1String(table)));
            !done)
            return tl::unexpected(done.error());
    }
    const auto done = database.execute(QStringLiteral("UPDATE ring SET held = 0"));
    return done ? tl::expected<void, store::StoreError>() : tl::unexpected(done.error());
}

tl::expected<void, store::StoreError> fill(store::Database& database)
{
    store::BagLog bags(database);
    const QList<store::Bag> wanted = demoBags();
    const auto found = bags.countBetween(wanted.first().timeMs, nowMs(), wanted.size());
    if (found == wanted.size()) // by an earlier screen
        return {};
    if (const auto cleared = deleteTrends(database); !cleared)
        return cleared;
    if (const auto added = bags.add(wanted); !added)
        return added;
    return store::TrendLog(database).add(demoTrends());
}

using Change = tl::expected<void, store::StoreError> (*)(store::Database&);

void change(TestWindow& window, Change change)
{
    panel::Trends& trends = window.panel().trends();
    bool isDone = false;
    trends.store().run(
        &trends,
        [change](store::Database& database) {
            return database.transaction([&] { return change(database); }).has_value();
        },
        [&](bool done) { isDone = done; });
    trends.refresh();
    window.waitForTrends();
    if (!isDone)
        qWarning("the demonstration's trends cannot be written");
}

// Opens the page with these quantities over the last ten minutes.
void openPage(TestWindow& window,
              const QList<int>& quantities = {panel::Trends::Deviation, panel::Trends::MarkError})
{
    panel::Trends& trends = window.panel().trends();
    window.tap(QStringLiteral("nav_run"));
    trends.open();
    for (const int quantity : quantities) {
        if (!trends.chosen().contains(quantity))
            trends.toggle(quantity);
        for (const int other : trends.chosen()) {
            if (!quantities.contains(other))
                trends.toggle(other);
        }
    }
    trends.showSpan(600'000);
    trends.showNow();
    window.tap(QStringLiteral("nav_trends"));
    if (QQuickItem* card = window.find(QStringLiteral("trendCard")))
        card->setProperty("cursor", std::nan(""));
    window.waitForTrends();
}

void openFilled(TestWindow& window,
                const QList<int>& quantities = {panel::Trends::Deviation, panel::Trends::MarkError})
{
    openPage(window, quantities);
    change(window, fill);
}

void tapAll(TestWindow& window, std::initializer_list<const char*> names)
{
    for (const char* name : names) {
        window.tap(QString::fromLatin1(name));
        window.waitForTrends();
    }
}

} // namespace

QList<Screen> trendScreens()
{
    return {{QStringLiteral("trends-empty"),
             [](TestWindow& window) {
                 openPage(window);
                 change(window, deleteTrends);
             }},
            {QStringLiteral("trends"), [](TestWindow& window) { openFilled(window); }},
            {QStringLiteral("trends-explained"),
             [](TestWindow& window) {
                 openFilled(window);
                 window.hold(QStringLiteral("trendFigures0"));
             }},
            {QStringLiteral("trends-cursor-explained"),
             [](TestWindow& window) {
                 openFilled(window);
                 tapAll(window, {"trendPlot"});
                 window.hold(QStringLiteral("trendFigures0"));
             }},
            {QStringLiteral("trends-three"),
             [](TestWindow& window) {
                 openFilled(window, {panel::Trends::BagLength, panel::Trends::FollowingError,
                                     panel::Trends::Latency});
             }},
            {QStringLiteral("trends-cursor"),
             [](TestWindow& window) {
                 openFilled(window);
                 tapAll(window, {"trendPlot"});
             }},
            {QStringLiteral("trends-week"),
             [](TestWindow& window) {
                 openFilled(window, {panel::Trends::Deviation});
                 tapAll(window, {"span7d"});
             }},
            {QStringLiteral("trends-clock-unset"),
             [](TestWindow& window) {
                 openFilled(window);
                 change(window, [](store::Database& database) {
                     store::Bag bag = demoBags().first();
                     bag.flags = store::Bag::ClockNotSet;
                     return store::BagLog(database).add({bag});
                 });
             }},
            {QStringLiteral("trends-nothing-here"),
             [](TestWindow& window) {
                 openFilled(window);
                 const double now = window.panel().trends().toMs();
                 window.panel().trends().showWindow(now - 40 * 86400e3, now - 39 * 86400e3);
                 window.waitForTrends();
             }},
            {QStringLiteral("trends-curves"),
             [](TestWindow& window) {
                 openFilled(window);
                 tapAll(window, {"trendCurves"});
             }},
            {QStringLiteral("trends-export"), [](TestWindow& window) {
                 panel::ReportFiles& files = *window.panel().maintenance().files();
                 files.setScanner([](const QString&) {
                     return QList<store::Place>{
                         {QStringLiteral("/media/panel/KINGSTON"), QStringLiteral("KINGSTON"), false}};
                 });
                 openFilled(window);
                 tapAll(window, {"trendExport"});
                 window.waitFor(files);
             }}};
}

namespace {

using Situation = DemoLink::Situation;
using store::StateInterval;
using store::StopChanges;
using State = StateInterval::State;
using namespace std::chrono_literals;

// Returns the shift before the present one: a day of stops with and without reasons, always the same. The
// ids lie before those that the panel gives.
StopChanges demoShift(bool isClockUnset)
{
    struct Part {
        State state;
        int minutes;
        const char* reason; // of a stop; empty: none
        bool isPlanned;
    };
    const Part parts[]{
        {State::Ready, 12, "cleaning", false}, {State::Running, 63, "", false},
        {State::Fault, 9, "C-01", false},      {State::Jogging, 3, nullptr, false}, // the same stop
        {State::Running, 84, "", false},       {State::Ready, 30, "break", true},
        {State::Running, 41, "", false},       {State::Suspended, 7, "waiting", false},
        {State::Running, 66, "", false},       {State::Ready, 17, "material/film_change", false},
        {State::Running, 38, "", false},       {State::Ready, 6, "", false},
        {State::Running, 47, "", false},       {State::Ready, 11, "", false},
        {State::Running, 46, "", false}};
    constexpr qint64 minuteMs = 60'000;
    StopChanges changes;
    const qint64 shiftBegin = QDateTime(QDate(2026, 1, 15), QTime(6, 0)).toMSecsSinceEpoch();
    qint64 at = shiftBegin;
    qint64 id = -1000;
    qint64 stop = 0;
    for (const Part& part : parts) {
        const qint64 endMs = at + part.minutes * minuteMs;
        if (store::produces(part.state))
            stop = 0;
        else if (part.reason)
            stop = id;
        if (stop == id && part.reason && *part.reason)
            changes.stops << store::StopRow{
                stop, QString::fromLatin1(part.reason), part.isPlanned,
                part.isPlanned || part.state == State::Ready ? QStringLiteral("Ann") : QString(), at};
        while (at < endMs) {
            StateInterval each;
            each.id = id++;
            each.stop = stop;
            each.state = part.state;
            each.beginMs = at;
            each.durationMs =
                std::min(endMs, at - at % panel::StateBook::quarterMs + panel::StateBook::quarterMs) - at;
            each.program = QStringLiteral("Biscuit 250");
            each.version = 3;
            each.idealPerMin = 70;
            each.isClockDoubtful = isClockUnset && at == shiftBegin;
            if (store::produces(part.state)) {
                each.pieces = each.durationMs / 1000;
                each.outOfTolerance = each.pieces / 150;
                each.startUpScrap = changes.intervals.isEmpty() ? 0 : 2;
                each.skipped = each.pieces / 300;
            }
            at += each.durationMs;
            changes.intervals << each;
        }
    }
    return changes;
}

// Waits for what the page has asked for.
void waitForStops(TestWindow& window)
{
    for (int round = 0; round < 2; ++round) {
        QEventLoop untilAnswered;
        window.panel().records().store().run(
            &untilAnswered, [](store::Database&) { return true; }, [&](bool) { untilAnswered.quit(); });
        untilAnswered.exec();
    }
    window.settle();
}

void openShift(TestWindow& window, const QStringList& names = {}, bool isClockUnset = false)
{
    window.panel().records().store().run(
        nullptr,
        [isClockUnset](store::Database& database) {
            const bool isEmptied = database.execute(QStringLiteral("DELETE FROM state_interval")) &&
                                   database.execute(QStringLiteral("DELETE FROM stop"));
            return isEmptied && store::StopLog::write(database, demoShift(isClockUnset));
        },
        [](bool isDone) {
            if (!isDone)
                qWarning("the demonstration's shift cannot be written");
        });
    window.tap(QStringLiteral("nav_trends"));
    window.tap(QStringLiteral("trendStops"));
    window.panel().stops().shift()->showPresent();
    waitForStops(window);
    window.tap(QStringLiteral("shiftPrevious"));
    waitForStops(window);
    for (const QString& name : names) {
        window.tap(name);
        waitForStops(window);
    }
}

Screen ofShift(const char* name, const QStringList& names = {})
{
    return {QString::fromLatin1(name), [names](TestWindow& window) { openShift(window, names); }};
}

Screen explained(const char* name, const char* figure)
{
    return {QString::fromLatin1(name), [figure](TestWindow& window) {
                openShift(window);
                window.hold(QString::fromLatin1(figure));
            }};
}

// Shows a place for files.
void setStick(TestWindow& window)
{
    window.panel().maintenance().files()->setScanner([](const QString&) {
        return QList<store::Place>{
            {QStringLiteral("/media/panel/KINGSTON"), QStringLiteral("KINGSTON"), false}};
    });
}

Screen ofFiles(const char* name, const char* key)
{
    return {QString::fromLatin1(name), [key](TestWindow& window) {
                setStick(window);
                openShift(window, {QString::fromLatin1(key)});
                window.waitFor(*window.panel().maintenance().files());
            }};
}

// Opens Run with a machine that has stood for two seconds, and is asked about after one.
Screen asked(const char* name, const QStringList& names = {})
{
    return {QString::fromLatin1(name), [names](TestWindow& window) {
                waitForStops(window); // the log is open
                window.link().show(Situation::Stopped);
                window.checkClock();
                window.panel().settings().overrideValue("stops.ask_after_seconds", QStringLiteral("1"));
                window.tap(QStringLiteral("nav_run"));
                const modbus::StatusBlock status = *window.panel().controller().status();
                for (int i = 0; i < 2; ++i) {
                    window.link().advance(1s);
                    emit window.link().statusReceived({{{window.link().now(), status}}, 0});
                }
                window.settle();
                for (const QString& tapped : names)
                    window.tap(tapped);
            }};
}

Screen ofSettings(const char* name, const QStringList& names = {})
{
    return {QString::fromLatin1(name), [names](TestWindow& window) {
                for (const char* tapped : {"nav_settings", "section2", "openStops"})
                    window.tap(QString::fromLatin1(tapped));
                for (const QString& tapped : names)
                    window.tap(tapped);
            }};
}

} // namespace

QList<Screen> stopScreens()
{
    return {
        asked("run-stop-question"),
        asked("run-stop-answered", {QStringLiteral("reason_cleaning")}),
        asked("run-stop-reasons", {QStringLiteral("reason_material")}),
        ofShift("stops"),
        {QStringLiteral("stops-nothing"),
         [](TestWindow& window) { openShift(window, {QStringLiteral("shiftPrevious")}); }},
        explained("stops-oee-explained", "figureOee"),
        explained("stops-performance-explained", "figurePerformance"),
        ofShift("stops-list", {QStringLiteral("shiftStops")}),
        {QStringLiteral("stops-list-clock-unset"),
         [](TestWindow& window) {
             openShift(window, {QStringLiteral("shiftStops")}, true);
             QMetaObject::invokeMethod(window.find(QStringLiteral("stopList")), "positionViewAtEnd");
             window.settle();
         }},
        ofShift("stops-answer", {QStringLiteral("shiftStops"), QStringLiteral("stop0")}),
        ofFiles("stops-csv", "shiftCsv"),
        ofFiles("stops-pdf", "shiftPdf"),
        ofSettings("settings-stops"),
        ofSettings("settings-stops-ideal", {QStringLiteral("stopsIdealRate")}),
        ofSettings("settings-stops-shifts", {QStringLiteral("stopsShifts")}),
        ofSettings("settings-stops-reasons", {QStringLiteral("stopsReasons")}),
        ofSettings("settings-stops-group", {QStringLiteral("stopsReasons"), QStringLiteral("reasonOpen")}),
        ofSettings("settings-stops-name", {QStringLiteral("stopsReasons"), QStringLiteral("reasonRename")})};
}

} // namespace campanel::looks
