// SPDX-License-Identifier: Apache-2.0
// `Records` in QML: what the panel remembers over a restart, in its database. Everything that is kept goes
// through the database's own thread; nothing here waits for the disk.
#pragma once

#include "app/store/backup/restore.h"
#include "app/store/store_thread.h"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <optional>

class QJSEngine;
class QQmlEngine;

namespace campanel::machine {

class Records : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // What the operator must know about the panel's memory: it was damaged, the disk is full ...; empty:
    // nothing.
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged FINAL)

public:
    // The database is kept in `folder`.
    Records(const QString& folder, QObject* parent);
    ~Records() override;

    // Opens the database; until then nothing is read or kept.
    void open() { m_store.open(); }

    // The instance that attachToEngine() gave to this engine.
    static Records* create(QQmlEngine* qmlEngine, QJSEngine* jsEngine);

    [[nodiscard]] QString notice() const;
    Q_INVOKABLE void dismissNotice();

    [[nodiscard]] store::StoreThread& store() { return m_store; }
    // Makes the copy of the database anew, which takes its place should it be damaged one day.
    void makeCopy();
    // A backup has taken the place of what was kept; said until it is dismissed.
    void noteRestore(const store::FinishedRestore& restore);
    // Something could not be kept.
    void complain(const store::StoreError& error);

signals:
    void noticeChanged();
    void troubled(const campanel::store::StoreError& error); // somebody complained

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void takeOpening(const store::StoreThread::Report& report);
    void noteReplacement(const store::Database::Opening& opening);
    [[nodiscard]] static QString replacementText(const store::Database::Opening& opening);

    store::StoreThread m_store;
    std::optional<store::StoreThread::Report> m_opening; // until its notice was dismissed
    std::optional<store::StoreError> m_error;
    store::FinishedRestore m_restore;
};

} // namespace campanel::machine
