// SPDX-License-Identifier: Apache-2.0
// The states of all alarms since the start: active or returned, acknowledged or not, shelved. One entry per
// kind, so that no flood makes it grow; what has changed is collected for the log. Values only: no clock, no
// thread.
#pragma once

#include "app/panel/words/alarm_catalogue.h"
#include "app/store/logs/alarm_log.h"

#include <chrono>
#include <map>
#include <vector>

namespace campanel::machine {

struct AlarmEntry {
    const AlarmKind* kind = nullptr;
    store::AlarmRow row;
    link::SteadyTime returnedAt{};
    bool isShelved = false; // now

    [[nodiscard]] bool isActive() const { return row.end == store::AlarmRow::End::Active; }
    [[nodiscard]] bool isUnacknowledged() const
    {
        return row.wantsAcknowledgement && row.acknowledgedMs == 0;
    }
    [[nodiscard]] bool isLive() const { return isActive() || isUnacknowledged(); }
};

class AlarmBook {
public:
    // One that comes again so soon is the same occurrence, counted.
    static constexpr std::chrono::seconds sameWithin{10};
    // With so many rows waiting for the disk, each that comes again is the same occurrence.
    static constexpr std::size_t waitingRows = 1000;

    struct Now {
        link::SteadyTime steady;
        qint64 utcMs = 0;
    };

    void raise(const AlarmKind& kind, const QString& detail, const Now& now);
    // Nothing happens when it is not active.
    void clear(const AlarmKind& kind, const Now& now,
               store::AlarmRow::End end = store::AlarmRow::End::Returned);
    // This occurrence and the ones before it.
    void acknowledge(const QString& code, qint64 id, const QString& by, qint64 utcMs);
    // False when it stops the machine: such a one calls until it is dealt with.
    bool shelve(const QString& code, qint64 untilMs, const QString& by, qint64 utcMs);
    void unshelve(const QString& code);
    // Takes off the shelf what has been there long enough, or was put there in the future: the clock was set.
    // True when there was something.
    bool endShelves(qint64 utcMs);

    // The log ends with this id and these shelves: what came meanwhile follows it. Called once.
    void begin(const store::AlarmLog::Start& start);

    // Active, or wanting to be acknowledged; the most urgent first.
    [[nodiscard]] std::vector<AlarmEntry> live() const;
    // Null when the kind's last occurrence is another one.
    [[nodiscard]] const AlarmEntry* entryWith(qint64 id) const;
    [[nodiscard]] const QList<store::AlarmShelf>& shelves() const { return m_shelves; }
    [[nodiscard]] bool isShelved(const QString& code) const;

    // What is to be written; empty afterwards.
    [[nodiscard]] store::AlarmChanges takeChanges();
    // It could not be written.
    void putBack(const store::AlarmChanges& changes);
    [[nodiscard]] bool hasChanges() const
    {
        return !m_waiting.empty() || !m_acknowledgements.isEmpty() || m_haveShelvesChanged;
    }

private:
    [[nodiscard]] AlarmEntry* find(const QString& code);
    void note(const AlarmEntry& entry);
    void updateShelved();

    std::vector<AlarmEntry> m_entries; // the last occurrence of each kind that came
    QList<store::AlarmShelf> m_shelves;
    qint64 m_lastId = 0;
    std::map<qint64, store::AlarmRow> m_waiting; // by id
    QList<store::AlarmChanges::Acknowledgement> m_acknowledgements;
    bool m_haveShelvesChanged = false;
};

} // namespace campanel::machine
