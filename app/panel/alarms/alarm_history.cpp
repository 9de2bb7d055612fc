// SPDX-License-Identifier: Apache-2.0
#include "app/panel/alarms/alarm_history.h"

#include <QCoreApplication>

namespace campanel::panel {

using store::AlarmChanges;
using store::AlarmRow;

AlarmHistory::AlarmHistory(DatabaseService& records, QObject* parent)
    : PagedLog(records,
               {store::alarmTable(),
                [this](const AlarmRow& row) {
                    return AlarmListRow{row, m_today};
                },
                [](store::LogFilter& filter) { filter.keysOfWord = AlarmWords::codesWith(filter.word); },
                [] { return QCoreApplication::translate("campanel::panel::AlarmHistory", "alarms"); }},
               parent)
{
}

void AlarmHistory::setToday(const QDate& today)
{
    if (m_today == today)
        return;
    m_today = today;
    QList<AlarmListRow> updated = rows()->rows();
    for (AlarmListRow& row : updated)
        row.today = today;
    rows()->setRows(updated);
}

void AlarmHistory::note(const AlarmChanges& changes)
{
    apply([this, changes] {
        for (const AlarmRow& row : changes.rows)
            put(row);
        for (const auto& given : changes.acknowledgements)
            applyAcknowledgement(given);
        rows()->remove(store::AlarmLog::capacity, rows()->count() - store::AlarmLog::capacity);
    });
}

void AlarmHistory::applyAcknowledgement(const AlarmChanges::Acknowledgement& given)
{
    for (int at = rowFrom(given.upToId); at < rows()->count(); ++at) {
        AlarmRow row = rows()->row(at).alarm;
        if (row.code != given.code || !row.wantsAcknowledgement || row.acknowledgedMs > 0)
            continue;
        row.acknowledgedMs = given.atMs;
        row.acknowledgedBy = given.by;
        rows()->setRow(at, {row, m_today});
    }
}

} // namespace campanel::panel
