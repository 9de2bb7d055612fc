// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/knot_files.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/refusal_sentences.h"

#include <QFileInfo>

#include <algorithm>

namespace campanel::panel {

namespace {

KnotFiles::Found lookAtDisks(const QString& ownFolder)
{
    KnotFiles::Found found;
    found.places = store::exchangePlaces(ownFolder);
    found.offers = store::offeredKnots(found.places);
    return found;
}

} // namespace

KnotFiles::KnotFiles(const QString& ownFolder, QObject* parent)
    : QObject(parent)
    , m_ownFolder(ownFolder)
    , m_looker(&lookAtDisks)
{
    m_pool.setMaxThreadCount(1);
}

KnotFiles::~KnotFiles()
{
    m_pool.waitForDone();
}

void KnotFiles::show(const std::vector<profile::Knot>& knots, const QString& recipeName)
{
    m_knots = knots;
    m_recipeName = recipeName;
}

void KnotFiles::look()
{
    m_message.clear();
    m_failed = false;
    search();
}

void KnotFiles::search()
{
    ++m_jobs;
    emit changed();
    m_pool.start([this, look = m_looker, folder = m_ownFolder, name = m_recipeName] {
        const Found found = look(folder);
        QStringList paths;
        for (const store::Place& place : found.places)
            paths << store::exportPath(name, place);
        QMetaObject::invokeMethod(this, [this, found, paths] { takeFound(found, paths); });
    });
}

void KnotFiles::takeFound(const Found& found, const QStringList& exportPaths)
{
    m_found = found;
    QList<OfferRow> files;
    for (const store::KnotsOffer& offer : found.offers)
        files << fileRow(offer);
    m_files.setRows(files);
    QList<OfferRow> places;
    for (qsizetype i = 0; i < found.places.size(); ++i) {
        const store::Place& place = found.places[i];
        const QString detail =
            place.isReadOnly
                ? tr("%1 is read-only. Unlock the stick or choose another location.").arg(place.path)
                : tr("A new file %1 will be written.").arg(exportPaths[i]);
        places << OfferRow{place.name, place.isReadOnly ? tr("%1 · read-only").arg(place.path) : place.path,
                           detail, !place.isReadOnly};
    }
    m_places.setRows(places);
    --m_jobs;
    emit changed();
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
        row.detail = tr("Line %1: %2 Correct the file and search again.", "%2: whole sentence")
                         .arg(offer.refusedLine)
                         .arg(RefusalSentences::refusal(*offer.refusal));
    } else if (!row.usable) {
        row.detail = tr("%1 Correct the file and search again.", "%1: whole sentence").arg(offer.problem);
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
    ++m_jobs;
    emit changed();
    m_pool.start([this, where = m_found.places[place], knots = m_knots, name = m_recipeName] {
        const auto written = store::exportKnots(knots, name, where);
        QMetaObject::invokeMethod(this, [this, written, isOnStick = where.isRemovable] {
            m_failed = !written;
            m_message = !written    ? written.error()
                        : isOnStick ? tr("Written: %1. You can remove the stick now.").arg(*written)
                                    : tr("Written: %1").arg(*written);
            --m_jobs;
            search();
        });
    });
}

} // namespace campanel::panel
