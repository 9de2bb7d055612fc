// SPDX-License-Identifier: Apache-2.0
// `Backup` in QML: saves everything that the panel stores to one file, and restores it. A restore is checked
// completely before it may be confirmed; then the panel restarts with the restored data. For the level
// Service.
#pragma once

#include "app/panel/kit/offer_model.h"
#include "app/panel/kit/report_files.h"
#include "app/store/backup/restore.h"

#include <QDateTime>
#include <QObject>
#include <QTemporaryDir>
#include <QThreadPool>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <memory>

class QJSEngine;
class QQmlEngine;

namespace campanel::panel {

class Access;
class AuditTrail;
class Editor;
class Controller;
class DatabaseService;
class Settings;
class Trends;

class Backup : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

    Q_PROPERTY(campanel::panel::ReportFiles* places READ places CONSTANT FINAL)
    // The backups on a stick or in the panel's own folder.
    Q_PROPERTY(campanel::panel::RowModelBase* found READ found CONSTANT FINAL)
    Q_PROPERTY(bool busy READ busy NOTIFY changed FINAL)
    // The result of the last request; empty: none.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)
    // The consequence of restoring the checked backup; empty while none is checked.
    Q_PROPERTY(QString question READ question NOTIFY changed FINAL)

public:
    using Looker = std::function<QList<store::Place>(const QString& ownFolder)>;
    using WallClock = std::function<QDateTime()>;

    // The contents of a backup and the access checks; all must outlive the object.
    struct Parts {
        Controller& machine;
        Editor& editor;
        DatabaseService& records;
        Trends& trends;
        Settings& settings;
        Access& access;
        AuditTrail& trail;
    };

    // Stores its own files in a folder below `folder`, which also holds the database.
    Backup(const Parts& parts, const QString& folder, QObject* parent);
    ~Backup() override;

    static Backup* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    // Replaces the search of this computer's disks, for tests and captures.
    void setLooker(Looker looker);
    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }

    // Reads the present data and offers it to `places`; then emits offered().
    Q_INVOKABLE void make();
    // Searches for backups; refresh() leaves the message, for a page that waits for a stick.
    Q_INVOKABLE void look();
    Q_INVOKABLE void refresh();
    // Unpacks and checks the backup. Ends in checked() and a question, or in a message with the reason.
    Q_INVOKABLE void check(int row);
    // Restores the checked backup: saves a backup of the present state, then emits restartWanted() or shows a
    // message.
    Q_INVOKABLE void restore();

    [[nodiscard]] ReportFiles* places() { return &m_places; }
    [[nodiscard]] OfferModel* found() { return &m_found; }
    [[nodiscard]] QString ownFolder() const { return m_ownFolder; }
    [[nodiscard]] bool busy() const { return m_jobs > 0; }
    [[nodiscard]] QString message() const { return m_message; }
    [[nodiscard]] bool failed() const { return m_failed; }
    [[nodiscard]] QString question() const;

signals:
    void changed();
    void offered();
    void checked();
    // Emitted when the confirmed data is ready on the disk: the panel must be rebuilt.
    void restartWanted();

private:
    struct Found {
        QString path;
        QString placeName;
        tl::expected<store::BackupManifest, store::BackupError> manifest;
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

    void retranslate();
    [[nodiscard]] bool require();
    void snapshot(const std::function<void(const Snapshot& taken)>& then);
    void addTrends(const Snapshot& taken, const std::function<void(const Snapshot& taken)>& then);
    void seal(const Snapshot& present);
    void search(const std::function<void()>& done);
    void takeFound(const QList<Found>& found);
    [[nodiscard]] OfferRow row(const Found& found) const;
    [[nodiscard]] QString summary(const store::BackupManifest& manifest) const;
    void begin();
    void end();
    void tell(const QString& message, bool failed);

    Parts m_parts;
    QString m_folder;
    QString m_ownFolder;
    ReportFiles m_places;
    Looker m_looker;
    WallClock m_wallClock;
    OfferModel m_found{this};
    QList<Found> m_files;
    std::optional<Checked> m_checked;
    QString m_message;
    bool m_failed = false;
    bool m_isRefreshing = false;
    int m_jobs = 0;
    QThreadPool m_pool; // one thread; the destructor waits for it
};

} // namespace campanel::panel
