// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/screen_lists.h"

#include <QEventLoop>

namespace campanel::looks {

namespace {

using Situation = DemoLink::Situation;
using store::StateInterval;
using store::StopChanges;
using State = StateInterval::State;
using namespace std::chrono_literals;

// Returns the shift before the present one: a day of stops with and without reasons, always the same. The
// ids lie before those that the panel gives.
StopChanges demoShift()
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
    qint64 at = QDateTime(QDate(2026, 1, 15), QTime(6, 0)).toMSecsSinceEpoch();
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

void openShift(TestWindow& window, const QStringList& names = {})
{
    window.panel().records().store().run(
        nullptr,
        [](store::Database& database) {
            const bool isEmptied = database.execute(QStringLiteral("DELETE FROM state_interval")) &&
                                   database.execute(QStringLiteral("DELETE FROM stop"));
            return isEmptied && store::StopLog::write(database, demoShift());
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
                const modbus::StatusBlock status = *window.panel().machine().status();
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
        asked("run-stop-reasons", {QStringLiteral("reason_material")}),
        ofShift("stops"),
        {QStringLiteral("stops-nothing"),
         [](TestWindow& window) { openShift(window, {QStringLiteral("shiftPrevious")}); }},
        explained("stops-oee-explained", "figureOee"),
        explained("stops-performance-explained", "figurePerformance"),
        ofShift("stops-list", {QStringLiteral("shiftStops")}),
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
