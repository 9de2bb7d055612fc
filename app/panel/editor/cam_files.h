// SPDX-License-Identifier: Apache-2.0
// The knots or segments of a cam as CSV files: files to import and places to export to.
#pragma once

#include "app/panel/kit/file_exchange.h"
#include "app/store/recipes/list_file.h"

namespace campanel::panel {

class CamFiles : public campanel::panel::FileExchange {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Files of a cam belong to the Editor")
    Q_PROPERTY(campanel::panel::RowModelBase* files READ files CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* places READ places CONSTANT FINAL)

public:
    struct Found {
        QList<store::Place> places;
        QList<store::ListOffer> offers;
    };
    // Searches for places and files of a cam's list; called in another thread.
    using Scanner = std::function<Found(const QString& ownFolder, const profile::Program& cam)>;

    CamFiles(const QString& ownFolder, QObject* parent);

    // Replaces the search of this computer's disks, for tests and captures.
    void setScanner(Scanner scanner) { m_scanner = std::move(scanner); }
    // Sets the cam to write and the name of its recipe; ignores a program without a list.
    void show(const profile::Program& cam, const QString& recipeName);

    [[nodiscard]] OfferModel* files() { return &m_files; }
    [[nodiscard]] OfferModel* places() { return &m_places; }

    // Imports the list of a usable file.
    Q_INVOKABLE void take(int file);
    // Writes a new file to that place, then searches again.
    Q_INVOKABLE void write(int place);

signals:
    void taken(const campanel::profile::Program& cam);

private:
    [[nodiscard]] std::function<Apply()> searcher() override;
    void showFound(const Found& found, const QStringList& exportPaths);
    [[nodiscard]] OfferRow fileRow(const store::ListOffer& offer) const;

    Scanner m_scanner;
    OfferModel m_files{this};
    OfferModel m_places{this};
    Found m_found;
    profile::Program m_cam = profile::PointCamProgram{};
    QString m_recipeName;
};

} // namespace campanel::panel
