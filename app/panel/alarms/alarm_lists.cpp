// SPDX-License-Identifier: Apache-2.0
#include "app/panel/alarms/alarm_lists.h"

#include "app/panel/words/alarm_words.h"

#include <algorithm>

namespace campanel::panel {
namespace {

qint64 idOf(const AlarmEntry& entry)
{
    return entry.row.id;
}

} // namespace

void LiveAlarms::setEntries(std::vector<AlarmEntry> entries, const QDate& today)
{
    m_today = today;
    const int before = count();
    const auto isIn = [](const std::vector<AlarmEntry>& list, const AlarmEntry& entry) {
        return std::ranges::find(list, entry.row.id, idOf) != list.end();
    };
    for (int at = count() - 1; at >= 0; --at) {
        if (isIn(entries, m_entries[static_cast<std::size_t>(at)]))
            continue;
        beginRemoveRows({}, at, at);
        m_entries.erase(m_entries.begin() + at);
        endRemoveRows();
    }
    for (int at = 0; at < static_cast<int>(entries.size()); ++at)
        place(entries[static_cast<std::size_t>(at)], at);
    m_entries = std::move(entries);
    retranslate();
    if (count() != before)
        emit countChanged();
}

// Moves the row of an entry to `at`; the rows before it are already in order.
void LiveAlarms::place(const AlarmEntry& entry, int at)
{
    const auto there = m_entries.begin() + at;
    const auto found = std::ranges::find(there, m_entries.end(), entry.row.id, idOf);
    if (found == m_entries.end()) {
        beginInsertRows({}, at, at);
        m_entries.insert(there, entry);
        endInsertRows();
    } else if (found != there) {
        const int from = static_cast<int>(found - m_entries.begin());
        beginMoveRows({}, from, from, {}, at);
        std::rotate(there, found, found + 1);
        endMoveRows();
    }
}

void LiveAlarms::retranslate()
{
    if (count() > 0)
        emit dataChanged(index(0), index(count() - 1));
}

int LiveAlarms::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant LiveAlarms::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    return AlarmWords::role(m_entries[static_cast<std::size_t>(index.row())].row, role, m_today);
}

QHash<int, QByteArray> LiveAlarms::roleNames() const
{
    return AlarmWords::roles();
}

void ShelvedAlarms::setShelves(const QList<store::AlarmShelf>& shelves, const QDate& today)
{
    if (shelves == m_shelves && today == m_today)
        return; // the scroll position stays
    beginResetModel();
    m_shelves = shelves;
    m_today = today;
    endResetModel();
    emit countChanged();
}

void ShelvedAlarms::retranslate()
{
    if (count() > 0)
        emit dataChanged(index(0), index(count() - 1));
}

int ShelvedAlarms::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant ShelvedAlarms::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const store::AlarmShelf& shelf = m_shelves[index.row()];
    switch (role) {
    case CodeRole:
        return shelf.code;
    case TitleRole:
        return AlarmWords::title(shelf.code);
    case UntilRole:
        return tr("until %1").arg(AlarmWords::time(shelf.untilMs, m_today));
    case ByRole:
        return shelf.by;
    default:
        return {};
    }
}

QHash<int, QByteArray> ShelvedAlarms::roleNames() const
{
    return {{CodeRole, "code"}, {TitleRole, "title"}, {UntilRole, "until"}, {ByRole, "by"}};
}

} // namespace campanel::panel
