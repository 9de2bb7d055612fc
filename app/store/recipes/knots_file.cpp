// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/knots_file.h"

#include "app/store/files/files.h"
#include "app/store/files/new_file.h"
#include "app/store/recipes/csv_problem.h"
#include "profile/cam/knots_csv.h"
#include "profile/cam/point_cam.h"

#include <algorithm>

namespace campanel::store {
namespace {

// The maximum number of files per place: a longer list cannot be searched by touch.
constexpr qsizetype maxFiles = 100;

KnotsOffer readOffer(const QString& path)
{
    KnotsOffer offer;
    offer.path = path;
    const auto bytes = readBytes(path);
    if (!bytes) {
        offer.problem = csvNotOpened(bytes.error());
        return offer;
    }
    const std::string_view text{bytes->constData(), static_cast<std::size_t>(bytes->size())};
    auto knots = profile::readKnotsCsv(text);
    if (!knots) {
        offer.problem = csvProblem(knots.error(), path, profile::knotColumns());
        return offer;
    }
    offer.knots = std::move(*knots);
    offer.refusal = profile::checkKnots(offer.knots);
    if (offer.refusal)
        offer.refusedLine =
            profile::lineOfKnot(text, static_cast<std::size_t>(std::max(offer.refusal->index, 0)));
    return offer;
}

} // namespace

tl::expected<std::vector<profile::Knot>, QString> readKnots(const QString& path)
{
    KnotsOffer read = readOffer(path);
    if (!read.problem.isEmpty())
        return tl::unexpected(read.problem);
    return std::move(read.knots);
}

tl::expected<void, QString> writeKnots(std::span<const profile::Knot> knots, const QString& path)
{
    const auto written = replaceBytes(path, QByteArray::fromStdString(profile::writeKnotsCsv(knots)));
    if (!written)
        return tl::unexpected(csvNotOpened(written.error()));
    return {};
}

QList<KnotsOffer> offeredKnots(const QList<Place>& places)
{
    QList<KnotsOffer> offers;
    for (const Place& place : places) {
        for (const QFileInfo& file : filesIn(place, QStringLiteral("csv"), maxFiles)) {
            KnotsOffer offer = readOffer(file.filePath());
            offer.placeName = place.name;
            offer.changed = file.lastModified();
            offers << offer;
        }
    }
    std::ranges::stable_sort(offers, std::ranges::greater(), &KnotsOffer::changed);
    return offers;
}

QString exportPath(const QString& recipeName, const Place& place)
{
    return freePath(place, recipeName, QStringLiteral("csv"));
}

tl::expected<QString, QString> exportKnots(std::span<const profile::Knot> knots, const QString& recipeName,
                                           const Place& place)
{
    return writeNewFile(place, recipeName, QStringLiteral("csv"),
                        QByteArray::fromStdString(profile::writeKnotsCsv(knots)));
}

} // namespace campanel::store
