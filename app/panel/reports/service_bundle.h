// SPDX-License-Identifier: Apache-2.0
// `ServiceBundle` in QML: one archive for the manufacturer's support. It contains the open recipe with its
// table, the controller's program, alarms and changes of the last week, and the figures of the line. It also
// contains the last ten seconds of the machine, those before its last fault with the frames of the line, and
// the screen at that fault. No PIN and no hash of one is
// in it.
#pragma once

#include "app/panel/kit/report_files.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/reports/status_trace.h"
#include "app/store/backup/archive.h"
#include "app/store/files/csv.h"

#include <QDateTime>
#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <optional>
#include <utility>

namespace campanel::panel {

class Editor;
class FrameList;
class LineFigures;
class Controller;
class DatabaseService;

class ServiceBundle : public QObject, public Singleton<ServiceBundle> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // True while the contents are collected.
    Q_PROPERTY(bool busy READ busy NOTIFY busyChanged FINAL)

public:
    using WallClock = std::function<QDateTime()>;
    using Screen = std::function<QByteArray()>;

    struct Parts {
        Controller& controller;
        Editor& editor;
        DatabaseService& records;
        LineFigures& figures;
        ReportFiles& files;
        FrameList& frames;
    };

    // All arguments must outlive the object.
    ServiceBundle(const Parts& parts, QObject* parent);

    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }

    // Sets the function that returns the present screen as PNG. It is called at each fault.
    void setScreen(Screen screen) { m_screen = std::move(screen); }

    // Collects the present data and offers it to the files, then emits offered().
    Q_INVOKABLE void make();

    [[nodiscard]] bool busy() const { return m_isBusy; }
    [[nodiscard]] const StatusTrace& trace() const { return m_trace; }

signals:
    void busyChanged();
    void offered();

private:
    using Entries = QList<store::ArchiveEntry>;

    [[nodiscard]] QByteArray about() const;
    [[nodiscard]] QByteArray controller() const;
    void recordFault();
    // Reads all parameters, then gathers.
    void readParameters(const link::FiguresReport& figures);
    void gather(const link::FiguresReport& figures);
    void offer(Entries entries);
    void setBusy(bool isBusy);

    Parts m_parts;
    WallClock m_wallClock;
    Screen m_screen;
    StatusTrace m_trace;
    QList<modbus::FrameRecord> m_frames;
    QList<modbus::FrameRecord> m_faultFrames;
    QByteArray m_faultScreen;
    std::optional<store::CsvWriter> m_parameters;
    int m_pendingReads = 0;
    bool m_isBusy = false;
};

} // namespace campanel::panel
