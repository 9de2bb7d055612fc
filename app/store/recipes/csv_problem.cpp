// SPDX-License-Identifier: Apache-2.0
#include "app/store/recipes/csv_problem.h"

#include "app/store/files/json_reader.h"
#include "profile/segments/segment_cam.h"

#include <QDir>

namespace campanel::store {
namespace {

QString headerOf(std::span<const std::string_view> columns)
{
    QStringList names;
    for (const std::string_view column : columns)
        names << toQString(column);
    return names.join(u',');
}

QString motionKeys()
{
    QStringList keys;
    for (const profile::SegmentMotionInfo& each : profile::segmentMotions())
        keys << toQString(each.key);
    return keys.join(QStringLiteral(", "));
}

QString expectation(profile::CsvExpectation expected, std::span<const std::string_view> columns)
{
    using profile::CsvExpectation;
    switch (expected) {
    case CsvExpectation::Header:
        return FileErrorText::tr("the header %1").arg(headerOf(columns));
    case CsvExpectation::Values:
        return FileErrorText::tr("%1 values, as in the header").arg(columns.size());
    case CsvExpectation::Number:
        return FileErrorText::aNumber();
    case CsvExpectation::DecimalPoint:
        return FileErrorText::tr("a number with a decimal point");
    case CsvExpectation::DecimalComma:
        return FileErrorText::tr("a number with a decimal comma");
    case CsvExpectation::Rows:
        return FileErrorText::tr("at least one line of values");
    case CsvExpectation::Motion:
        return FileErrorText::tr("one of: %1").arg(motionKeys());
    case CsvExpectation::Utf8:
        break;
    }
    return {};
}

} // namespace

QString csvNotOpened(const FileError& error)
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

QString csvProblem(const profile::CsvError& error, const QString& path,
                   std::span<const std::string_view> columns)
{
    if (error.expected == profile::CsvExpectation::Utf8)
        return FileErrorText::tr("The file %1 is not UTF-8 text. Save the file as CSV in UTF-8.").arg(path);
    return FileErrorText::tr("%1, line %2: expected %3, found \"%4\".")
        .arg(path, QString::number(error.line), expectation(error.expected, columns),
             QString::fromStdString(error.found));
}

} // namespace campanel::store
