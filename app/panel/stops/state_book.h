// SPDX-License-Identifier: Apache-2.0
// The intervals of the machine's states. Durations are measured by the steady clock, so that each second is
// counted once, whatever the wall clock does; a jump of the wall clock ends an interval and begins another.
// Changes are collected for the log. Values only: no clock, no thread.
#pragma once

#include "app/link/link_values.h"
#include "app/store/logs/stop_log.h"

#include <map>
#include <optional>

namespace campanel::panel {

class StateBook {
public:
    // An interval ends at each quarter of an hour of UTC, so that it lies in one shift.
    static constexpr qint64 quarterMs = 900'000;
    // The largest difference between wall clock and steady clock within an interval.
    static constexpr qint64 maxDriftMs = 1000;
    // The longest time without a status within an interval.
    static constexpr qint64 maxSilenceMs = 5000;
    // The longest unknown time within a stop: the panel was restarted, or the line was lost.
    static constexpr qint64 maxGapMs = 900'000;
    // The first part of a stop, in which the machine itself may give its reason.
    static constexpr qint64 ownReasonMs = 5000;
    // The number of intervals that wait for a full disk.
    static constexpr std::size_t maxWaiting = 20'000;

    struct Now {
        link::SteadyTime steady;
        qint64 utcMs = 0;
        bool isClockDoubtful = false;
    };
    struct Observation {
        store::StateInterval::State state = store::StateInterval::State::Idle;
        QString program;
        int version = 0;
        double idealPerMin = 0; // 0: unknown
        qint64 cycles = 0;
        QString ownReason; // the code of the alarm that stops the machine, or "waiting"; empty: none
    };
    struct Pieces {
        qint64 pieces = 0;
        qint64 outOfTolerance = 0;
        qint64 startUpScrap = 0;
        qint64 skipped = 0;
    };

    // Continues after the log's last interval. Nothing is recorded before, nor before the first program: a
    // machine that has never had one does not stand still.
    void begin(const store::StopLog::Start& start);
    [[nodiscard]] bool isBegun() const { return m_isBegun; }

    void note(const Observation& seen, const Now& now);
    // Ends the interval when there was no status for some time.
    void check(const Now& now);
    // Ends the present interval and goes on with another one: an order begins or ends.
    void divide(const Now& now);
    // Adds pieces to the present interval, or to the last one.
    void add(const Pieces& pieces);
    // Sets the reason of the present stop. Returns false when this is not the present stop.
    bool answer(const store::StopRow& answer);

    // Returns the present interval up to the last status; empty while nothing is known.
    [[nodiscard]] const std::optional<store::StateInterval>& present() const { return m_open; }
    // Returns the present stop with its reason; its id is 0 while the machine produces, or is unknown.
    [[nodiscard]] store::StopRow presentStop() const;
    // Return the time of the present stop up to the last status, gaps left out, and its begin.
    [[nodiscard]] qint64 stopMs() const;
    [[nodiscard]] qint64 stopBeginMs() const { return m_stopBeginMs; }

    // Returns the changes to write, with the present interval, and clears them.
    [[nodiscard]] store::StopChanges takeChanges();
    // Puts changes that could not be written back into the queue.
    void putBack(const store::StopChanges& changes);
    // Returns true when an interval has begun or ended, or a reason was given.
    [[nodiscard]] bool hasNews() const { return m_hasNews; }

private:
    void open(const Observation& seen, qint64 beginMs, link::SteadyTime steady);
    void close(qint64 durationMs);
    [[nodiscard]] bool continuesStop(const Observation& seen, qint64 beginMs) const;
    [[nodiscard]] qint64 msSinceBegin(link::SteadyTime steady) const;
    void splitAtQuarters(link::SteadyTime steady);
    void setOwnReason(const Observation& seen, const Now& now);
    void keep(const store::StateInterval& interval);

    bool m_isBegun = false;
    bool m_hadProgram = false; // ever
    bool m_hasNews = false;
    qint64 m_lastId = 0;
    std::optional<store::StateInterval> m_open;
    link::SteadyTime m_openSince; // steady clock at the begin of m_open
    link::SteadyTime m_lastStatus;
    Observation m_seen;
    bool m_isClockDoubtful = false;
    std::optional<store::StateInterval> m_last; // ended
    bool m_isLastContinued = false;             // m_open follows m_last without a gap
    store::StopRow m_stop;                      // of m_open, or of m_last
    qint64 m_stopMs = 0;                        // in its ended intervals
    qint64 m_stopBeginMs = 0;
    std::map<qint64, store::StateInterval> m_waiting; // by id
    std::map<qint64, store::StopRow> m_waitingStops;
};

} // namespace campanel::panel
