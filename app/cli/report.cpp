// SPDX-License-Identifier: Apache-2.0
// Flattens JSON objects, and writes CSV tables.
#include "app/cli/report.h"

#include "app/program/cam_advance.h"
#include "app/store/files/files.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

struct Line {
    QString key;
    QJsonValue value;
};

// Flattens lists of words; lists of numbers are only in JSON.
void flatten(const QString& prefix, const QJsonObject& object, QList<Line>& lines)
{
    for (auto it = object.begin(); it != object.end(); ++it) {
        const QString name = cellText(it.key());
        const QString key = prefix.isEmpty() ? name : prefix + u'.' + name;
        if (it->isObject()) {
            flatten(key, it->toObject(), lines);
        } else if (it->isArray()) {
            const QJsonArray items = it->toArray();
            QStringList texts;
            for (const QJsonValue& item : items) {
                if (item.isString())
                    texts << cellText(item.toString());
            }
            if (!texts.isEmpty() || items.isEmpty())
                lines << Line{key, texts.join(u"; "_s)};
        } else {
            lines << Line{key, *it};
        }
    }
}

// Unknown or not finite is null in JSON.
bool isKnown(const QJsonValue& value)
{
    return value.isBool() || value.isString() || (value.isDouble() && std::isfinite(value.toDouble()));
}

QString scalarText(const QJsonValue& value)
{
    if (!isKnown(value))
        return u"--"_s;
    if (value.isBool())
        return value.toBool() ? u"yes"_s : u"no"_s;
    if (value.isDouble())
        return QString::fromLatin1(number(value.toDouble()));
    return value.toString().isEmpty() ? u"none"_s : cellText(value.toString());
}

QByteArray linesCsv(const QList<Line>& lines)
{
    store::CsvWriter csv(u"key,value", {});
    for (const auto& [key, value] : lines) {
        csv.text(key);
        addCell(csv, value);
        csv.endLine();
    }
    return csv.bytes();
}

} // namespace

QString cellText(const QString& text)
{
    return store::oneLine(text, store::maxLineLength);
}

QByteArray number(double value)
{
    constexpr int digits = 10;
    return QByteArray::number(value, 'g', digits);
}

QJsonValue orNull(const std::optional<double>& value)
{
    return value ? QJsonValue(*value) : QJsonValue(QJsonValue::Null);
}

QByteArray csvTable(const std::vector<Column>& columns)
{
    QStringList names;
    for (const Column& column : columns)
        names << QString::fromLatin1(column.name);
    store::CsvWriter csv(names.join(u','), {});
    for (std::size_t row = 0; row < columns.front().values->size(); ++row) {
        for (const Column& column : columns)
            csv.significant((*column.values)[row]);
        csv.endLine();
    }
    return csv.bytes();
}

void addCell(store::CsvWriter& csv, const QJsonValue& value)
{
    if (value.isBool())
        csv.yesOrNo(value.toBool());
    else if (!isKnown(value))
        csv.empty();
    else if (value.isDouble())
        csv.significant(value.toDouble());
    else
        csv.text(value.toString());
}

QString cellOf(const QJsonValue& value)
{
    if (value.isBool())
        return value.toBool() ? u"yes"_s : u"no"_s;
    if (value.isNull())
        return u"--"_s;
    return value.isString() ? store::oneLine(value.toString()) : QString::number(value.toInteger());
}

QByteArray rowsText(const QJsonArray& rows, const QStringList& keys, const QMap<QString, QString>& titles)
{
    QStringList lines(rows.size() + 1);
    for (const QString& key : keys) {
        QStringList cells{titles.value(key, key)};
        for (const QJsonValue& row : rows)
            cells << cellOf(row.toObject().value(key));
        qsizetype width = 0;
        for (const QString& cell : cells)
            width = std::max(width, cell.size());
        for (qsizetype i = 0; i < lines.size(); ++i)
            lines[i] += cells[i].leftJustified(width + 2);
    }
    for (QString& line : lines)
        line = line.trimmed() + u'\n';
    return lines.join(QString()).toUtf8();
}

QByteArray formatted(const QJsonObject& object, const QString& format)
{
    if (format == u"json")
        return QJsonDocument(object).toJson();
    QList<Line> lines;
    flatten({}, object, lines);
    if (format == u"csv")
        return linesCsv(lines);
    qsizetype width = 0;
    for (const auto& line : lines)
        width = std::max(width, line.key.size());
    QString text;
    for (const auto& [key, value] : lines)
        text += key.leftJustified(width) + u"  "_s + scalarText(value) + u'\n';
    return text.toUtf8();
}

void addAdvance(QJsonObject& object, const profile::Program& program)
{
    if (profile::camMaster(program) == nullptr)
        return;
    const double advanceMm = program::advanceMm(program);
    object[u"advance_mm_per_cycle"_s] = advanceMm;
    object[u"advance_confirmed"_s] =
        advanceMm == 0 ? QJsonValue() : QJsonValue(program::isAdvanceConfirmed(program));
}

QString crcText(std::uint32_t crc)
{
    return QString::number(crc, 16).toUpper().rightJustified(8, u'0');
}

QString fromView(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

} // namespace campanel::cli
