// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/knot_files.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/refusal_sentences.h"

#include <QFileInfo>

#include <algorithm>

namespace campanel::panel {

namespace {

KnotFiles::Found scanDisks(const QString& ownFolder)
{
    KnotFiles::Found found;
    found.places = store::exchangePlaces(ownFolder);
    found.offers = store::offeredKnots(found.places);
    return found;
}

} // namespace

KnotFiles::KnotFiles(const QString& ownFolder, QObject* parent)
    : FileExchange(ownFolder, parent)
    , m_scanner(&scanDisks)
{
}

void KnotFiles::show(const std::vector<profile::Knot>& knots, const QString& recipeName)
{
    m_knots = knots;
    m_recipeName = recipeName;
}

std::function<FileExchange::Apply()> KnotFiles::searcher()
{
    return [this, scan = m_scanner, folder = ownFolder(), name = m_recipeName]() -> Apply {
        const Found found = scan(folder);
        QStringList paths;
        for (const store::Place& place : found.places)
            paths << store::exportPath(name, place);
        return [this, found, paths] { showFound(found, paths); };
    };
}

void KnotFiles::showFound(const Found& found, const QStringList& exportPaths)
{
    m_found = found;
    QList<OfferRow> files;
    for (const store::KnotsOffer& offer : found.offers)
        files << fileRow(offer);
    m_files.setRows(files);
    m_places.setRows(placeRows(found.places, [&exportPaths](qsizetype place) {
        return tr("A new file %1 will be written.").arg(exportPaths[place]);
    }));
}

OfferRow KnotFiles::fileRow(const store::KnotsOffer& offer) const
{
    const Format format;
    OfferRow row;
    row.title = QFileInfo(offer.path).fileName();
    row.usable = offer.isUsable();
    const QString date = Format::minute(offer.changed);
    row.note = row.usable ? tr("%1 knots · %2 · %3", "number, date, place")
                                .arg(offer.knots.size())
                                .arg(date, offer.placeName)
                          : tr("cannot be used · %1 · %2", "date, place").arg(date, offer.placeName);
    if (offer.refusal) {
        row.detail =
            tr("Line %1: %2 Correct the file; the panel reads it again automatically.", "%2: whole sentence")
                .arg(offer.refusedLine)
                .arg(RefusalSentences::refusal(*offer.refusal));
    } else if (!row.usable) {
        row.detail = tr("%1 Correct the file; the panel reads it again automatically.", "%1: whole sentence")
                         .arg(offer.problem);
    } else {
        const auto [lowest, highest] = std::ranges::minmax(offer.knots, {}, &profile::Knot::slaveMm);
        row.detail =
            tr("%1 knots, slave %2 to %3 mm, will replace the recipe's knots. Undo restores the old knots.")
                .arg(offer.knots.size())
                .arg(format.compact(lowest.slaveMm, 0, 3), format.compact(highest.slaveMm, 0, 3));
    }
    return row;
}

void KnotFiles::take(int file)
{
    if (file >= 0 && file < m_found.offers.size() && m_found.offers[file].isUsable())
        emit taken(m_found.offers[file].knots);
}

void KnotFiles::write(int place)
{
    if (place < 0 || place >= m_found.places.size() || m_found.places[place].isReadOnly)
        return;
    run([where = m_found.places[place], knots = m_knots,
         name = m_recipeName] { return store::exportKnots(knots, name, where); },
        [this, isOnStick = m_found.places[place].isRemovable](const auto& written) {
            showWritten({written.value_or(QString())}, written ? QString() : written.error(), isOnStick);
            search();
        });
}

} // namespace campanel::panel
