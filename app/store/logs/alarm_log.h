// SPDX-License-Identifier: Apache-2.0
// The log of alarms in the database: one row per occurrence, a ring of the newest 100 000, and the shelved
// alarms. Times are milliseconds since 1970 UTC. Call it in the thread that owns the database.
#pragma once

#include "app/store/logs/table.h"

#include <QList>
#include <QString>

#include <optional>

namespace campanel::store {

struct AlarmRow {
    enum class End { Active, Returned, Unknown }; // Unknown: active when the panel ended

    qint64 id = 0; // ascending in order of occurrence
    QString code;  // "C-01"
    qint64 raisedMs = 0;
    End end = End::Active;
    qint64 returnedMs = 0; // only with Returned
    bool wantsAcknowledgement = true;
    qint64 acknowledgedMs = 0; // 0: not acknowledged
    QString acknowledgedBy;
    int count = 1;                // how many times it came
    bool isShelved = false;       // at present or earlier
    QString detail;               // limited to detailLength
    bool isClockDoubtful = false; // raised while the clock was not set

    bool operator==(const AlarmRow&) const = default;
};

struct AlarmShelf {
    QString code;
    qint64 sinceMs = 0;
    qint64 untilMs = 0;
    QString by;

    bool operator==(const AlarmShelf&) const = default;
};

[[nodiscard]] const Table<AlarmRow>& alarmTable();
[[nodiscard]] const Table<AlarmShelf>& alarmShelfTable();

// The changes of one transaction.
struct AlarmChanges {
    struct Acknowledgement {
        QString code;
        qint64 upToId = 0; // acknowledges this occurrence and all earlier ones that need it
        qint64 atMs = 0;
        QString by;
    };

    QList<AlarmRow> rows; // new ones, and written ones that have changed
    QList<Acknowledgement> acknowledgements;
    std::optional<QList<AlarmShelf>> shelves; // all of them, if they have changed

    [[nodiscard]] bool isEmpty() const { return rows.isEmpty() && acknowledgements.isEmpty() && !shelves; }
};

class AlarmLog {
public:
    static constexpr qint64 capacity = 100'000;
    static constexpr int detailLength = 300;
    static constexpr int maxUnacknowledged = 200;

    struct Start {
        qint64 lastId = 0;   // 0: none
        qint64 newestMs = 0; // see newestRecordMs()
        QList<AlarmShelf> shelves;
        QList<AlarmRow> unacknowledged; // the newest first, at most maxUnacknowledged
    };

    // Marks alarms that were active when the panel ended as Unknown. Call it once, before the first write().
    [[nodiscard]] static tl::expected<Start, StoreError> begin(Database& database);
    // Writes all changes or none, then deletes the oldest rows beyond the capacity.
    [[nodiscard]] static tl::expected<void, StoreError> write(Database& database,
                                                              const AlarmChanges& changes);
};

} // namespace campanel::store
