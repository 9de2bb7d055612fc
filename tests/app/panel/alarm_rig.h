// SPDX-License-Identifier: Apache-2.0
// Alarms on a fake link with a log that can be closed and opened again, like a restarted panel.
#pragma once

#include "panel_rig.h"

#include <QEventLoop>
#include <QTest>

#include <algorithm>
#include <memory>

namespace campanel::test {

struct AlarmRig {
    PanelRig panel;
    QTemporaryDir folder;
    std::unique_ptr<panel::DatabaseService> records;
    std::unique_ptr<panel::Alarms> alarms;
    QDateTime day{QDate(2026, 1, 15), QTime(14, 0)}; // time of day of panel.now = 1 h

    AlarmRig() { start(); }

    void start()
    {
        records = std::make_unique<panel::DatabaseService>(folder.path(), nullptr);
        alarms =
            std::make_unique<panel::Alarms>(panel.machine, panel.editor, *records, panel.settings, nullptr);
        alarms->setWallClock([this] { return wall(); });
        alarms->setPaceMs(0);
        alarms->watch().setPatienceMs(3'600'000); // a test without a connection must not get the link alarm
    }
    void end()
    {
        alarms.reset();
        records.reset();
    }
    void open() { records->open(); }

    [[nodiscard]] QDateTime wall() const
    {
        const auto since = panel.now.time_since_epoch() - std::chrono::hours(1);
        return day.addMSecs(std::chrono::duration_cast<std::chrono::milliseconds>(since).count());
    }
    void pass(std::chrono::milliseconds time) { panel.now += time; }

    void setFaults(unsigned bits)
    {
        panel.link.status.faultBits = static_cast<std::uint16_t>(bits);
        panel.link.sendStatus(panel.now);
    }
    void setWarnings(unsigned bits)
    {
        panel.link.status.warningBits = static_cast<std::uint16_t>(bits);
        panel.link.sendStatus(panel.now);
    }

    // Puts the alarm on the shelf of the log, for a day.
    void shelve(const QString& code)
    {
        records->store().run(
            alarms.get(),
            [code, nowMs = wall().toMSecsSinceEpoch()](store::Database& database) {
                store::AlarmChanges changes;
                changes.shelves = QList<store::AlarmShelf>{{code, nowMs, nowMs + 86'400'000, {}}};
                return store::AlarmLog::write(database, changes);
            },
            [](const auto&) {});
    }

    // Returns the rows on the disk, newest first.
    [[nodiscard]] QList<store::AlarmRow> logged() const
    {
        QList<store::AlarmRow> rows;
        QEventLoop untilRead;
        records->store().run(
            &untilRead,
            [](store::Database& database) {
                return store::alarmTable().page(database, 0).value_or(QList<store::AlarmRow>());
            },
            [&](const QList<store::AlarmRow>& read) {
                rows = read;
                untilRead.quit();
            });
        untilRead.exec();
        return rows;
    }
    // Returns "C-01 active", ... of the list, after the publication of changes.
    [[nodiscard]] QStringList live() const
    {
        QCoreApplication::processEvents();
        QStringList lines;
        const auto isShelved = [this](const panel::AlarmListRow& row) {
            return std::ranges::count(alarms->shelved()->rows(), row.code(), &panel::ShelfRow::code) > 0;
        };
        for (const panel::AlarmListRow& row : alarms->live()->rows())
            lines << row.code() + (row.live() ? QStringLiteral(" active") : QStringLiteral(" gone")) +
                         (isShelved(row) ? QStringLiteral(" shelved")
                          : row.calls()  ? QStringLiteral(" calls")
                                         : QString());
        return lines;
    }
};

} // namespace campanel::test
