// SPDX-License-Identifier: Apache-2.0
#include "app/panel/alarms/alarm_detail.h"

#include "app/panel/words/alarm_words.h"

using namespace Qt::StringLiterals;

namespace campanel::panel {

using store::AlarmRow;

void AlarmDetail::show(const AlarmRow& row, const AlarmBook& book, const QDate& today)
{
    m_row = row;
    update(book, today);
}

void AlarmDetail::update(const AlarmBook& book, const QDate& today)
{
    m_today = today;
    m_isShelved = book.isShelved(m_row.code);
    if (const AlarmEntry* entry = book.entryWith(m_row.id))
        m_row = entry->row;
    emit changed();
}

void AlarmDetail::noteAcknowledged(qint64 utcMs, const QString& by)
{
    m_row.acknowledgedMs = utcMs;
    m_row.acknowledgedBy = by;
    emit changed();
}

QString AlarmDetail::title() const
{
    return AlarmWords::title(m_row.code);
}

int AlarmDetail::severity() const
{
    return static_cast<int>(AlarmWords::severity(m_row.code));
}

QString AlarmDetail::severityText() const
{
    switch (AlarmWords::severity(m_row.code)) {
    case AlarmSeverity::Fault:
        return tr("Fault");
    case AlarmSeverity::Warning:
        return tr("Warning");
    case AlarmSeverity::Notice:
        return tr("Notice");
    case AlarmSeverity::None:
        break;
    }
    return {};
}

QString AlarmDetail::stateText() const
{
    return AlarmWords::state(m_row);
}

QString AlarmDetail::cause() const
{
    return kind() ? kind()->cause() : tr("This alarm was logged by a newer panel version.");
}

QString AlarmDetail::action() const
{
    return kind() ? kind()->action() : QString();
}

QString AlarmDetail::raisedText() const
{
    const QString time = AlarmWords::time(m_row.raisedMs, m_today);
    return m_row.isClockDoubtful ? u"%1 · %2"_s.arg(time, AlarmWords::clockNote(true)) : time;
}

QString AlarmDetail::returnedText() const
{
    switch (m_row.end) {
    case AlarmRow::End::Active:
        return tr("still active");
    case AlarmRow::End::Returned:
        return AlarmWords::time(m_row.returnedMs, m_today);
    case AlarmRow::End::Unknown:
        break;
    }
    return tr("unknown: the panel was off or the controller was changed");
}

QString AlarmDetail::acknowledgedText() const
{
    if (m_row.acknowledgedMs == 0)
        return m_row.wantsAcknowledgement ? tr("not yet") : tr("not required");
    const QString time = AlarmWords::time(m_row.acknowledgedMs, m_today);
    return m_row.acknowledgedBy.isEmpty() ? time
                                          : tr("%1 by %2", "time, person").arg(time, m_row.acknowledgedBy);
}

bool AlarmDetail::shelvable() const
{
    return kind() && !kind()->stopsMachine;
}

} // namespace campanel::panel
