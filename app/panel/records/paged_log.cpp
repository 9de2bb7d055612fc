// SPDX-License-Identifier: Apache-2.0
#include "app/panel/records/paged_log.h"

namespace campanel::panel {

PagedLogBase::PagedLogBase(DatabaseService& records, Complete complete, QObject* parent)
    : Watched(parent)
    , m_records(records)
    , m_complete(std::move(complete))
    , m_csv(
          records.store(),
          [this] {
              return csvJob(
                  wantedFilter(),
                  tr("Only the newest %1 rows are exported. Set a time by the filter for older ones.")
                      .arg(maxExported));
          },
          [&records](const store::StoreError& error) { records.reportError(error); }, this)
{
    connect(this, &Watched::watchedChanged, this, &PagedLogBase::restart);
    connect(&m_editor, &LogFilterEditor::changed, this, [this] {
        if (watched() && m_filter != wantedFilter())
            restart();
    });
}

store::LogFilter PagedLogBase::wantedFilter() const
{
    store::LogFilter filter = m_editor.filter();
    m_complete(filter);
    return filter;
}

void PagedLogBase::restart()
{
    ++m_round;
    m_filter = wantedFilter();
    m_isLoaded = m_isReading = m_isAtEnd = false;
    m_meanwhile.clear();
    list()->setHasMore(false);
    clear();
    if (watched())
        read();
    emit changed();
}

void PagedLogBase::beginPage()
{
    m_isReading = true;
    list()->setHasMore(false);
}

void PagedLogBase::endPage(bool isLast)
{
    m_isReading = false;
    m_isAtEnd = isLast;
    list()->setHasMore(!isLast);
    if (!std::exchange(m_isLoaded, true))
        emit changed();
    for (const auto& change : std::exchange(m_meanwhile, {}))
        change();
}

void PagedLogBase::apply(const std::function<void()>& change)
{
    if (m_isReading)
        m_meanwhile << change;
    if (m_isLoaded)
        change();
}

CsvExport::Files PagedLogBase::filesOf(const QString& name, const QString& cutNotice,
                                       const store::LogCsv& csv)
{
    return {{csvFile(name, csv.bytes)}, csv.isCut ? cutNotice : QString()};
}

} // namespace campanel::panel
