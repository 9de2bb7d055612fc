// SPDX-License-Identifier: Apache-2.0
// `Records` in QML: the panel's persistent data in its database. All access runs in the database's own
// thread; nothing here waits for the disk.
#pragma once

#include "app/panel/kit/singleton.h"
#include "app/store/backup/restore.h"
#include "app/store/database/clock_mark.h"
#include "app/store/store_thread.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <optional>

namespace campanel::panel {

class DatabaseService : public QObject, public Singleton<DatabaseService> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // The notice about the panel's storage: it was damaged, the disk is full or missing ...; empty: none.
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged FINAL)
    // True while the notice says that the disk for the data is missing, which is as urgent as a fault.
    Q_PROPERTY(bool diskLost READ isDiskLost NOTIFY noticeChanged FINAL)

public:
    // `folder` contains the database.
    DatabaseService(const QString& folder, QObject* parent);
    ~DatabaseService() override;

    // Keeps the database closed because the disk for the data is missing; `reason` is what the boot says.
    // Call it before open().
    void noteDiskLost(const QString& reason);
    // Opens the database; until then nothing is read or stored.
    void open() { m_store.open(); }

    [[nodiscard]] QString notice() const;
    [[nodiscard]] bool isDiskLost() const;
    Q_INVOKABLE void dismissNotice();

    [[nodiscard]] store::StoreThread& store() { return m_store; }
    // Renews the backup copy of the database, which replaces it after damage.
    void makeCopy();
    // Returns why the database could not be opened; what is read then is only the memory of this run.
    [[nodiscard]] const std::optional<store::StoreError>& openError() const { return m_openError; }
    // Sets how records learn that the clock of this computer was not set; never by default.
    void setClockState(const std::function<store::ClockState()>& state);
    // Returns whether the time of a record made now can be trusted. Proven stays until the end.
    [[nodiscard]] store::ClockState clockState();
    // Keeps the proof, so that records of a clock that ran ahead mark no later one after a restart either.
    void noteClockProven();
    // Sets the notice of a finished restore; it stays until it is dismissed.
    void noteRestore(const store::FinishedRestore& restore);
    // Reports data that could not be stored.
    void reportError(const store::StoreError& error);

signals:
    void noticeChanged();
    void errorReported(const campanel::store::StoreError& error); // emitted by reportError()

private:
    void takeOpening(const store::StoreThread::Report& report);
    void noteRenamed(const store::Database::Opening& opening);
    void append(store::AuditEntry entry);
    void noteReplacement(const store::Database::Opening& opening);
    [[nodiscard]] static QString replacementText(const store::Database::Opening& opening);

    store::StoreThread m_store;
    std::optional<store::StoreThread::Report> m_opening; // until its notice is dismissed
    std::optional<store::StoreError> m_openError;
    std::optional<store::StoreError> m_error;
    store::FinishedRestore m_restore;
    std::function<store::ClockState()> m_askClock;
    QElapsedTimer m_clockAsked; // since m_clock was read
    store::ClockState m_clock = store::ClockState::Unproven;
};

} // namespace campanel::panel
