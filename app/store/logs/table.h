// SPDX-License-Identifier: Apache-2.0
// The table of a log. Each column is one row of a list: from it follow the table in the database with its
// steps from version to version, the statements that write and read it, its filter, and its CSV. Call it in
// the thread that owns the database.
#pragma once

#include "app/store/files/csv.h"
#include "app/store/logs/log_filter.h"

#include <algorithm>
#include <concepts>
#include <limits>
#include <ranges>
#include <type_traits>

namespace campanel::store {

// Writes a value of a column as a field of CSV.
using CsvForm = void (*)(CsvWriter& csv, const QVariant& value);
void csvPlain(CsvWriter& csv, const QVariant& value); // by its type; bytes as hexadecimal digits
void csvValue(CsvWriter& csv, const QVariant& value); // a text that may be a number
void csvUtc(CsvWriter& csv, const QVariant& value);
void csvClock(CsvWriter& csv, const QVariant& value);

// A member of a record as a value of SQL. It is made of a pointer to the member, or of a function that
// returns a reference to it.
template <typename Row> struct Member {
    template <std::invocable<Row&> At> Member(At at)
    {
        using Type = std::remove_reference_t<std::invoke_result_t<At, Row&>>;
        constexpr bool isText = std::is_same_v<Type, QString>;
        constexpr bool isBytes = std::is_same_v<Type, QByteArray>;
        type = isText ? "TEXT" : isBytes ? "BLOB" : std::is_floating_point_v<Type> ? "REAL" : "INTEGER";
        nothing = isText ? "''" : isBytes ? "x''" : "0";
        value = [at](const Row& row) {
            if constexpr (std::is_enum_v<Type>)
                return QVariant(static_cast<int>(std::invoke(at, row)));
            else
                return QVariant(std::invoke(at, row));
        };
        set = [at](Row& row, const QVariant& stored) {
            if constexpr (std::is_enum_v<Type>)
                std::invoke(at, row) = static_cast<Type>(stored.toInt());
            else
                std::invoke(at, row) = stored.value<Type>();
        };
    }

    QString type;    // in SQL
    QString nothing; // the value of earlier rows
    std::function<QVariant(const Row&)> value;
    std::function<void(Row&, const QVariant&)> set;
};

template <typename Row> struct Column {
    QString name;
    Member<Row> member;
    QString heading{};       // in CSV; empty: `name`
    CsvForm form = csvPlain; // null: it is not in CSV
    SoughtAs sought{};       // by a filter
    bool isOptional = false; // NULL instead of 0
    bool isFinal = false;    // stays as it was written first
    int since = 0;           // version of the schema that adds it; 0: that of the table
};

// The number of rows of a page.
inline constexpr int logPageRows = 200;

struct LogCsv {
    QByteArray bytes;
    bool isCut = false; // older rows are not in it
};

template <typename Row> class Table {
public:
    using Rows = tl::expected<QList<Row>, StoreError>;

    // `since` is the version of the schema that adds the table. The first column is the primary key.
    Table(QString name, int since, std::vector<Column<Row>> columns, QString options = {})
        : m_name(std::move(name))
        , m_since(since)
        , m_columns(std::move(columns))
        , m_options(std::move(options))
    {
        for (const Column<Row>& column : m_columns)
            m_sought << SoughtColumn{column.name, column.sought};
    }

    // Adds the statements that make the table to the steps of a schema.
    void addSteps(std::vector<QStringList>& steps) const
    {
        const auto step = [&steps](int version) -> QStringList& {
            steps.resize(std::max(steps.size(), static_cast<std::size_t>(version)));
            return steps[static_cast<std::size_t>(version) - 1];
        };
        QStringList first;
        for (const Column<Row>& column : m_columns | std::views::reverse) {
            if (column.since == 0)
                first.prepend(declarationOf(column));
            else
                step(column.since)
                    .prepend(
                        QStringLiteral("ALTER TABLE %1 ADD COLUMN %2").arg(m_name, declarationOf(column)));
        }
        step(m_since).prepend(QStringLiteral("CREATE TABLE %1 ( %2)%3")
                                  .arg(m_name, first.join(QStringLiteral(", ")), m_options));
    }

    [[nodiscard]] tl::expected<void, StoreError> insert(Database& database, const Row& row,
                                                        const QString& onConflict = {}) const
    {
        QVariantList values;
        QStringList names;
        for (const Column<Row>& column : m_columns) {
            const QVariant value = column.member.value(row);
            values << (column.isOptional && value == 0 ? QVariant() : value);
            names << column.name;
        }
        const QStringList marks(names.size(), QStringLiteral("?"));
        return database
            .execute(QStringLiteral("INSERT INTO %1 (%2) VALUES (%3) %4")
                         .arg(m_name, names.join(QLatin1Char(',')), marks.join(QLatin1Char(',')), onConflict),
                     values)
            .map([](const auto&) {});
    }

    // Inserts a row, or updates the row with its key where `condition` holds ("WHERE ...").
    [[nodiscard]] tl::expected<void, StoreError> write(Database& database, const Row& row,
                                                       const QString& condition = {}) const
    {
        QStringList updates;
        for (const Column<Row>& column : m_columns) {
            if (!column.isFinal && column.name != key())
                updates << QStringLiteral("%1 = excluded.%1").arg(column.name);
        }
        return insert(database, row,
                      QStringLiteral("ON CONFLICT (%1) DO UPDATE SET %2 %3")
                          .arg(key(), updates.join(QStringLiteral(", ")), condition));
    }

    // Reads the rows of a query; `rest` follows the name of the table. A file that was opened read-only may
    // lack the newest columns.
    [[nodiscard]] Rows read(Database& database, const QString& rest = {},
                            const QVariantList& values = {}) const
    {
        const auto version = database.version();
        if (!version)
            return tl::unexpected(version.error());
        QStringList names;
        for (const Column<Row>& column : m_columns)
            names << (column.since <= *version ? column.name : column.member.nothing);
        auto found = database.execute(
            QStringLiteral("SELECT %1 FROM %2 %3").arg(names.join(QStringLiteral(", ")), m_name, rest),
            values);
        if (!found)
            return tl::unexpected(found.error());
        QList<Row> rows;
        while (found->next())
            rows << rowOf(*found);
        return database.stepped(*found).map([&rows] { return rows; });
    }

    // Returns the rows of the filter with a key below `before`, newest first; 0: the newest ones.
    [[nodiscard]] Rows page(Database& database, qint64 before = 0, int maxRows = logPageRows,
                            const LogFilter& filter = {}) const
    {
        const auto range = rangeOf(database, filter, m_name, key(), timeName());
        if (!range)
            return tl::unexpected(range.error());
        const Condition condition = conditionOf(filter, m_sought);
        const qint64 end = before != 0 ? before : std::numeric_limits<qint64>::max();
        return read(database,
                    QStringLiteral("WHERE %1 < ? AND %1 BETWEEN ? AND ?%2 ORDER BY %1 DESC LIMIT ?")
                        .arg(key(), condition.sql),
                    QVariantList{end, range->firstId, range->lastId} + condition.values +
                        QVariantList{maxRows});
    }

    // Returns true for the rows that page() returns.
    [[nodiscard]] bool includes(const LogFilter& filter, const Row& row) const
    {
        QVariantList values;
        for (const Column<Row>& column : m_columns)
            values << column.member.value(row);
        return store::includes(filter, m_sought, values);
    }

    [[nodiscard]] qint64 keyOf(const Row& row) const { return m_columns[0].member.value(row).toLongLong(); }

    [[nodiscard]] CsvColumns<Row> csvColumns() const
    {
        CsvColumns<Row> columns;
        for (const Column<Row>& column : m_columns) {
            if (column.form)
                columns.push_back({column.heading.isEmpty() ? column.name : column.heading,
                                   [form = column.form, value = column.member.value](
                                       CsvWriter& csv, const Row& row) { form(csv, value(row)); }});
        }
        return columns;
    }

    // Returns the newest `maxRows` rows of the filter as CSV, newest first. It reads by pages.
    [[nodiscard]] tl::expected<LogCsv, StoreError>
    csv(Database& database, const LogFilter& filter, const CsvDialect& dialect = {},
        qint64 maxRows = std::numeric_limits<qint64>::max()) const
    {
        CsvTable<Row> csv(csvColumns(), dialect);
        qint64 before = 0;
        for (qint64 left = maxRows;;) {
            const Rows rows = page(database, before, csvPageRows, filter);
            if (!rows)
                return tl::unexpected(rows.error());
            for (const Row& row : rows->first(std::min<qint64>(rows->size(), left)))
                csv.add(row);
            if (rows->isEmpty() || rows->size() > left)
                return LogCsv{csv.bytes(), !rows->isEmpty()};
            left -= rows->size();
            before = keyOf(rows->last());
        }
    }

private:
    static constexpr int csvPageRows = 1000;

    [[nodiscard]] const QString& key() const { return m_columns[0].name; }

    [[nodiscard]] QString timeName() const
    {
        const auto found = std::ranges::find_if(
            m_columns, [](const Column<Row>& column) { return column.sought.testFlag(Sought::Time); });
        return found == m_columns.end() ? key() : found->name;
    }

    [[nodiscard]] QString declarationOf(const Column<Row>& column) const
    {
        QString text = column.name + QLatin1Char(' ') + column.member.type;
        if (column.name == key())
            return text + QStringLiteral(" PRIMARY KEY");
        if (!column.isOptional)
            text += QStringLiteral(" NOT NULL");
        if (column.since > 0 && !column.isOptional)
            text += QStringLiteral(" DEFAULT ") + column.member.nothing;
        return text;
    }

    [[nodiscard]] Row rowOf(const QSqlQuery& query) const
    {
        Row row;
        for (std::size_t at = 0; at < m_columns.size(); ++at)
            m_columns[at].member.set(row, query.value(static_cast<int>(at)));
        return row;
    }

    QString m_name;
    int m_since;
    std::vector<Column<Row>> m_columns;
    QString m_options; // behind the columns
    QList<SoughtColumn> m_sought;
};

} // namespace campanel::store
