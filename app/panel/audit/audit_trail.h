// SPDX-License-Identifier: Apache-2.0
// Watches the actions at the panel and writes them into the audit trail: commands, parameters, downloads,
// settings, users. Each entry has the old value, the requested one and the value that the controller held
// afterwards.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/access/access.h"
#include "app/panel/recipe/controller_program.h"
#include "app/store/database/clock_mark.h"
#include "app/store/logs/audit_log.h"

#include <QHash>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace campanel::program {
struct ProgramImage;
}

namespace campanel::panel {

class Editor;
class Controller;
class MarkWizard;
class DatabaseService;
class Maintenance;
class Settings;

class AuditTrail : public QObject {
    Q_OBJECT

public:
    // The watched objects; all must outlive the trail.
    struct Parts {
        Controller& controller;
        Editor& editor;
        Settings& settings;
        Maintenance& maintenance;
        Access& access;
    };

    AuditTrail(DatabaseService& records, const Parts& parts, QObject* parent);

    // Starts recording.
    void open();
    // Adds an entry that is not watched here; sets its time, user and level.
    void note(const store::AuditEntry& entry);
    // Adds an entry for files that were taken out.
    void noteExport(const QStringList& paths, const QString& problem);
    // Adds an entry that no person at the panel has caused; sets its time.
    void noteOutside(store::AuditEntry entry);
    void setWallClock(Access::WallClock clock) { m_wallClock = std::move(clock); }

signals:
    // Emitted when the row is on the disk.
    void appended(const campanel::store::AuditRow& row);

private:
    struct Download {
        QList<store::AuditEntry> entries; // the first one is the program, the others its values
        std::uint32_t crc = 0;
    };

    // Returns the entry with the present time, user and level.
    [[nodiscard]] store::AuditEntry signedNow(store::AuditEntry entry) const;
    // Returns the name of the controller's program; empty while it is unknown.
    [[nodiscard]] QString activeProgram() const;
    void append(const store::AuditEntry& entry);
    void watchCommands();
    void watchParameters();
    void watchDownloads();
    void watchSettings();
    void watchSimulation();
    void noteSending(const link::CommandRequest& request);
    void noteWriting(const QString& name, double value);
    void noteWritten(const link::ParameterOutcome& outcome);
    [[nodiscard]] QList<store::AuditEntry>::iterator findWrite(const QString& name);
    void beginDownload(const program::ProgramImage& image);
    void endDownload(const link::DownloadReport& report);
    void proveDownload(bool isLast);
    void noteSettings();
    void noteWizard();
    void watchManual();
    void watchLine();

    DatabaseService& m_records;
    Parts m_parts;
    Access::WallClock m_wallClock;
    QHash<quint32, store::AuditEntry> m_commands; // pending, by id
    QList<store::AuditEntry> m_writes;            // under way, oldest first
    std::optional<Download> m_download;
    bool m_isDownloadProven = false; // proven by the link; the status with its generation may still be
                                     // pending
    QTimer m_proofTimer;
    QStringList m_settings; // texts of the audited ones
    QString m_faults;
    int m_wizardStep = 0;
};

} // namespace campanel::panel
