// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/cam_files.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/program/program_kinds.h"

#include <QFileInfo>

namespace campanel::panel {

namespace {

CamFiles::Found scanDisks(const QString& ownFolder, const profile::Program& cam)
{
    CamFiles::Found found;
    found.places = store::exchangePlaces(ownFolder);
    found.offers = store::offeredLists(found.places, cam);
    return found;
}

} // namespace

CamFiles::CamFiles(const QString& ownFolder, QObject* parent)
    : FileExchange(ownFolder, parent)
    , m_scanner(&scanDisks)
{
}

void CamFiles::show(const profile::Program& cam, const QString& recipeName)
{
    if (program::kindInfo(profile::kindOf(cam)).list == nullptr)
        return;
    m_cam = cam;
    m_recipeName = recipeName;
}

std::function<FileExchange::Apply()> CamFiles::searcher()
{
    return [this, scan = m_scanner, folder = ownFolder(), cam = m_cam, name = m_recipeName]() -> Apply {
        const Found found = scan(folder, cam);
        QStringList paths;
        for (const store::Place& place : found.places)
            paths << (place.isSilent ? QString() : store::exportPath(name, place));
        return [this, found, paths] { showFound(found, paths); };
    };
}

void CamFiles::showFound(const Found& found, const QStringList& exportPaths)
{
    m_found = found;
    QList<OfferRow> files;
    for (const store::ListOffer& offer : found.offers)
        files << fileRow(offer);
    m_files.setRows(files);
    m_places.setRows(placeRows(found.places, [&exportPaths](qsizetype place) {
        return tr("A new file %1 will be written.").arg(exportPaths[place]);
    }));
}

OfferRow CamFiles::fileRow(const store::ListOffer& offer) const
{
    if (offer.isNotice)
        return noticeRow(offer.placeName, offer.problem);
    const Format format;
    OfferRow row;
    row.title = QFileInfo(offer.path).fileName();
    row.usable = offer.isUsable();
    const QString date = Format::minute(offer.changed);
    row.note = row.usable ? tr("%1 · %2 · %3", "number of knots or segments, date, place")
                                .arg(RecipeWords::listSize(offer.program), date, offer.placeName)
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
        const auto& list = *program::kindInfo(profile::kindOf(offer.program)).list;
        const auto [lowestMm, highestMm] = list.slaveRangeMm(offer.program);
        row.detail = tr("%1, position %2 to %3, will replace those of the recipe. Undo restores them.",
                        "%1: number of knots or segments")
                         .arg(RecipeWords::listSize(offer.program),
                              format.compactAmount(lowestMm, 0, 3, QStringLiteral("mm")),
                              format.compactMeasure(highestMm, 0, 3, QStringLiteral("mm")));
    }
    return row;
}

void CamFiles::take(int file)
{
    if (isAllowed(Level::Technician) && file >= 0 && file < m_found.offers.size() &&
        m_found.offers[file].isUsable())
        emit taken(m_found.offers[file].program);
}

void CamFiles::write(int place)
{
    if (!isAllowed(Level::Operator) || place < 0 || place >= m_found.places.size() ||
        m_found.places[place].isReadOnly || m_found.places[place].isSilent)
        return;
    run([where = m_found.places[place], cam = m_cam, name = m_recipeName,
         dialect = store::spreadsheetDialect()] { return store::exportList(cam, name, where, dialect); },
        [this, isOnStick = m_found.places[place].isRemovable](const auto& path) {
            showWritten(path ? Written{{*path}, {}, {}, isOnStick}
                             : Written{{}, {m_recipeName}, {path.error()}, isOnStick});
            search();
        });
}

} // namespace campanel::panel
