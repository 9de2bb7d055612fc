// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/knots_file.h"

#include "app/store/files/files.h"
#include "app/store/files/new_file.h"
#include "profile/cam/knots_csv.h"
#include "profile/cam/point_cam.h"

#include <QDir>

#include <algorithm>

namespace campanel::store {
namespace {

// The maximum number of files per place: a longer list cannot be searched by touch.
constexpr qsizetype maxFiles = 100;

QString expectation(profile::CsvExpectation expected)
{
    using profile::CsvExpectation;
    switch (expected) {
    case CsvExpectation::Header:
        return FileErrorText::tr("the header master_deg,slave_mm");
    case CsvExpectation::TwoValues:
        return FileErrorText::tr("two values, as in the header");
    case CsvExpectation::Number:
        return FileErrorText::aNumber();
    case CsvExpectation::DecimalPoint:
        return FileErrorText::tr("a number with a decimal point");
    case CsvExpectation::DecimalComma:
        return FileErrorText::tr("a number with a decimal comma");
    case CsvExpectation::Knots:
        return FileErrorText::tr("at least one line of values");
    case CsvExpectation::Utf8:
        break;
    }
    return {};
}

QString notOpened(const FileError& error)
{
    const QString path = QDir::toNativeSeparators(error.path);
    switch (error.kind) {
    case FileError::Kind::NotFound:
        return FileErrorText::tr("The file %1 does not exist. Check its name.").arg(path);
    case FileError::Kind::NotWritable:
        return FileErrorText::tr("The file %1 cannot be written: %2.").arg(path, error.found);
    default:
        return FileErrorText::tr("The file %1 cannot be read: %2.").arg(path, error.found);
    }
}

QString problemOf(const profile::CsvError& error, const QString& path)
{
    if (error.expected == profile::CsvExpectation::Utf8)
        return FileErrorText::tr("The file %1 is not UTF-8 text. Save the file as CSV in UTF-8.").arg(path);
    return FileErrorText::tr("%1, line %2: expected %3, found \"%4\".")
        .arg(path)
        .arg(error.line)
        .arg(expectation(error.expected), QString::fromStdString(error.found));
}

KnotsOffer readOffer(const QString& path)
{
    KnotsOffer offer;
    offer.path = path;
    const auto bytes = readBytes(path);
    if (!bytes) {
        offer.problem = notOpened(bytes.error());
        return offer;
    }
    const std::string_view text{bytes->constData(), static_cast<std::size_t>(bytes->size())};
    auto knots = profile::readKnotsCsv(text);
    if (!knots) {
        offer.problem = problemOf(knots.error(), path);
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
        return tl::unexpected(notOpened(written.error()));
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
