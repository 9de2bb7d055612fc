// SPDX-License-Identifier: Apache-2.0
// The knots of a point cam as CSV files: those that can be brought in, and the places they can be taken to.
// A stick may be slow or broken: everything that touches a disk happens in a thread of its own.
#pragma once

#include "app/panel/kit/offer_model.h"
#include "app/store/recipes/knots_file.h"

#include <QObject>
#include <QThreadPool>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <vector>

namespace campanel::machine {

class KnotFiles : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Files of knots belong to the Editor")
    Q_PROPERTY(campanel::machine::OfferModel* files READ files CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::OfferModel* places READ places CONSTANT FINAL)
    // The folder of this panel, the place that is always there.
    Q_PROPERTY(QString ownFolder READ ownFolder CONSTANT FINAL)
    Q_PROPERTY(bool busy READ busy NOTIFY changed FINAL)
    // What became of the last write: where the file is, or why there is none. Empty until then.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)

public:
    struct Found {
        QList<store::Place> places;
        QList<store::KnotsOffer> offers;
    };
    // Looks for places and files; called in another thread.
    using Looker = std::function<Found(const QString& ownFolder)>;

    KnotFiles(const QString& ownFolder, QObject* parent);
    ~KnotFiles() override;

    // Instead of the disks of this computer, for tests and captures.
    void setLooker(Looker looker) { m_looker = std::move(looker); }
    // What would be written, and the name of the recipe that it belongs to.
    void show(const std::vector<profile::Knot>& knots, const QString& recipeName);

    [[nodiscard]] OfferModel* files() { return &m_files; }
    [[nodiscard]] OfferModel* places() { return &m_places; }
    [[nodiscard]] QString ownFolder() const { return m_ownFolder; }
    [[nodiscard]] bool busy() const { return m_jobs > 0; }
    [[nodiscard]] QString message() const { return m_message; }
    [[nodiscard]] bool failed() const { return m_failed; }

    // Looks again at what there is and forgets the message.
    Q_INVOKABLE void look();
    // Takes over the knots of a file that is usable.
    Q_INVOKABLE void take(int file);
    // Writes a new file to that place, then looks again.
    Q_INVOKABLE void write(int place);

signals:
    void changed();
    void taken(const std::vector<campanel::profile::Knot>& knots);

private:
    void search();
    void takeFound(const Found& found, const QStringList& exportPaths);
    [[nodiscard]] OfferRow fileRow(const store::KnotsOffer& offer) const;

    QString m_ownFolder;
    Looker m_looker;
    OfferModel m_files{this};
    OfferModel m_places{this};
    Found m_found;
    std::vector<profile::Knot> m_knots;
    QString m_recipeName;
    QString m_message;
    bool m_failed = false;
    int m_jobs = 0;
    QThreadPool m_pool; // one thread; waits for it at the end
};

} // namespace campanel::machine
