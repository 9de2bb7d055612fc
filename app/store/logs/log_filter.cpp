// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/log_filter.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

// Returns the text with the letters a to z small, as LIKE of SQLite compares them.
QString asciiLower(QString text)
{
    for (QChar& sign : text) {
        if (sign >= u'A' && sign <= u'Z')
            sign = QChar(sign.unicode() - u'A' + u'a');
    }
    return text;
}

} // namespace

bool LogFilter::includesTime(qint64 timeMs) const
{
    return (fromMs == 0 || timeMs >= fromMs) && timeMs < spanEndMs(*this);
}

bool LogFilter::includesWord(std::initializer_list<QString> keys, std::initializer_list<QString> texts) const
{
    return word.isEmpty() ||
           std::ranges::any_of(keys, [this](const QString& key) { return keysOfWord.contains(key); }) ||
           std::ranges::any_of(texts, [this](const QString& text) { return containsPart(text, word); });
}

QString bareId(const QString& id)
{
    QString bare = id;
    return bare.remove(u'-').remove(u' ').toUpper();
}

bool containsPart(const QString& text, const QString& part)
{
    return asciiLower(text).contains(asciiLower(part));
}

tl::expected<LogRange, StoreError> rangeOf(Database& database, const LogFilter& filter, const QString& table,
                                           const QString& idColumn, const QString& timeColumn)
{
    if (!filter.hasSpan())
        return LogRange{std::numeric_limits<qint64>::min(), std::numeric_limits<qint64>::max()};
    auto found = database.execute(
        u"SELECT min(%2), max(%2) FROM %1 WHERE %3 >= ? AND %3 < ?"_s.arg(table, idColumn, timeColumn),
        {filter.fromMs, spanEndMs(filter)});
    if (!found)
        return tl::unexpected(found.error());
    if (!found->next() || found->isNull(0))
        return LogRange{};
    return LogRange{found->value(0).toLongLong(), found->value(1).toLongLong()};
}

qint64 spanEndMs(const LogFilter& filter)
{
    return filter.toMs == 0 ? std::numeric_limits<qint64>::max() : filter.toMs;
}

QString likePattern(const QString& part)
{
    if (part.isEmpty())
        return u""_s;
    QString escaped;
    for (const QChar sign : part) {
        if (sign == u'%' || sign == u'_' || sign == u'\\')
            escaped += u'\\';
        escaped += sign;
    }
    return u'%' + escaped + u'%';
}

QString keysJson(const LogFilter& filter)
{
    return QString::fromUtf8(
        QJsonDocument(QJsonArray::fromStringList(filter.keysOfWord)).toJson(QJsonDocument::Compact));
}

} // namespace campanel::store
