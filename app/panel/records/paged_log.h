// SPDX-License-Identifier: Apache-2.0
// A log of the database as a list for QML, newest first: it is read page by page while it is watched, through
// a filter; rows that are written meanwhile appear at once; and its export as CSV.
#pragma once

#include "app/panel/kit/log_filter_editor.h"
#include "app/panel/kit/row_model.h"
#include "app/panel/kit/watched.h"
#include "app/panel/records/csv_export.h"
#include "app/panel/records/database_service.h"
#include "app/store/logs/table.h"

#include <functional>
#include <utility>

namespace campanel::panel {

class PagedLogBase : public campanel::panel::Watched {
    Q_OBJECT
    QML_NAMED_ELEMENT(PagedLog)
    QML_UNCREATABLE("Logs belong to the objects that record them")
    // True until the first page has arrived.
    Q_PROPERTY(bool loading READ loading NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ list CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::LogFilterEditor* filter READ filter CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::CsvExport* csv READ csv CONSTANT FINAL)

public:
    // The maximum number of rows in a CSV file; the newest ones are exported.
    static constexpr int maxExported = 100'000;

    [[nodiscard]] bool loading() const { return watched() && !m_isLoaded; }
    [[nodiscard]] virtual RowModelBase* list() = 0;
    [[nodiscard]] LogFilterEditor* filter() { return &m_editor; }
    [[nodiscard]] CsvExport* csv() { return &m_csv; }

    // Reads the newest rows of the present filter.
    void restart();

signals:
    void changed();

protected:
    // Adds to the filter what its editor does not know: the keys of its word, a person.
    using Complete = std::function<void(store::LogFilter&)>;

    PagedLogBase(DatabaseService& records, Complete complete, QObject* parent);

    // Applies a change of the records that is written now or soon: at once, and again after a page that is
    // being read, which may not contain it.
    void apply(const std::function<void()>& change);
    void beginPage();
    void endPage(bool isLast);
    [[nodiscard]] static CsvExport::Files filesOf(const QString& name, const QString& cutNotice,
                                                  const store::LogCsv& csv);

    [[nodiscard]] DatabaseService& records() { return m_records; }
    [[nodiscard]] const store::LogFilter& readFilter() const { return m_filter; } // of the rows
    [[nodiscard]] quint32 round() const { return m_round; } // discards pages of an earlier request
    [[nodiscard]] bool isAtEnd() const { return m_isAtEnd; }

private:
    [[nodiscard]] store::LogFilter wantedFilter() const;
    virtual void clear() = 0;
    virtual void read() = 0;
    [[nodiscard]] virtual CsvExport::Job csvJob(const store::LogFilter& filter, const QString& cutNotice) = 0;

    DatabaseService& m_records;
    Complete m_complete;
    LogFilterEditor m_editor{this};
    CsvExport m_csv;
    store::LogFilter m_filter;
    QList<std::function<void()>> m_meanwhile; // changes while a page is being read
    quint32 m_round = 0;
    bool m_isLoaded = false;
    bool m_isReading = false;
    bool m_isAtEnd = false;
};

// `Model` is a RowModel; `record` is the member of its rows with the row of the log.
template <class Model, auto record> class PagedLog : public PagedLogBase {
public:
    using ListRow = std::decay_t<decltype(std::declval<const Model&>().row(0))>;
    using Row = std::decay_t<std::invoke_result_t<decltype(record), const ListRow&>>;

    struct Source {
        const store::Table<Row>& table; // of static duration
        std::function<ListRow(const Row&)> listRow;
        Complete complete;
        std::function<QString()> fileName; // translated
    };

    // The records must outlive the object.
    PagedLog(DatabaseService& records, Source source, QObject* parent)
        : PagedLogBase(records, source.complete, parent)
        , m_source(std::move(source))
    {
        connect(&m_rows, &RowModelBase::moreRequested, this, &PagedLog::read);
    }

    [[nodiscard]] Model* rows() { return &m_rows; } // descending keys
    [[nodiscard]] RowModelBase* list() override { return &m_rows; }

    // Adds a row that was written after all others.
    void add(const Row& row)
    {
        apply([this, row] { put(row); });
    }

protected:
    // Adds or replaces a row in the list.
    void put(const Row& row)
    {
        const qint64 key = m_source.table.keyOf(row);
        const int at = rowFrom(key);
        if (at < m_rows.count() && keyAt(at) == key) {
            m_rows.setRow(at, m_source.listRow(row));
            return;
        }
        if (at > 0 || (m_rows.count() == 0 && !isAtEnd()) || !m_source.table.includes(readFilter(), row))
            return; // already deleted, on a page that was not read yet, or filtered
        m_rows.insert(0, {m_source.listRow(row)});
    }

    // Returns the first row of the list with this key or a lower one.
    [[nodiscard]] int rowFrom(qint64 key) const
    {
        const auto& rows = m_rows.rows();
        const auto found =
            std::ranges::lower_bound(rows, key, std::ranges::greater(), [this](const ListRow& row) {
                return m_source.table.keyOf(std::invoke(record, row));
            });
        return static_cast<int>(found - rows.begin());
    }

private:
    [[nodiscard]] qint64 keyAt(int at) const
    {
        return m_source.table.keyOf(std::invoke(record, m_rows.row(at)));
    }

    void clear() override { m_rows.clear(); }

    void read() override
    {
        beginPage();
        const qint64 before = m_rows.count() == 0 ? 0 : keyAt(m_rows.count() - 1);
        records().store().run(
            this,
            [&table = m_source.table, before, filter = readFilter()](store::Database& database) {
                return table.page(database, before, store::logPageRows, filter);
            },
            [this, asked = round()](const typename store::Table<Row>::Rows& page) {
                if (asked == round())
                    take(page);
            });
    }

    void take(const typename store::Table<Row>::Rows& page)
    {
        if (!page)
            records().reportError(page.error());
        QList<ListRow> rows;
        for (const Row& row : page.value_or(QList<Row>()))
            rows << m_source.listRow(row);
        m_rows.append(rows);
        endPage(rows.size() < store::logPageRows);
    }

    [[nodiscard]] CsvExport::Job csvJob(const store::LogFilter& filter, const QString& cutNotice) override
    {
        return [&table = m_source.table, filter, name = m_source.fileName(),
                cutNotice](store::Database& database, const store::CsvDialect& dialect) {
            return table.csv(database, filter, dialect, maxExported).map([&](const store::LogCsv& csv) {
                return filesOf(name, cutNotice, csv);
            });
        };
    }

    Source m_source;
    Model m_rows{this};
};

} // namespace campanel::panel
