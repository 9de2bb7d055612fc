// SPDX-License-Identifier: Apache-2.0
// The states of all alarms: active or returned, acknowledged or not, shelved. Of each kind it keeps the last
// occurrence and the earlier ones that nobody has acknowledged, a few, also in a flood of alarms. Changes are
// collected for the log. Values only: no clock, no thread.
#pragma once

#include "app/panel/words/alarm_catalogue.h"
#include "app/store/database/clock_mark.h"
#include "app/store/logs/alarm_log.h"

#include <chrono>
#include <map>
#include <vector>

namespace campanel::panel {

struct AlarmEntry {
    const AlarmKind* kind = nullptr;
    store::AlarmRow row;
    link::SteadyTime returnedAt{};
    bool isShelved = false; // at present

    [[nodiscard]] bool isActive() const { return row.end == store::AlarmRow::End::Active; }
    [[nodiscard]] bool isUnacknowledged() const
    {
        return row.wantsAcknowledgement && row.acknowledgedMs == 0;
    }
    [[nodiscard]] bool isLive() const { return isActive() || isUnacknowledged(); }
};

class AlarmBook {
public:
    // The time within which a repeated alarm counts as the same occurrence.
    static constexpr std::chrono::seconds sameWithin{10};
    // The number of rows waiting for the disk at which every repeated alarm counts as the same occurrence.
    static constexpr std::size_t waitingRows = 1000;

    // The number of unacknowledged occurrences of one kind that are listed: the last one and the earliest
    // ones. Those between them are only in the log, and are acknowledged with the last one.
    static constexpr int unacknowledgedRows = 10;

    struct Now {
        link::SteadyTime steady;
        qint64 utcMs = 0;
        bool isClockDoubtful = false;
    };

    void raise(const AlarmKind& kind, const QString& detail, const Now& now);
    // Ends an occurrence; does nothing when the alarm is not active.
    void clear(const AlarmKind& kind, const Now& now,
               store::AlarmRow::End end = store::AlarmRow::End::Returned);
    // Acknowledges this occurrence of the kind and the earlier ones.
    void acknowledge(const QString& code, qint64 id, const QString& by, qint64 utcMs);
    // Shelves an alarm. Returns false when it stops the machine: such an alarm cannot be shelved.
    bool shelve(const QString& code, qint64 untilMs, const QString& by, qint64 utcMs);
    void unshelve(const QString& code);
    // Ends shelves that have expired, or that began in the future because the clock was set. Returns true
    // when there was one.
    bool endShelves(qint64 utcMs);

    // Starts after the log's last id, shelves and unacknowledged rows; earlier occurrences get the following
    // ids. Called once.
    void begin(const store::AlarmLog::Start& start, store::ClockState clock = store::ClockState::Unproven);
    [[nodiscard]] bool isBegun() const { return m_isBegun; }

    // Returns the alarms that are active or need to be acknowledged, the most urgent first.
    [[nodiscard]] std::vector<AlarmEntry> live() const;
    // Returns null when there is no occurrence with this id any more.
    [[nodiscard]] const AlarmEntry* entryWith(qint64 id) const;
    [[nodiscard]] const QList<store::AlarmShelf>& shelves() const { return m_shelves; }
    [[nodiscard]] bool isShelved(const QString& code) const;

    // Returns the changes to write and clears them.
    [[nodiscard]] store::AlarmChanges takeChanges();
    // Puts changes that could not be written back into the queue.
    void putBack(const store::AlarmChanges& changes);
    [[nodiscard]] bool hasChanges() const
    {
        return !m_waiting.empty() || !m_acknowledgements.isEmpty() || m_haveShelvesChanged;
    }

private:
    // Returns the kind's last occurrence.
    [[nodiscard]] AlarmEntry* find(const QString& code);
    [[nodiscard]] AlarmEntry& newEntry(const QString& code);
    void note(const AlarmEntry& entry);
    void updateShelved();

    std::vector<AlarmEntry> m_entries; // those of one kind in the order of their ids
    QList<store::AlarmShelf> m_shelves;
    qint64 m_lastId = 0;
    bool m_isBegun = false;                      // the end of the log is known
    std::map<qint64, store::AlarmRow> m_waiting; // by id
    QList<store::AlarmChanges::Acknowledgement> m_acknowledgements;
    bool m_haveShelvesChanged = false;
};

} // namespace campanel::panel
