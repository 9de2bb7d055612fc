// SPDX-License-Identifier: Apache-2.0
#include "app/panel/alarms/alarm_history.h"

#include "app/panel/records/database_service.h"
#include "app/panel/words/alarm_words.h"

#include <algorithm>
#include <utility>

namespace campanel::panel {

using store::AlarmLog;
using store::AlarmRow;

AlarmHistory::AlarmHistory(DatabaseService& records, QObject* parent)
    : QAbstractListModel(parent)
    , m_records(records)
{
}

void AlarmHistory::setWatched(bool isWatched)
{
    if (m_isWatched == isWatched)
        return;
    m_isWatched = isWatched;
    ++m_round;
    m_isLoaded = m_isReading = m_isAtEnd = false;
    m_meanwhile.clear();
    beginResetModel();
    m_rows.clear();
    endResetModel();
    if (m_isWatched)
        read();
    emit changed();
    emit countChanged();
}

void AlarmHistory::read()
{
    m_isReading = true;
    const qint64 before = m_rows.isEmpty() ? 0 : m_rows.last().id;
    m_records.store().run(
        this, [before](store::Database& database) { return AlarmLog::page(database, before); },
        [this, round = m_round](const tl::expected<QList<AlarmRow>, store::StoreError>& page) {
            if (round != m_round)
                return;
            if (!page)
                m_records.reportError(page.error());
            takePage(page.value_or(QList<AlarmRow>()));
        });
}

void AlarmHistory::takePage(const QList<AlarmRow>& page)
{
    m_isReading = false;
    m_isAtEnd = page.size() < AlarmLog::pageRows;
    if (!page.isEmpty()) {
        beginInsertRows({}, count(), count() + static_cast<int>(page.size()) - 1);
        m_rows += page;
        endInsertRows();
        emit countChanged();
    }
    if (!std::exchange(m_isLoaded, true))
        emit changed();
    for (const store::AlarmChanges& changes : std::exchange(m_meanwhile, {}))
        apply(changes);
}

void AlarmHistory::note(const store::AlarmChanges& changes)
{
    if (!m_isWatched)
        return;
    if (m_isReading)
        m_meanwhile.append(changes);
    if (m_isLoaded)
        apply(changes);
}

void AlarmHistory::apply(const store::AlarmChanges& changes)
{
    for (const AlarmRow& row : changes.rows)
        applyRow(row);
    for (const auto& given : changes.acknowledgements) {
        for (int at = rowFrom(given.upToId); at < count(); ++at) {
            AlarmRow& row = m_rows[at];
            if (row.code != given.code || !row.wantsAcknowledgement || row.acknowledgedMs > 0)
                continue;
            row.acknowledgedMs = given.atMs;
            row.acknowledgedBy = given.by;
            emit dataChanged(index(at), index(at));
        }
    }
}

void AlarmHistory::applyRow(const AlarmRow& row)
{
    const int at = rowFrom(row.id);
    if (at < count() && m_rows[at].id == row.id) {
        m_rows[at] = row;
        emit dataChanged(index(at), index(at));
        return;
    }
    if (at > 0 || (count() == 0 && !m_isAtEnd))
        return; // already deleted, or on a page that was not read yet
    beginInsertRows({}, 0, 0);
    m_rows.prepend(row);
    endInsertRows();
    if (count() > AlarmLog::capacity) {
        beginRemoveRows({}, count() - 1, count() - 1);
        m_rows.removeLast();
        endRemoveRows();
    }
    emit countChanged();
}

int AlarmHistory::rowFrom(qint64 id) const
{
    const auto found = std::ranges::lower_bound(m_rows, id, std::ranges::greater(), &AlarmRow::id);
    return static_cast<int>(found - m_rows.begin());
}

void AlarmHistory::retranslate()
{
    if (count() > 0)
        emit dataChanged(index(0), index(count() - 1));
}

int AlarmHistory::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant AlarmHistory::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    return AlarmWords::role(m_rows[index.row()], role, m_today());
}

QHash<int, QByteArray> AlarmHistory::roleNames() const
{
    return AlarmWords::roles();
}

bool AlarmHistory::canFetchMore(const QModelIndex& parent) const
{
    return !parent.isValid() && m_isLoaded && !m_isReading && !m_isAtEnd;
}

void AlarmHistory::fetchMore(const QModelIndex& parent)
{
    if (canFetchMore(parent))
        read();
}

} // namespace campanel::panel
