// SPDX-License-Identifier: Apache-2.0
// The log of the machine's states in the database: one row per interval, a ring of the newest 100 000, and
// the reason of each stop. Times are milliseconds since 1970 UTC. Call it in the thread that owns the
// database.
#pragma once

#include "app/store/logs/table.h"

#include <QList>
#include <QString>

#include <optional>

namespace campanel::store {

// An interval ends with its state or program, with a jump of the clock, and at each quarter of an hour of
// UTC.
struct StateInterval {
    // Stored by number. Suspended: running, but the film has waited for a product for some seconds.
    enum class State { Idle, Ready, Running, Stopping, Jogging, Homing, Fault, Suspended };

    qint64 id = 0;   // ascending in order of time
    qint64 stop = 0; // the id of the first interval of its stop; 0: the machine produces
    State state = State::Idle;
    qint64 beginMs = 0;    // by the wall clock
    qint64 durationMs = 0; // by the steady clock
    QString program;       // empty: none
    int version = 0;
    double idealPerMin = 0; // the ideal rate; 0: unknown
    qint64 cycles = 0;      // the controller's count at the end
    qint64 pieces = 0;      // bags, strokes or cycles that were completed
    qint64 outOfTolerance = 0;
    qint64 startUpScrap = 0;      // also those of a change of program
    qint64 skipped = 0;           // cuts
    bool isClockDoubtful = false; // begun while the clock was not set; see clock_mark.h

    [[nodiscard]] qint64 endMs() const { return beginMs + durationMs; }
    bool operator==(const StateInterval&) const = default;
};

[[nodiscard]] inline bool produces(StateInterval::State state)
{
    return state == StateInterval::State::Running || state == StateInterval::State::Stopping;
}

// The reason of a stop that has one.
struct StopRow {
    qint64 id = 0;          // of its first interval
    QString reason;         // the code of an alarm, "waiting", or an entry of the list of reasons
    bool isPlanned = false; // when it was given
    QString by;             // empty: given by the machine, or by a person without a name
    qint64 answeredMs = 0;

    bool operator==(const StopRow&) const = default;
};

[[nodiscard]] const Table<StateInterval>& stateTable();
[[nodiscard]] const Table<StopRow>& stopTable();

// The changes of one transaction.
struct StopChanges {
    QList<StateInterval> intervals; // new ones, and written ones that have changed
    QList<StopRow> stops;

    [[nodiscard]] bool isEmpty() const { return intervals.isEmpty() && stops.isEmpty(); }
};

class StopLog {
public:
    static constexpr qint64 capacity = 100'000;

    // The newest interval, and its stop.
    struct Start {
        std::optional<StateInterval> last;
        std::optional<StopRow> stop; // empty: without a reason, or the machine produced
        qint64 stopBeginMs = 0;
        qint64 stopMs = 0;       // in all its intervals
        qint64 newestMs = 0;     // see newestRecordMs()
        bool hadProgram = false; // in any interval
    };
    // The intervals that begin in a span of time, in their order, and the reasons of their stops.
    struct Span {
        QList<StateInterval> intervals;
        QList<StopRow> stops;
    };

    [[nodiscard]] static tl::expected<Start, StoreError> begin(Database& database);
    // Writes all changes or none, then deletes the oldest intervals beyond the capacity, and the stops that
    // have none left. An interval never gets shorter.
    [[nodiscard]] static tl::expected<void, StoreError> write(Database& database, const StopChanges& changes,
                                                              qint64 capacity = StopLog::capacity);
    [[nodiscard]] static tl::expected<Span, StoreError> between(Database& database, qint64 fromMs,
                                                                qint64 toMs);
    // Returns nothing for a stop without a reason.
    [[nodiscard]] static tl::expected<std::optional<StopRow>, StoreError> stop(Database& database, qint64 id);
};

} // namespace campanel::store
