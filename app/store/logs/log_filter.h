// SPDX-License-Identifier: Apache-2.0
// The part of a log to read: a span of time, an id and a word. Comparisons ignore the case of the letters a
// to z, as SQLite does; every sign, also % and _, is an ordinary one.
#pragma once

#include "app/store/database/database.h"

#include <QString>
#include <QStringList>

#include <initializer_list>

namespace campanel::store {

struct LogFilter {
    qint64 fromMs = 0; // since 1970 UTC; 0: no limit
    qint64 toMs = 0;   // exclusive; 0: no limit
    QString id;        // part of the id of an alarm, or row or object of the audit trail
    QString word;      // part of a text
    // The stored keys whose texts contain the word in the language of the reader.
    QStringList keysOfWord;

    [[nodiscard]] bool isActive() const { return hasSpan() || !id.isEmpty() || !word.isEmpty(); }
    [[nodiscard]] bool hasSpan() const { return fromMs != 0 || toMs != 0; }

    // Return the same as the conditions in SQL, for rows that are added to a list already read.
    [[nodiscard]] bool includesTime(qint64 timeMs) const;
    // `keys` are the stored keys of the row, `texts` its stored texts.
    [[nodiscard]] bool includesWord(std::initializer_list<QString> keys,
                                    std::initializer_list<QString> texts) const;

    bool operator==(const LogFilter&) const = default;
};

// Returns an id without spaces and hyphens in capital letters: "C01" for "c-01".
[[nodiscard]] QString bareId(const QString& id);
// Returns true when `text` contains `part`.
[[nodiscard]] bool containsPart(const QString& text, const QString& part);

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
// Returns the end of the span as a number for a comparison in SQL.
[[nodiscard]] qint64 spanEndMs(const LogFilter& filter);
// Returns the pattern of LIKE ... ESCAPE '\' for texts that contain `part`; empty for an empty one.
[[nodiscard]] QString likePattern(const QString& part);
// Returns `keysOfWord` as JSON for json_each().
[[nodiscard]] QString keysJson(const LogFilter& filter);

} // namespace campanel::store
