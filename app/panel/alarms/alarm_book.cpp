// SPDX-License-Identifier: Apache-2.0
#include "app/panel/alarms/alarm_book.h"

#include "app/store/database/clock_mark.h"

#include <algorithm>
#include <ranges>
#include <tuple>
#include <utility>

namespace campanel::panel {

using store::AlarmRow;

namespace {

bool isShelvable(const QString& code)
{
    const AlarmKind* kind = AlarmCatalogue::find(code);
    return kind && !kind->stopsMachine;
}

// Returns a smaller value for a more urgent alarm.
auto urgency(const AlarmEntry& entry)
{
    const int group = entry.isShelved ? 3 : entry.isUnacknowledged() ? (entry.isActive() ? 0 : 1) : 2;
    return std::tuple(group, -static_cast<int>(entry.kind->severity), -entry.row.id);
}

bool wantsAcknowledgement(const AlarmEntry& entry)
{
    return entry.kind->severity > AlarmSeverity::Notice && !entry.isShelved;
}

} // namespace

AlarmEntry* AlarmBook::find(const QString& code)
{
    const auto found = std::ranges::find_if(m_entries | std::views::reverse,
                                            [&](const AlarmEntry& entry) { return entry.row.code == code; });
    return found == m_entries.rend() ? nullptr : &*found;
}

AlarmEntry& AlarmBook::newEntry(const QString& code)
{
    std::erase_if(m_entries, [&](const AlarmEntry& earlier) {
        return earlier.row.code == code && !earlier.isUnacknowledged();
    });
    const auto kept = std::ranges::count(m_entries, code, [](const auto& entry) { return entry.row.code; });
    if (kept < unacknowledgedRows)
        return m_entries.emplace_back();
    return *find(code) = {};
}

void AlarmBook::note(const AlarmEntry& entry)
{
    m_waiting.insert_or_assign(entry.row.id, entry.row);
}

void AlarmBook::raise(const AlarmKind& kind, const QString& detail, const Now& now)
{
    const QString code = kind.code();
    AlarmEntry* entry = find(code);
    if (entry && entry->isActive())
        return;
    const bool isSame =
        entry && (now.steady - entry->returnedAt < sameWithin || m_waiting.size() >= waitingRows);
    if (isSame) {
        entry->row.end = AlarmRow::End::Active;
        entry->row.returnedMs = 0;
        ++entry->row.count;
        entry->row.isShelved = entry->row.isShelved || entry->isShelved;
        entry->row.wantsAcknowledgement = wantsAcknowledgement(*entry);
    } else {
        entry = &newEntry(code);
        entry->kind = &kind;
        entry->isShelved = isShelved(code);
        entry->row.id = ++m_lastId;
        entry->row.code = code;
        entry->row.raisedMs = now.utcMs;
        entry->row.isClockDoubtful = now.isClockDoubtful;
        entry->row.isShelved = entry->isShelved;
        entry->row.wantsAcknowledgement = wantsAcknowledgement(*entry);
    }
    if (!detail.isEmpty())
        entry->row.detail = detail.left(store::AlarmLog::detailLength);
    note(*entry);
}

void AlarmBook::clear(const AlarmKind& kind, const Now& now, AlarmRow::End end)
{
    AlarmEntry* entry = find(kind.code());
    if (!entry || !entry->isActive())
        return;
    entry->row.end = end;
    entry->row.returnedMs = end == AlarmRow::End::Returned ? now.utcMs : 0;
    entry->returnedAt = now.steady;
    note(*entry);
}

void AlarmBook::acknowledge(const QString& code, qint64 id, const QString& by, qint64 utcMs)
{
    for (AlarmEntry& entry : m_entries) {
        if (entry.row.code != code || entry.row.id > id || !entry.isUnacknowledged())
            continue;
        entry.row.acknowledgedMs = utcMs;
        entry.row.acknowledgedBy = by;
        note(entry);
    }
    m_acknowledgements.append({code, id, utcMs, by});
}

bool AlarmBook::isShelved(const QString& code) const
{
    return std::ranges::any_of(m_shelves, [&](const auto& shelf) { return shelf.code == code; });
}

bool AlarmBook::shelve(const QString& code, qint64 untilMs, const QString& by, qint64 utcMs)
{
    if (!isShelvable(code))
        return false;
    m_shelves.removeIf([&](const auto& shelf) { return shelf.code == code; });
    m_shelves.append({code, utcMs, untilMs, by});
    m_haveShelvesChanged = true;
    updateShelved();
    return true;
}

void AlarmBook::unshelve(const QString& code)
{
    if (m_shelves.removeIf([&](const auto& shelf) { return shelf.code == code; }) == 0)
        return;
    m_haveShelvesChanged = true;
    updateShelved();
}

bool AlarmBook::endShelves(qint64 utcMs)
{
    const auto isOver = [&](const auto& shelf) { return shelf.untilMs <= utcMs || shelf.sinceMs > utcMs; };
    if (m_shelves.removeIf(isOver) == 0)
        return false;
    m_haveShelvesChanged = true;
    updateShelved();
    return true;
}

// Updates the calls: a shelved alarm does not call; an active one that is unshelved needs to be acknowledged.
void AlarmBook::updateShelved()
{
    for (AlarmEntry& entry : m_entries) {
        const bool isNow = isShelved(entry.row.code);
        const bool wasShelved = std::exchange(entry.isShelved, isNow);
        if (wasShelved == isNow || !entry.isLive())
            continue;
        entry.row.isShelved = entry.row.isShelved || isNow;
        entry.row.wantsAcknowledgement = wantsAcknowledgement(entry);
        note(entry);
    }
}

void AlarmBook::begin(const store::AlarmLog::Start& start, store::ClockState clock)
{
    m_isBegun = true;
    const auto mark = [&start, clock](AlarmRow& row) {
        row.isClockDoubtful =
            row.isClockDoubtful || store::isTimeDoubtful(row.raisedMs, start.newestMs, clock);
    };
    std::map<qint64, AlarmRow> waiting;
    for (auto& [id, row] : m_waiting) {
        row.id += start.lastId;
        mark(row);
        waiting.emplace(row.id, row);
    }
    m_waiting = std::move(waiting);
    for (AlarmEntry& entry : m_entries) {
        entry.row.id += start.lastId;
        mark(entry.row);
    }
    for (auto& given : m_acknowledgements)
        given.upToId += start.lastId;
    m_lastId += start.lastId;
    std::vector<AlarmEntry> before;
    for (const AlarmRow& row : start.unacknowledged) {
        const AlarmKind* kind = AlarmCatalogue::find(row.code);
        const bool isAnswered = // meanwhile
            std::ranges::count(m_acknowledgements, row.code, &store::AlarmChanges::Acknowledgement::code) > 0;
        if (kind && !isAnswered && std::ranges::count(before, kind, &AlarmEntry::kind) < unacknowledgedRows)
            before.insert(before.begin(), {.kind = kind, .row = row});
    }
    m_entries.insert(m_entries.begin(), before.begin(), before.end());
    for (const store::AlarmShelf& shelf : start.shelves) {
        if (!isShelved(shelf.code) && isShelvable(shelf.code))
            m_shelves.append(shelf);
    }
    updateShelved();
}

std::vector<AlarmEntry> AlarmBook::live() const
{
    std::vector<AlarmEntry> live;
    std::ranges::copy_if(m_entries, std::back_inserter(live), &AlarmEntry::isLive);
    std::ranges::sort(live, {}, urgency);
    return live;
}

const AlarmEntry* AlarmBook::entryWith(qint64 id) const
{
    const auto found =
        std::ranges::find_if(m_entries, [&](const AlarmEntry& entry) { return entry.row.id == id; });
    return found == m_entries.end() ? nullptr : &*found;
}

store::AlarmChanges AlarmBook::takeChanges()
{
    store::AlarmChanges changes;
    for (const auto& [id, row] : std::exchange(m_waiting, {}))
        changes.rows.append(row);
    changes.acknowledgements = std::exchange(m_acknowledgements, {});
    if (std::exchange(m_haveShelvesChanged, false))
        changes.shelves = m_shelves;
    return changes;
}

void AlarmBook::putBack(const store::AlarmChanges& changes)
{
    for (const AlarmRow& row : changes.rows)
        m_waiting.emplace(row.id, row); // unless it has changed since
    m_acknowledgements = changes.acknowledgements + m_acknowledgements;
    m_haveShelvesChanged = m_haveShelvesChanged || changes.shelves.has_value();
}

} // namespace campanel::panel
