// SPDX-License-Identifier: Apache-2.0
#include "app/panel/alarms/alarm_history.h"

#include "app/panel/records/database_service.h"
#include "app/store/logs/alarm_log.h"

#include <QPointer>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::panel {

using store::AlarmLog;
using store::AlarmRow;

AlarmHistory::AlarmHistory(DatabaseService& records, QObject* parent)
    : QObject(parent)
    , m_records(records)
{
    connect(&m_rows, &AlarmList::moreRequested, this, &AlarmHistory::read);
    connect(&m_filter, &LogFilterEditor::changed, this, [this] {
        if (m_readFilter != logFilter())
            restart();
    });
}

void AlarmHistory::setToday(const QDate& today)
{
    if (m_today == today)
        return;
    m_today = today;
    QList<AlarmListRow> rows = m_rows.rows();
    for (AlarmListRow& row : rows)
        row.today = today;
    m_rows.setRows(rows);
}

void AlarmHistory::setWatched(bool isWatched)
{
    if (m_isWatched == isWatched)
        return;
    m_isWatched = isWatched;
    restart();
}

store::LogFilter AlarmHistory::logFilter() const
{
    store::LogFilter filter = m_filter.filter();
    filter.keysOfWord = AlarmWords::codesWith(filter.word);
    return filter;
}

void AlarmHistory::restart()
{
    ++m_round;
    m_readFilter = logFilter();
    m_isLoaded = m_isReading = m_isAtEnd = false;
    m_meanwhile.clear();
    m_rows.setHasMore(false);
    m_rows.clear();
    if (m_isWatched)
        read();
    emit changed();
}

void AlarmHistory::read()
{
    m_isReading = true;
    m_rows.setHasMore(false);
    const qint64 before = m_rows.count() == 0 ? 0 : m_rows.rows().last().id();
    m_records.store().run(
        this,
        [before, filter = m_readFilter](store::Database& database) {
            return store::alarmTable().page(database, before, store::logPageRows, filter);
        },
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
    m_isAtEnd = page.size() < store::logPageRows;
    m_rows.setHasMore(!m_isAtEnd);
    QList<AlarmListRow> rows;
    for (const AlarmRow& row : page)
        rows << AlarmListRow{row, m_today};
    m_rows.append(rows);
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
        for (int at = rowFrom(given.upToId); at < m_rows.count(); ++at) {
            AlarmRow row = m_rows.row(at).alarm;
            if (row.code != given.code || !row.wantsAcknowledgement || row.acknowledgedMs > 0)
                continue;
            row.acknowledgedMs = given.atMs;
            row.acknowledgedBy = given.by;
            m_rows.setRow(at, {row, m_today});
        }
    }
}

void AlarmHistory::applyRow(const AlarmRow& row)
{
    const int at = rowFrom(row.id);
    if (at < m_rows.count() && m_rows.row(at).id() == row.id) {
        m_rows.setRow(at, {row, m_today});
        return;
    }
    if (at > 0 || (m_rows.count() == 0 && !m_isAtEnd) || !store::alarmTable().includes(m_readFilter, row))
        return; // already deleted, on a page that was not read yet, or filtered
    m_rows.insert(0, {{row, m_today}});
    m_rows.remove(AlarmLog::capacity, m_rows.count() - AlarmLog::capacity);
}

void AlarmHistory::exportCsv(ReportFiles* files)
{
    if (!files || std::exchange(m_isExporting, true))
        return;
    emit changed();
    m_records.store().run(
        this,
        [filter = logFilter(), dialect = store::spreadsheetDialect()](store::Database& database) {
            return store::alarmTable().csv(database, filter, dialect);
        },
        [this, files = QPointer(files)](const tl::expected<store::LogCsv, store::StoreError>& csv) {
            m_isExporting = false;
            emit changed();
            if (!csv) {
                m_records.reportError(csv.error());
            } else if (files) {
                files->offer({{tr("alarms"), u"csv"_s, [text = csv->bytes] { return text; }}});
                emit exportReady();
            }
        });
}

int AlarmHistory::rowFrom(qint64 id) const
{
    const auto& rows = m_rows.rows();
    const auto found = std::ranges::lower_bound(rows, id, std::ranges::greater(), &AlarmListRow::id);
    return static_cast<int>(found - rows.begin());
}

} // namespace campanel::panel
