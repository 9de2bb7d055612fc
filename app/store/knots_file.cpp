// SPDX-License-Identifier: Apache-2.0
#include "app/store/knots_file.h"

#include "app/store/files.h"
#include "profile/knots_csv.h"

#include <QDir>

namespace campanel::store {
namespace {

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

} // namespace

tl::expected<std::vector<profile::Knot>, QString> readKnots(const QString& path)
{
    const auto bytes = readBytes(path);
    if (!bytes)
        return tl::unexpected(notOpened(bytes.error()));
    auto knots = profile::readKnotsCsv({bytes->constData(), static_cast<std::size_t>(bytes->size())});
    if (!knots) {
        const profile::CsvError& error = knots.error();
        return tl::unexpected(FileErrorText::tr("%1, line %2: expected %3, found \"%4\".")
                                  .arg(path)
                                  .arg(error.line)
                                  .arg(expectation(error.expected), QString::fromStdString(error.found)));
    }
    return std::move(*knots);
}

tl::expected<void, QString> writeKnots(std::span<const profile::Knot> knots, const QString& path)
{
    const auto written = replaceBytes(path, QByteArray::fromStdString(profile::writeKnotsCsv(knots)));
    if (!written)
        return tl::unexpected(notOpened(written.error()));
    return {};
}

} // namespace campanel::store
