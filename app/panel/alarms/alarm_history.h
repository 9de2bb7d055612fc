// SPDX-License-Identifier: Apache-2.0
// The log of alarms, newest first. It is read page by page while it is watched; new entries appear
// at once.
#pragma once

#include "app/panel/alarms/alarm_lists.h"
#include "app/panel/kit/log_filter_editor.h"
#include "app/panel/kit/report_files.h"

namespace campanel::panel {

class DatabaseService;

class AlarmHistory : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The lists belong to Alarms")
    // True while the list is displayed; only then it reads and stores rows.
    Q_PROPERTY(bool watched READ watched WRITE setWatched NOTIFY changed FINAL)
    // True until the first page has arrived.
    Q_PROPERTY(bool loading READ loading NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::LogFilterEditor* filter READ filter CONSTANT FINAL)
    Q_PROPERTY(bool exporting READ exporting NOTIFY changed FINAL)

public:
    // The records must outlive the object.
    AlarmHistory(DatabaseService& records, QObject* parent);

    [[nodiscard]] bool watched() const { return m_isWatched; }
    void setWatched(bool isWatched);
    [[nodiscard]] bool loading() const { return m_isWatched && !m_isLoaded; }
    [[nodiscard]] AlarmList* rows() { return &m_rows; }
    [[nodiscard]] LogFilterEditor* filter() { return &m_filter; }
    [[nodiscard]] bool exporting() const { return m_isExporting; }
    // Reads the filtered rows and offers them as CSV to `files`; exportReady() follows.
    Q_INVOKABLE void exportCsv(campanel::panel::ReportFiles* files);

    void setToday(const QDate& today);
    // Adds changes that are about to be written after all earlier ones.
    void note(const store::AlarmChanges& changes);

signals:
    void changed();
    void exportReady();

private:
    void restart();
    [[nodiscard]] store::LogFilter logFilter() const;
    void read();
    void takePage(const QList<store::AlarmRow>& page);
    void apply(const store::AlarmChanges& changes);
    void applyRow(const store::AlarmRow& row);
    // Returns the row of the first entry with this id or an older one.
    [[nodiscard]] int rowFrom(qint64 id) const;

    DatabaseService& m_records;
    LogFilterEditor m_filter{this};
    store::LogFilter m_readFilter; // of the rows
    QDate m_today = QDate::currentDate();
    AlarmList m_rows{this};                 // descending ids
    QList<store::AlarmChanges> m_meanwhile; // received while a page is being read, which may not contain them
    quint32 m_round = 0;                    // discards pages of an earlier request
    bool m_isWatched = false;
    bool m_isLoaded = false;
    bool m_isReading = false;
    bool m_isExporting = false;
    bool m_isAtEnd = false;
};

} // namespace campanel::panel
