// SPDX-License-Identifier: Apache-2.0
// The knots of a point cam as CSV files: files to import and places to export to. A stick may be slow or
// broken: everything that accesses a disk runs in a thread of its own.
#pragma once

#include "app/panel/kit/offer_model.h"
#include "app/store/recipes/knots_file.h"

#include <QObject>
#include <QThreadPool>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <vector>

namespace campanel::panel {

class KnotFiles : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Files of knots belong to the Editor")
    Q_PROPERTY(campanel::panel::RowModelBase* files READ files CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* places READ places CONSTANT FINAL)
    // The folder of this panel, which is always available.
    Q_PROPERTY(QString ownFolder READ ownFolder CONSTANT FINAL)
    Q_PROPERTY(bool busy READ busy NOTIFY changed FINAL)
    // The result of the last write: the path, or the error. Empty until then.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)

public:
    struct Found {
        QList<store::Place> places;
        QList<store::KnotsOffer> offers;
    };
    // Searches for places and files; called in another thread.
    using Looker = std::function<Found(const QString& ownFolder)>;

    KnotFiles(const QString& ownFolder, QObject* parent);
    ~KnotFiles() override;

    // Replaces the search of this computer's disks, for tests and captures.
    void setLooker(Looker looker) { m_looker = std::move(looker); }
    // Sets the knots to write and the name of their recipe.
    void show(const std::vector<profile::Knot>& knots, const QString& recipeName);

    [[nodiscard]] OfferModel* files() { return &m_files; }
    [[nodiscard]] OfferModel* places() { return &m_places; }
    [[nodiscard]] QString ownFolder() const { return m_ownFolder; }
    [[nodiscard]] bool busy() const { return m_jobs > 0; }
    [[nodiscard]] QString message() const { return m_message; }
    [[nodiscard]] bool failed() const { return m_failed; }

    // Searches again and clears the message.
    Q_INVOKABLE void look();
    // Imports the knots of a usable file.
    Q_INVOKABLE void take(int file);
    // Writes a new file to that place, then searches again.
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
    QThreadPool m_pool; // one thread; the destructor waits for it
};

} // namespace campanel::panel
