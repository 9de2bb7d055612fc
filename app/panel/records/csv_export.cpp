// SPDX-License-Identifier: Apache-2.0
#include "app/panel/records/csv_export.h"

#include <utility>

namespace campanel::panel {

CsvExport::CsvExport(store::StoreThread& store, std::function<Job()> prepare, ReportError reportError,
                     QObject* parent)
    : QObject(parent)
    , m_store(store)
    , m_prepare(std::move(prepare))
    , m_reportError(std::move(reportError))
{
}

void CsvExport::make(ReportFiles* files)
{
    if (!files || std::exchange(m_isBusy, true))
        return;
    emit busyChanged();
    m_store.run(
        this,
        [job = m_prepare(), dialect = store::spreadsheetDialect()](store::Database& database) {
            return job(database, dialect);
        },
        [this, files = QPointer(files)](const Made& made) {
            m_isBusy = false;
            emit busyChanged();
            if (!made)
                return m_reportError(made.error());
            if (!files)
                return;
            files->offer(made->files, made->notice);
            emit ready();
        });
}

} // namespace campanel::panel
