// SPDX-License-Identifier: Apache-2.0
// Flattens JSON objects, and writes CSV tables.
#include "app/cli/report.h"

#include "app/program/cam_advance.h"
#include "app/store/files/csv.h"
#include "app/store/files/files.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using Lines = QList<std::pair<QString, QString>>;

QString scalarText(const QJsonValue& value)
{
    switch (value.type()) {
    case QJsonValue::Bool:
        return value.toBool() ? u"yes"_s : u"no"_s;
    case QJsonValue::Double: // unknown or not finite: null in JSON
        return std::isfinite(value.toDouble()) ? QString::fromLatin1(number(value.toDouble())) : u"--"_s;
    case QJsonValue::String:
        return cellText(value.toString());
    default:
        return u"--"_s;
    }
}

// Flattens lists of words; lists of numbers are only in JSON.
void flatten(const QString& prefix, const QJsonObject& object, Lines& lines)
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
                lines << std::pair(key, texts.join(u"; "_s));
        } else {
            lines << std::pair(key, scalarText(*it));
        }
    }
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
    QByteArray text;
    for (const Column& column : columns)
        text.append(text.isEmpty() ? "" : ",").append(column.name);
    text.append('\n');
    for (std::size_t row = 0; row < columns.front().values->size(); ++row) {
        for (std::size_t i = 0; i < columns.size(); ++i)
            text.append(i == 0 ? "" : ",").append(number((*columns[i].values)[row]));
        text.append('\n');
    }
    return text;
}

QByteArray formatted(const QJsonObject& object, const QString& format)
{
    if (format == u"json")
        return QJsonDocument(object).toJson();
    Lines lines;
    flatten({}, object, lines);
    QString text = format == u"csv" ? u"key,value\n"_s : QString();
    qsizetype width = 0;
    for (const auto& line : lines)
        width = std::max(width, line.first.size());
    for (const auto& [key, value] : lines) {
        if (format == u"csv")
            text += key + u',' + store::csvField(value) + u'\n';
        else
            text += key.leftJustified(width) + u"  "_s + (value.isEmpty() ? u"none"_s : value) + u'\n';
    }
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
