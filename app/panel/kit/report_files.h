// SPDX-License-Identifier: Apache-2.0
// Reports taken to a stick or to the panel's own folder, as new files. A stick may be slow or broken:
// everything that touches a disk, and the making of long texts, happens in a thread of its own.
#pragma once

#include "app/panel/kit/offer_model.h"
#include "app/store/files/new_file.h"

#include <QObject>
#include <QThreadPool>
#include <QtQml/qqmlregistration.h>

#include <functional>

namespace campanel::machine {

struct ReportFile {
    QString name; // a person's words; see store::freePath()
    QString suffix;
    std::function<QByteArray()> content; // called in another thread
    store::FileWriter write{};           // the same of a large one, instead of `content`
};

class ReportFiles : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Report files belong to the Service")
    Q_PROPERTY(campanel::machine::OfferModel* places READ places CONSTANT FINAL)
    Q_PROPERTY(bool busy READ busy NOTIFY changed FINAL)
    // What became of the last write: where the files are, or why there are none. Empty until then.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)

public:
    // Looks for places; called in another thread.
    using Looker = std::function<QList<store::Place>(const QString& ownFolder)>;

    ReportFiles(const QString& ownFolder, QObject* parent);
    ~ReportFiles() override;

    // Instead of the disks of this computer, for tests and captures.
    void setLooker(Looker looker) { m_looker = std::move(looker); }
    // What will be written; forgets the last message and looks for places.
    void offer(QList<ReportFile> files);

    [[nodiscard]] OfferModel* places() { return &m_places; }
    [[nodiscard]] bool busy() const { return m_jobs > 0; }
    [[nodiscard]] QString message() const { return m_message; }
    [[nodiscard]] bool failed() const { return m_failed; }

    // Looks again at what there is and forgets the message.
    Q_INVOKABLE void look();
    // The same in silence, for who waits for a stick: the message stays.
    Q_INVOKABLE void refresh();
    // Writes new files to that place, then looks again.
    Q_INVOKABLE void write(int place);

signals:
    void changed();
    // Of what was offered; `problem` is empty when all of it was.
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
    QThreadPool m_pool; // one thread; waits for it at the end
};

} // namespace campanel::machine
