// SPDX-License-Identifier: Apache-2.0
// The writer of CSV files in app/. Texts come from files, scanners and networks: no cell can become a formula
// of a spreadsheet, and each is one line of visible characters.
#pragma once

#include "profile/cam/csv_writer.h"

#include <QByteArray>
#include <QLocale>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

namespace campanel::store {

using profile::CsvDialect;

// Returns the dialect that spreadsheets of this language open: a semicolon where the comma is the decimal
// sign.
[[nodiscard]] CsvDialect spreadsheetDialect(const QLocale& locale = QLocale());

class CsvWriter {
public:
    // Begins with the header, names with commas between them.
    CsvWriter(QStringView header, const CsvDialect& dialect);

    // Adds a text. An apostrophe comes before a text that a spreadsheet takes as a formula, also behind a
    // separator inside the text. It is one line, as from oneLine().
    CsvWriter& text(const QString& text);
    // Adds a text that may be a number, such as a value before a change: a number stays one.
    CsvWriter& value(const QString& text);
    CsvWriter& number(double value, int decimals);
    CsvWriter& number(const std::optional<double>& value, int decimals); // unknown: empty
    // Adds a number with up to 10 significant digits.
    CsvWriter& significant(double value);
    CsvWriter& whole(qint64 value);
    CsvWriter& empty();
    // Adds a time since 1970 UTC as "2026-01-15T14:07:00.000Z"; nothing for 0.
    CsvWriter& utc(qint64 timeMs);
    // Adds two fields, UTC and local: "2026-01-15T14:07:00.000Z", "2026-01-15T15:07:00.000+01:00".
    CsvWriter& utcAndLocal(qint64 timeMs);
    // Adds the field "clock" of a record.
    CsvWriter& clock(bool isDoubtful);
    CsvWriter& yesOrNo(bool isTrue);
    void endLine();

    [[nodiscard]] qint64 rows() const { return m_rows; } // below the header
    [[nodiscard]] QByteArray bytes() const { return QByteArray::fromStdString(m_csv.text()); }

private:
    profile::CsvWriter m_csv;
    qint64 m_rows = -1;
};

// A column of a CSV file: its heading, and its field of a row. A column of several fields has their names
// with commas between them.
template <typename Row> struct CsvColumn {
    QString heading;
    std::function<void(CsvWriter&, const Row&)> write;
};

template <typename Row> using CsvColumns = std::vector<CsvColumn<Row>>;

// A CSV file of rows with these columns.
template <typename Row> class CsvTable {
public:
    explicit CsvTable(CsvColumns<Row> columns, const CsvDialect& dialect = {})
        : m_columns(std::move(columns))
        , m_csv(headerOf(m_columns), dialect)
    {
    }

    void add(const Row& row)
    {
        for (const CsvColumn<Row>& column : m_columns)
            column.write(m_csv, row);
        m_csv.endLine();
    }
    [[nodiscard]] QByteArray bytes() const { return m_csv.bytes(); }

private:
    [[nodiscard]] static QString headerOf(const CsvColumns<Row>& columns)
    {
        QStringList headings;
        for (const CsvColumn<Row>& column : columns)
            headings << column.heading;
        return headings.join(QLatin1Char(','));
    }

    CsvColumns<Row> m_columns;
    CsvWriter m_csv;
};

} // namespace campanel::store
