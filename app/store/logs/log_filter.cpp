// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/log_filter.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <array>
#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

// Returns the text with the letters A to Z small, as LIKE of SQLite compares them.
QString asciiLower(QString text)
{
    for (QChar& sign : text) {
        if (sign >= u'A' && sign <= u'Z')
            sign = QChar(sign.unicode() - u'A' + u'a');
    }
    return text;
}

bool containsPart(const QVariant& value, const QString& part)
{
    return asciiLower(value.toString()).contains(asciiLower(part));
}

// Returns an id without spaces and hyphens in capital letters: "C01" for "c-01".
QString bareId(QString id)
{
    return id.remove(u'-').remove(u' ').toUpper();
}

// Returns the pattern of LIKE ... ESCAPE '\' for texts that contain `part`.
QString likePattern(const QString& part)
{
    QString escaped;
    for (const QChar sign : part) {
        if (sign == u'%' || sign == u'_' || sign == u'\\')
            escaped += u'\\';
        escaped += sign;
    }
    return u'%' + escaped + u'%';
}

// Returns the number that the id is; 0: it is none.
qint64 numberOf(const LogFilter& filter)
{
    const QString id = filter.id.trimmed();
    const qint64 number = id.toLongLong();
    return QString::number(number) == id ? number : 0;
}

QString keysJson(const LogFilter& filter)
{
    return QString::fromUtf8(
        QJsonDocument(QJsonArray::fromStringList(filter.keysOfWord)).toJson(QJsonDocument::Compact));
}

qint64 endMs(const LogFilter& filter)
{
    return filter.toMs == 0 ? std::numeric_limits<qint64>::max() : filter.toMs;
}

// One comparison of a column, in SQL and for a value; both mean the same.
struct Comparison {
    Sought as;
    QString sql; // %1: the column
    QVariant (*wanted)(const LogFilter& filter);
    bool (*isMet)(const QVariant& value, const LogFilter& filter);
};

// A part of the filter: one of its comparisons must be met.
struct Part {
    bool (*isSet)(const LogFilter& filter);
    QList<Comparison> comparisons;
};

// The sign + keeps the order of the rows: the range was found by the index of times already.
const QList<Part>& parts()
{
    using Filter = const LogFilter&;
    using Value = const QVariant&;
    static const QList<Part> all{
        {[](Filter filter) { return filter.fromMs != 0; },
         {{Sought::Time, u"+%1 >= ?"_s, [](Filter filter) { return QVariant(filter.fromMs); },
           [](Value value, Filter filter) { return value.toLongLong() >= filter.fromMs; }}}},
        {[](Filter filter) { return filter.toMs != 0; },
         {{Sought::Time, u"+%1 < ?"_s, [](Filter filter) { return QVariant(filter.toMs); },
           [](Value value, Filter filter) { return value.toLongLong() < filter.toMs; }}}},
        {[](Filter filter) { return filter.who.has_value(); },
         {{Sought::Person, u"%1 = ?"_s, [](Filter filter) { return QVariant(*filter.who); },
           [](Value value, Filter filter) { return value.toString() == *filter.who; }}}},
        {[](Filter filter) { return !filter.area.isEmpty(); },
         {{Sought::Area, u"%1 GLOB ? || '.*'"_s, [](Filter filter) { return QVariant(filter.area); },
           [](Value value, Filter filter) { return value.toString().startsWith(filter.area + u'.'); }}}},
        {[](Filter filter) { return !filter.id.trimmed().isEmpty(); },
         {{Sought::Number, u"%1 = ?"_s, [](Filter filter) { return QVariant(numberOf(filter)); },
           [](Value value, Filter filter) { return value.toLongLong() == numberOf(filter); }},
          {Sought::Code, u"instr(replace(%1, '-', ''), ?) > 0"_s,
           [](Filter filter) { return QVariant(bareId(filter.id)); },
           [](Value value, Filter filter) { return bareId(value.toString()).contains(bareId(filter.id)); }},
          {Sought::Name, u"%1 LIKE ? ESCAPE '\\'"_s,
           [](Filter filter) { return QVariant(likePattern(filter.id.trimmed())); },
           [](Value value, Filter filter) { return containsPart(value, filter.id.trimmed()); }}}},
        {[](Filter filter) { return !filter.word.isEmpty(); },
         {{Sought::Word, u"%1 LIKE ? ESCAPE '\\'"_s,
           [](Filter filter) { return QVariant(likePattern(filter.word)); },
           [](Value value, Filter filter) { return containsPart(value, filter.word); }},
          {Sought::Key, u"%1 IN (SELECT value FROM json_each(?))"_s,
           [](Filter filter) { return QVariant(keysJson(filter)); },
           [](Value value, Filter filter) { return filter.keysOfWord.contains(value.toString()); }},
          {Sought::FirstKey,
           u"substr(%1, 1, instr(%1 || ' ', ' ') - 1) IN (SELECT value FROM json_each(?))"_s,
           [](Filter filter) { return QVariant(keysJson(filter)); },
           [](Value value, Filter filter) {
               return filter.keysOfWord.contains(value.toString().section(u' ', 0, 0));
           }}}},
    };
    return all;
}

// Calls `use` with each comparison of a part and the index of its column.
template <typename Use> void forEachComparison(const Part& part, const QList<SoughtColumn>& columns, Use use)
{
    for (qsizetype at = 0; at < columns.size(); ++at) {
        for (const Comparison& comparison : part.comparisons) {
            if (columns[at].as.testFlag(comparison.as))
                use(comparison, at);
        }
    }
}

} // namespace

Condition conditionOf(const LogFilter& filter, const QList<SoughtColumn>& columns)
{
    Condition condition;
    for (const Part& part : parts()) {
        QStringList alternatives;
        if (part.isSet(filter))
            forEachComparison(part, columns, [&](const Comparison& comparison, qsizetype at) {
                alternatives << comparison.sql.arg(columns[at].name);
                condition.values << comparison.wanted(filter);
            });
        if (!alternatives.isEmpty())
            condition.sql += u" AND (%1)"_s.arg(alternatives.join(u" OR "_s));
    }
    return condition;
}

bool includes(const LogFilter& filter, const QList<SoughtColumn>& columns, const QVariantList& values)
{
    for (const Part& part : parts()) {
        bool isCompared = false;
        bool isMet = false;
        if (part.isSet(filter))
            forEachComparison(part, columns, [&](const Comparison& comparison, qsizetype at) {
                isCompared = true;
                isMet = isMet || comparison.isMet(values[at], filter);
            });
        if (isCompared && !isMet)
            return false;
    }
    return true;
}

tl::expected<LogRange, StoreError> rangeOf(Database& database, const LogFilter& filter, const QString& table,
                                           const QString& idColumn, const QString& timeColumn)
{
    if (!filter.hasSpan())
        return LogRange{std::numeric_limits<qint64>::min(), std::numeric_limits<qint64>::max()};
    auto found = database.execute(
        u"SELECT min(%2), max(%2) FROM %1 WHERE %3 >= ? AND %3 < ?"_s.arg(table, idColumn, timeColumn),
        {filter.fromMs, endMs(filter)});
    if (!found)
        return tl::unexpected(found.error());
    if (!found->next() || found->isNull(0))
        return LogRange{};
    return LogRange{found->value(0).toLongLong(), found->value(1).toLongLong()};
}

} // namespace campanel::store
