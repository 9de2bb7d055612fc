// SPDX-License-Identifier: Apache-2.0
// Reports written as new files to a stick or to the panel's own folder. A stick may be slow or broken: disk
// access and the creation of long texts run in a thread of their own.
#pragma once

#include "app/panel/kit/offer_model.h"
#include "app/store/files/new_file.h"

#include <QObject>
#include <QThreadPool>
#include <QtQml/qqmlregistration.h>

#include <functional>

namespace campanel::panel {

struct ReportFile {
    QString name; // readable name; see store::freePath()
    QString suffix;
    std::function<QByteArray()> content; // called in another thread
    store::FileWriter write{};           // for large files, instead of `content`
};

class ReportFiles : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Report files belong to the Service")
    Q_PROPERTY(campanel::panel::RowModelBase* places READ places CONSTANT FINAL)
    Q_PROPERTY(bool busy READ busy NOTIFY changed FINAL)
    // The result of the last write: the paths, or the error. Empty until then.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)

public:
    // Searches for places; called in another thread.
    using Looker = std::function<QList<store::Place>(const QString& ownFolder)>;

    ReportFiles(const QString& ownFolder, QObject* parent);
    ~ReportFiles() override;

    // Replaces the search of this computer's disks, for tests and captures.
    void setLooker(Looker looker) { m_looker = std::move(looker); }
    // Sets the files to write; clears the last message and searches for places.
    void offer(QList<ReportFile> files);

    [[nodiscard]] OfferModel* places() { return &m_places; }
    [[nodiscard]] bool busy() const { return m_jobs > 0; }
    [[nodiscard]] QString message() const { return m_message; }
    [[nodiscard]] bool failed() const { return m_failed; }

    // Searches again and clears the message.
    Q_INVOKABLE void look();
    // Searches again without clearing the message, for a page that waits for a stick.
    Q_INVOKABLE void refresh();
    // Writes new files to that place, then searches again.
    Q_INVOKABLE void write(int place);

signals:
    void changed();
    // Emitted with the files written; `problem` is empty when all were written.
    void written(const QStringList& paths, const QString& problem);

private:
    void search();
    void takePlaces(const QList<store::Place>& places);

    QString m_ownFolder;
    Looker m_looker;
    OfferModel m_places{this};
    QList<store::Place> m_found;
    QList<ReportFile> m_files;
    QString m_message;
    bool m_failed = false;
    int m_jobs = 0;
    bool m_isRefreshing = false;
    QThreadPool m_pool; // one thread; the destructor waits for it
};

} // namespace campanel::panel
