// SPDX-License-Identifier: Apache-2.0
// Stops on a fake link with fake clocks, on a log in a folder.
#pragma once

#include "app/panel/stops/stops.h"
#include "tests/app/panel/panel_rig.h"

#include <QEventLoop>

#include <memory>

namespace campanel::test {

constexpr qint64 stopStartMs = 1'768'478'400'000; // 2026-01-15 12:00 UTC

struct StopRig {
    PanelRig panel;
    QString folder;
    std::unique_ptr<panel::DatabaseService> records;
    std::unique_ptr<panel::Stops> stops;
    qint64 wallMs = stopStartMs;

    explicit StopRig(const QString& logFolder = {})
        : folder(logFolder.isEmpty() ? panel.folder.filePath(QStringLiteral("log")) : logFolder)
    {
        start();
    }
    void start()
    {
        records = std::make_unique<panel::DatabaseService>(folder, nullptr);
        stops = std::make_unique<panel::Stops>(panel.machine, panel.settings, *records, nullptr);
        stops->setWallClock([this] { return wallMs; });
        records->open();
        settle();
    }
    // Ends the panel in order.
    void end()
    {
        stops.reset();
        records.reset();
    }
    void restart()
    {
        end();
        start();
    }
    // Waits until the log has done what it was asked for.
    void settle() const
    {
        QEventLoop untilDone;
        records->store().run(
            &untilDone, [](store::Database&) { return true; }, [&](bool) { untilDone.quit(); });
        untilDone.exec();
    }
    // Lets time pass with a status every second.
    void pass(int seconds)
    {
        for (int i = 0; i < seconds; ++i) {
            panel.now += std::chrono::seconds(1);
            wallMs += 1000;
            panel.link.sendStatus(panel.now);
            stops->check();
        }
    }
    void setState(modbus::State state)
    {
        panel.link.status.state = state;
        panel.link.sendStatus(panel.now);
    }
    [[nodiscard]] store::StopLog::Span logged() const
    {
        stops->write();
        settle();
        store::StopLog::Span span;
        QEventLoop untilRead;
        records->store().run(
            &untilRead,
            [](store::Database& database) {
                return store::StopLog::between(database, 0, 2 * stopStartMs).value_or(store::StopLog::Span());
            },
            [&](const store::StopLog::Span& read) {
                span = read;
                untilRead.quit();
            });
        untilRead.exec();
        return span;
    }
};

} // namespace campanel::test
