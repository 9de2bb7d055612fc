// SPDX-License-Identifier: Apache-2.0
// The export of a log as CSV: makes the files in the thread of their database and offers them to the report
// files. One export at a time.
#pragma once

#include "app/panel/kit/report_files.h"
#include "app/store/files/csv.h"
#include "app/store/store_thread.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class CsvExport : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Exports belong to their logs")
    // True while the files are made; then ready() follows.
    Q_PROPERTY(bool busy READ busy NOTIFY busyChanged FINAL)

public:
    struct Files {
        QList<ReportFile> files;
        QString notice{}; // what they lack; see ReportFiles::offer()
    };
    using Made = tl::expected<Files, store::StoreError>;
    // Makes the files; called in the thread of the database.
    using Job = std::function<Made(store::Database&, const store::CsvDialect&)>;
    using ReportError = std::function<void(const store::StoreError&)>;

    // `prepare` returns the job of an export; it is called in the thread of the panel, where the texts are
    // translated. The store must outlive the object.
    CsvExport(store::StoreThread& store, std::function<Job()> prepare, ReportError reportError,
              QObject* parent);

    [[nodiscard]] bool busy() const { return m_isBusy; }

    // Makes the files and offers them to `files`.
    Q_INVOKABLE void make(campanel::panel::ReportFiles* files);

signals:
    void busyChanged();
    void ready();

private:
    store::StoreThread& m_store;
    std::function<Job()> m_prepare;
    ReportError m_reportError;
    bool m_isBusy = false;
};

} // namespace campanel::panel
