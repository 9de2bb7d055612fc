// SPDX-License-Identifier: Apache-2.0
// `Backup` in QML: saves everything that the panel stores to one file, and restores it. A restore is checked
// completely before it may be confirmed; then the panel restarts with the restored data. For the level
// Service.
#pragma once

#include "app/panel/kit/file_exchange.h"
#include "app/panel/kit/offer_model.h"
#include "app/panel/kit/report_files.h"
#include "app/panel/kit/singleton.h"
#include "app/store/backup/restore.h"

#include <QDateTime>
#include <QObject>
#include <QTemporaryDir>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <memory>

namespace campanel::panel {

class Access;
class AuditTrail;
class Editor;
class Controller;
class DatabaseService;
class Settings;
class Trends;

class Backup : public campanel::panel::FileExchange, public Singleton<Backup> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(campanel::panel::ReportFiles* places READ places CONSTANT FINAL)
    // The backups on a stick or in the panel's own folder.
    Q_PROPERTY(campanel::panel::RowModelBase* found READ found CONSTANT FINAL)
    // The consequence of restoring the checked backup; empty while none is checked.
    Q_PROPERTY(QString question READ question NOTIFY changed FINAL)

public:
    using WallClock = std::function<QDateTime()>;

    // The contents of a backup and the access checks; all must outlive the object.
    struct Parts {
        Controller& controller;
        Editor& editor;
        DatabaseService& records;
        Trends& trends;
        Settings& settings;
        Access& access;
        AuditTrail& trail;
    };

    // Stores its own files in a folder below `folder`, which also holds the database.
    Backup(const Parts& parts, const QString& folder, QObject* parent);

    // Replaces the search of this computer's disks, for tests and captures.
    void setScanner(Scanner scanner);
    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }

    // Reads the present data and offers it to `places`; then emits offered().
    Q_INVOKABLE void make();
    // Unpacks and checks the backup. Ends in checked() and a question, or in a message with the reason.
    Q_INVOKABLE void check(int row);
    // Restores the checked backup: saves a backup of the present state, then emits restartWanted() or shows a
    // message.
    Q_INVOKABLE void restore();

    [[nodiscard]] ReportFiles* places() { return &m_places; }
    [[nodiscard]] OfferModel* found() { return &m_found; }
    [[nodiscard]] QString question() const;

signals:
    void offered();
    void checked();
    // Emitted when the confirmed data is ready on the disk: the panel must be rebuilt.
    void restartWanted();

private:
    struct Found {
        QString path;
        QString placeName;
        tl::expected<store::BackupManifest, store::BackupError> manifest;
        QString notice; // which files of the place `path` are missing; empty: this is a backup
    };
    struct Checked {
        QString path;
        store::BackupManifest manifest;
    };

    // The present state in a folder that is deleted with its last owner.
    struct Snapshot {
        std::shared_ptr<QTemporaryDir> folder;
        store::BackupManifest manifest;
        store::BackupParts parts;
        QString newestRow; // number and hash of the newest row of the audit trail
    };

    [[nodiscard]] bool require();
    void snapshot(const std::function<void(const Snapshot& taken)>& then);
    void addTrends(const Snapshot& taken, const std::function<void(const Snapshot& taken)>& then);
    void seal(const Snapshot& present);
    [[nodiscard]] std::function<Apply()> searcher() override;
    [[nodiscard]] static QList<Found> foundIn(const store::Place& place);
    [[nodiscard]] static Found missing(const store::Place& place, const QString& notice);
    void takeFound(const QList<Found>& found);
    [[nodiscard]] OfferRow row(const Found& found) const;
    [[nodiscard]] QString summary(const store::BackupManifest& manifest) const;

    Parts m_parts;
    QString m_folder;
    ReportFiles m_places;
    Scanner m_scanner;
    WallClock m_wallClock;
    OfferModel m_found{this};
    QList<Found> m_files;
    std::optional<Checked> m_checked;
};

} // namespace campanel::panel
