// SPDX-License-Identifier: Apache-2.0
// The knots of a point cam as CSV files: files to import and places to export to.
#pragma once

#include "app/panel/kit/file_exchange.h"
#include "app/store/recipes/knots_file.h"

#include <vector>

namespace campanel::panel {

class KnotFiles : public campanel::panel::FileExchange {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Files of knots belong to the Editor")
    Q_PROPERTY(campanel::panel::RowModelBase* files READ files CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* places READ places CONSTANT FINAL)

public:
    struct Found {
        QList<store::Place> places;
        QList<store::KnotsOffer> offers;
    };
    // Searches for places and files; called in another thread.
    using Scanner = std::function<Found(const QString& ownFolder)>;

    KnotFiles(const QString& ownFolder, QObject* parent);

    // Replaces the search of this computer's disks, for tests and captures.
    void setScanner(Scanner scanner) { m_scanner = std::move(scanner); }
    // Sets the knots to write and the name of their recipe.
    void show(const std::vector<profile::Knot>& knots, const QString& recipeName);

    [[nodiscard]] OfferModel* files() { return &m_files; }
    [[nodiscard]] OfferModel* places() { return &m_places; }

    // Imports the knots of a usable file.
    Q_INVOKABLE void take(int file);
    // Writes a new file to that place, then searches again.
    Q_INVOKABLE void write(int place);

signals:
    void taken(const std::vector<campanel::profile::Knot>& knots);

private:
    [[nodiscard]] std::function<Apply()> searcher() override;
    void showFound(const Found& found, const QStringList& exportPaths);
    [[nodiscard]] OfferRow fileRow(const store::KnotsOffer& offer) const;

    Scanner m_scanner;
    OfferModel m_files{this};
    OfferModel m_places{this};
    Found m_found;
    std::vector<profile::Knot> m_knots;
    QString m_recipeName;
};

} // namespace campanel::panel
