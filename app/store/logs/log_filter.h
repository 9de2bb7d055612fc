// SPDX-License-Identifier: Apache-2.0
// The part of a log to read: a span of time, an id, a word, a person. Comparisons ignore the case of the
// letters a to z, as SQLite does; every sign, also % and _, is an ordinary one.
#pragma once

#include "app/store/database/database.h"

#include <QFlags>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>

namespace campanel::store {

struct LogFilter {
    qint64 fromMs = 0; // since 1970 UTC; 0: no limit
    qint64 toMs = 0;   // exclusive; 0: no limit
    QString id{};      // part of the id of an alarm, or row or object of the audit trail
    QString word{};    // part of a text
    // The stored keys whose texts contain the word in the language of the reader.
    QStringList keysOfWord{};
    std::optional<QString> who{};
    QString area{}; // first part of a key, "parameter"; empty: all

    [[nodiscard]] bool isActive() const { return hasSpan() || !id.isEmpty() || !word.isEmpty(); }
    [[nodiscard]] bool hasSpan() const { return fromMs != 0 || toMs != 0; }

    bool operator==(const LogFilter&) const = default;
};

// The comparisons of a filter with a column of a log.
enum class Sought {
    Time = 1,
    Number = 2,    // the id, as a whole
    Code = 4,      // the id, as a part; hyphens and spaces do not count
    Name = 8,      // the id, as a part
    Word = 16,     // the word, as a part
    Key = 32,      // the keys of the word
    FirstKey = 64, // the same; the key is the first word of the column
    Person = 128,
    Area = 256,
};
Q_DECLARE_FLAGS(SoughtAs, Sought)
Q_DECLARE_OPERATORS_FOR_FLAGS(SoughtAs)

struct SoughtColumn {
    QString name; // in SQL
    SoughtAs as;
};

// The conditions of a filter in SQL, each with AND before it, and the values of their question marks.
struct Condition {
    QString sql;
    QVariantList values;
};
[[nodiscard]] Condition conditionOf(const LogFilter& filter, const QList<SoughtColumn>& columns);
// Returns true when these values of the columns meet the same conditions.
[[nodiscard]] bool includes(const LogFilter& filter, const QList<SoughtColumn>& columns,
                            const QVariantList& values);

// The first and the last id within a span.
struct LogRange {
    qint64 firstId = 0;
    qint64 lastId = -1; // less than firstId: no row
};
// Returns the ids between the first and the last row within the span of the filter. Only the index of times
// is read. After the clock was set back, rows in between can lie outside of the span. `idColumn` is the
// primary key.
[[nodiscard]] tl::expected<LogRange, StoreError> rangeOf(Database& database, const LogFilter& filter,
                                                         const QString& table, const QString& idColumn,
                                                         const QString& timeColumn);

} // namespace campanel::store
