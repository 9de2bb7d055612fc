// SPDX-License-Identifier: Apache-2.0
// The log of alarms in the database: one row per occurrence, a ring of the newest 100 000, and what is
// shelved. Times are milliseconds since 1970 UTC. To be called in the thread that owns the database.
#pragma once

#include "app/store/database/database.h"

#include <QList>
#include <QString>

#include <optional>

namespace campanel::store {

struct AlarmRow {
    enum class End { Active, Returned, Unknown }; // Unknown: it was active when the panel ended

    qint64 id = 0; // ascending in the order in which they came
    QString code;  // "C-01"
    qint64 raisedMs = 0;
    End end = End::Active;
    qint64 returnedMs = 0; // with Returned only
    bool wantsAcknowledgement = true;
    qint64 acknowledgedMs = 0; // 0: not
    QString acknowledgedBy;
    int count = 1;          // how often it came, when it came and went
    bool isShelved = false; // it was when it came, or has been since
    QString detail;         // at most detailLength is kept
};

struct AlarmShelf {
    QString code;
    qint64 sinceMs = 0;
    qint64 untilMs = 0;
    QString by;

    bool operator==(const AlarmShelf&) const = default;
};

// What is written in one go.
struct AlarmChanges {
    struct Acknowledgement {
        QString code;
        qint64 upToId = 0; // this occurrence and all before it that still want it
        qint64 atMs = 0;
        QString by;
    };

    QList<AlarmRow> rows; // new ones, and ones written before that have changed
    QList<Acknowledgement> acknowledgements;
    std::optional<QList<AlarmShelf>> shelves; // all of them, if they have changed

    [[nodiscard]] bool isEmpty() const { return rows.isEmpty() && acknowledgements.isEmpty() && !shelves; }
};

class AlarmLog {
public:
    static constexpr qint64 capacity = 100'000;
    static constexpr int pageRows = 200;
    static constexpr int detailLength = 300;

    struct Start {
        qint64 lastId = 0; // 0: none yet
        QList<AlarmShelf> shelves;
    };

    // Once, before anything is written: ends as Unknown what was active when the panel ended.
    [[nodiscard]] static tl::expected<Start, StoreError> begin(Database& database);
    // All or nothing; then the oldest rows beyond the capacity go.
    [[nodiscard]] static tl::expected<void, StoreError> write(Database& database,
                                                              const AlarmChanges& changes);
    // Newest first, those before `beforeId`; 0: from the newest on.
    [[nodiscard]] static tl::expected<QList<AlarmRow>, StoreError> page(Database& database, qint64 beforeId,
                                                                        int rows = pageRows);
};

} // namespace campanel::store
