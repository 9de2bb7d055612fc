// SPDX-License-Identifier: Apache-2.0
// `Versions` in QML: which software and which program run here, and how long the disk lasts. A version that
// ran for the first time becomes a row of the audit trail.
#pragma once

#include "app/panel/kit/figure_model.h"
#include "app/panel/kit/singleton.h"
#include "app/store/files/system_record.h"
#include "app/store/logs/audit_log.h"

#include <QDateTime>
#include <QObject>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <functional>

namespace campanel::panel {

class Controller;
class DatabaseService;
class Editor;

class Versions : public QObject, public Singleton<Versions> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    // A sentence while the disk lasts for less than the five years of the audit trail; empty otherwise.
    Q_PROPERTY(QString warning READ warning NOTIFY changed FINAL)

public:
    // Returns the free bytes of a folder's disk; called in another thread.
    using FreeBytes = std::function<qint64(const QString& folder)>;
    using WallClock = std::function<QDateTime()>;

    // All arguments must outlive the object. `folder` has the panel's data.
    Versions(Controller& controller, Editor& editor, DatabaseService& records, const QString& folder,
             QObject* parent);

    // Replace the disk and the clock, for tests and captures.
    void setFreeBytes(FreeBytes freeBytes) { m_freeBytes = std::move(freeBytes); }
    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }

    // Reads the record, and measures the disk at once and every six hours.
    void open();
    // Sets the version of the image that the whole system is of; empty: the system is another one.
    void setSystem(const QString& version);
    // Sets the version of the gateway that has connected; empty: none is connected.
    void setGateway(const QString& version);

    [[nodiscard]] FigureModel* rows() { return &m_rows; }
    [[nodiscard]] QString warning() const;
    [[nodiscard]] const store::DiskForecast& forecast() const { return m_forecast; }

signals:
    void changed();
    // Emitted for the audit trail.
    void noted(const campanel::store::AuditEntry& entry);

private:
    void measure();
    void update();
    // Remembers that this version runs; another one before it is noted.
    void noteSoftware(const QString& part, const QString& version);
    [[nodiscard]] QString controllerText() const;
    [[nodiscard]] QString growthText() const;

    Controller& m_controller;
    Editor& m_editor;
    DatabaseService& m_records;
    QString m_folder;
    FreeBytes m_freeBytes;
    WallClock m_wallClock = &QDateTime::currentDateTime;
    QTimer m_timer;
    std::optional<store::SystemRecord> m_record; // once it is read
    store::DiskForecast m_forecast;
    QString m_gateway;
    QString m_system;
    FigureModel m_rows{this};
};

} // namespace campanel::panel
