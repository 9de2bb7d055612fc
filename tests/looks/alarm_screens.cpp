// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/screen_lists.h"

#include <QEventLoop>

namespace campanel::looks {

namespace {

using Situation = DemoLink::Situation;
using store::AlarmRow;

const QString alarmsPage = QStringLiteral("nav_alarms");

// Returns a demonstration log of many shifts, always the same.
QList<AlarmRow> demoLog()
{
    const QStringList codes{QStringLiteral("W-02"), QStringLiteral("M-01"), QStringLiteral("L-03"),
                            QStringLiteral("C-01"), QStringLiteral("M-05"), QStringLiteral("W-03"),
                            QStringLiteral("C-04"), QStringLiteral("P-07"), QStringLiteral("M-04")};
    const qint64 beginMs = QDateTime(QDate(2026, 1, 13), QTime(6, 2)).toMSecsSinceEpoch();
    constexpr qint64 apartMs = 41 * 60 * 1000;
    QList<AlarmRow> rows;
    for (int i = 0; i < 60; ++i) {
        AlarmRow row;
        row.id = i + 1;
        row.code = codes[i % codes.size()];
        row.raisedMs = beginMs + i * apartMs;
        row.end = i % 14 == 13 ? AlarmRow::End::Unknown : AlarmRow::End::Returned;
        row.returnedMs = row.end == AlarmRow::End::Returned ? row.raisedMs + (i % 7 + 1) * 9000 : 0;
        row.wantsAcknowledgement = i % 9 != 0;
        row.acknowledgedMs = row.wantsAcknowledgement && i % 11 != 4 ? row.raisedMs + 61'000 : 0;
        row.count = i % 5 == 4 ? i : 1;
        row.isClockDoubtful = i == 57;
        rows.append(row);
    }
    return rows;
}

// Waits for the first page.
void waitForHistory(TestWindow& window)
{
    panel::AlarmHistory& history = *window.panel().alarms().history();
    QEventLoop untilRead;
    QObject::connect(&history, &panel::AlarmHistory::changed, &untilRead, [&] {
        if (!history.loading())
            untilRead.quit();
    });
    if (history.loading())
        untilRead.exec();
    window.settle();
}

void openHistory(TestWindow& window, const QList<AlarmRow>& rows)
{
    window.panel().alarms().history()->filter()->clear();
    store::AlarmChanges changes;
    changes.rows = rows;
    window.panel().records().open();
    window.panel().records().store().run(
        nullptr,
        [changes](store::Database& database) {
            const auto emptied = database.execute(QStringLiteral("DELETE FROM alarm"));
            return emptied ? store::AlarmLog::write(database, changes)
                           : tl::expected<void, store::StoreError>(tl::unexpected(emptied.error()));
        },
        [](const tl::expected<void, store::StoreError>&) {});
    window.tap(alarmsPage);
    window.tap(QStringLiteral("alarmsLive")); // read when it becomes visible
    window.tap(QStringLiteral("alarmsHistory"));
    waitForHistory(window);
}

// Filters the log to 14 January and one alarm.
void openFilter(TestWindow& window)
{
    openHistory(window, demoLog());
    window.tap(QStringLiteral("alarmsFilter"));
    window.tap(QStringLiteral("filterEarlierDay"));
    window.tap(QStringLiteral("filterDay"));
    window.panel().alarms().history()->filter()->setId(QStringLiteral("M-01"));
    waitForHistory(window);
}

// Shows a fault, and an earlier lost connection: acknowledged, returned, not acknowledged.
void showTrouble(TestWindow& window)
{
    window.link().show(Situation::MarksLost);
    window.settle();
    window.panel().alarms().acknowledgeAll();
    window.link().show(Situation::Lost);
    window.settle();
    window.link().show(Situation::Fault);
    window.checkClock();
    window.settle();
    window.tap(alarmsPage);
    window.tap(QStringLiteral("alarmsLive"));
}

Screen trouble(const char* name, const QStringList& names)
{
    return {QString::fromLatin1(name), [names](TestWindow& window) {
                showTrouble(window);
                for (const QString& tapped : names)
                    window.tap(tapped);
            }};
}

// Shows a lost connection, which may be shelved.
Screen lost(const char* name, const QStringList& names)
{
    return {QString::fromLatin1(name), [names](TestWindow& window) {
                window.link().show(Situation::Lost);
                window.checkClock();
                window.settle();
                for (const QString& tapped : names)
                    window.tap(tapped);
            }};
}

} // namespace

QList<Screen> alarmScreens()
{
    const QString first = QStringLiteral("liveAlarm0");
    const QString live = QStringLiteral("alarmsLive");
    const QString shelved = QStringLiteral("alarmsShelved");
    return {{QStringLiteral("alarms-none"),
             [=](TestWindow& window) {
                 window.tap(alarmsPage);
                 window.tap(live);
             }},
            trouble("alarms", {}),
            trouble("alarms-fault", {first}),
            lost("alarms-lost", {alarmsPage, live, first}),
            {QStringLiteral("alarms-history"), [](TestWindow& window) { openHistory(window, demoLog()); }},
            {QStringLiteral("alarms-history-one"),
             [](TestWindow& window) {
                 openHistory(window, demoLog());
                 window.tap(QStringLiteral("pastAlarm3"));
             }},
            {QStringLiteral("alarms-history-filtered"),
             [](TestWindow& window) {
                 openFilter(window);
                 window.tap(QStringLiteral("filterShow"));
                 waitForHistory(window);
             }},
            {QStringLiteral("alarms-filter"), [](TestWindow& window) { openFilter(window); }},
            {QStringLiteral("alarms-filter-word"),
             [](TestWindow& window) {
                 openFilter(window);
                 window.tap(QStringLiteral("filterWord"));
             }},
            {QStringLiteral("alarms-history-empty"), [](TestWindow& window) { openHistory(window, {}); }},
            {QStringLiteral("alarms-shelved-none"),
             [=](TestWindow& window) {
                 window.tap(alarmsPage);
                 window.tap(shelved);
             }},
            lost("alarms-shelved", {alarmsPage, live, first, QStringLiteral("alarmShelve8"), shelved}),
            lost("alarms-shelved-one", {alarmsPage, live, first, QStringLiteral("alarmShelve8"), first})};
}

} // namespace campanel::looks
