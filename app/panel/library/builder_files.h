// SPDX-License-Identifier: Apache-2.0
// `BuilderFiles` in QML: the files that the machine builder has given the panel: the configuration, and what
// the boot of the image found on the card. The boot leaves a folder with recipes and a report of all files;
// they are taken once, told in the audit trail and in a notice, and the folder is removed.
#pragma once

#include "app/panel/kit/singleton.h"
#include "app/store/logs/audit_log.h"

#include <QObject>
#include <QList>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <utility>

namespace campanel::panel {

class DatabaseService;
class Recipes;

class BuilderFiles : public QObject, public Singleton<BuilderFiles> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // The files that were taken, and those that were not and why, until it is dismissed; empty: none.
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged FINAL)

public:
    // The arguments must outlive the object.
    BuilderFiles(Recipes& recipes, DatabaseService& records, QObject* parent);

    // Shows the errors of the configuration, and takes the files of the folder as soon as the recipes have
    // been read. Signatures are checked with the keys in `keyFolder`.
    void open(const QString& folder, const QString& keyFolder, const QStringList& complaints);

    [[nodiscard]] QString notice() const { return m_notice; }
    Q_INVOKABLE void dismissNotice();

signals:
    // Emitted for the audit trail; no person at the panel has caused it.
    void noted(const campanel::store::AuditEntry& entry);
    void noticeChanged();

private:
    void take();
    void refuse(const QString& file, const QString& reason);
    // Shows the notice, and removes the folder once the rows of the audit trail are on the disk.
    void finish(const QString& folder);
    void show();

    Recipes& m_recipes;
    DatabaseService& m_records;
    QString m_folder; // empty: nothing to take
    QString m_keyFolder;
    QStringList m_complaints;                     // a sentence each
    QList<std::pair<QString, QString>> m_refused; // file and reason
    QStringList m_taken;                          // files that are no recipes
    int m_recipeCount = 0;
    QString m_notice;
};

} // namespace campanel::panel
