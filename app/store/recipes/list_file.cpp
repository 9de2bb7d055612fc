// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/list_file.h"

#include "app/program/program_kinds.h"
#include "app/store/files/ask_places.h"
#include "app/store/files/files.h"
#include "app/store/files/new_file.h"
#include "app/store/recipes/csv_problem.h"

#include <algorithm>

namespace campanel::store {
namespace {

constexpr qsizetype maxFiles = 2000; // in one place

const program::ListInfo& listOf(const profile::Program& cam)
{
    return *program::kindInfo(profile::kindOf(cam)).list;
}

QByteArray csvOf(const profile::Program& cam, const CsvDialect& dialect)
{
    return QByteArray::fromStdString(listOf(cam).writeCsv(cam, dialect));
}

ListOffer readOffer(const QString& path, const profile::Program& cam)
{
    ListOffer offer;
    offer.path = path;
    offer.program = cam;
    const auto bytes = readBytes(path);
    if (!bytes) {
        offer.problem = csvNotOpened(bytes.error());
        return offer;
    }
    const program::ListInfo& list = listOf(cam);
    const std::string_view text{bytes->constData(), static_cast<std::size_t>(bytes->size())};
    if (const auto error = list.readCsv(text, offer.program)) {
        offer.problem = csvProblem(*error, path, list.csvColumns());
        return offer;
    }
    offer.refusal = list.check(offer.program);
    if (offer.refusal)
        offer.refusedLine =
            profile::csvLineOfRow(text, static_cast<std::size_t>(std::max(offer.refusal->index, 0)));
    return offer;
}

ListOffer missingOffers(const Place& place, const profile::Program& cam, const QString& notice)
{
    ListOffer offer;
    offer.path = place.path;
    offer.placeName = place.name;
    offer.program = cam;
    offer.problem = notice;
    offer.isNotice = true;
    return offer;
}

} // namespace

tl::expected<void, QString> readListCsv(const QString& path, profile::Program& program)
{
    ListOffer read = readOffer(path, program);
    if (!read.problem.isEmpty())
        return tl::unexpected(read.problem);
    program = std::move(read.program);
    return {};
}

tl::expected<void, QString> writeListCsv(const profile::Program& program, const QString& path)
{
    const auto written = replaceBytes(path, csvOf(program, {}));
    if (!written)
        return tl::unexpected(csvNotOpened(written.error()));
    return {};
}

QList<ListOffer> offeredLists(const QList<Place>& places, const profile::Program& cam)
{
    constexpr std::chrono::seconds patience{20}; // a slow stick with many files
    const auto answers = askPlaces<QList<ListOffer>>(
        places,
        [cam](const Place& place) {
            QList<ListOffer> offers;
            const FolderFiles found = filesIn(place, QStringLiteral("*.csv"), maxFiles);
            for (const QFileInfo& file : found.files) {
                offers << readOffer(file.filePath(), cam);
                offers.last().placeName = place.name;
                offers.last().changed = file.lastModified();
            }
            if (!found.notice.isEmpty())
                offers << missingOffers(place, cam, found.notice);
            return offers;
        },
        patience);
    QList<ListOffer> offers;
    for (qsizetype i = 0; i < places.size(); ++i) {
        const auto& answer = answers[static_cast<std::size_t>(i)];
        offers += answer ? *answer : QList{missingOffers(places[i], cam, silentText(places[i]))};
    }
    std::ranges::stable_sort(offers, std::ranges::greater(), &ListOffer::changed);
    return offers;
}

QString exportPath(const QString& recipeName, const Place& place)
{
    return freePath(place, recipeName, QStringLiteral("csv"));
}

tl::expected<QString, QString> exportList(const profile::Program& cam, const QString& recipeName,
                                          const Place& place, const CsvDialect& dialect)
{
    return writeNewFile(place, recipeName, QStringLiteral("csv"), csvOf(cam, dialect));
}

} // namespace campanel::store
