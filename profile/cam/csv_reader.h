// SPDX-License-Identifier: Apache-2.0
// Reads CSV text with one known header, as people and spreadsheets write it: the knots and the segments of
// cams. The header determines the separator, the first fractional number the decimal sign. Quotation marks,
// empty rows, empty columns at the end and any kind of line end are allowed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

enum class CsvExpectation : std::uint8_t {
    Header,       // the columns of the header, with comma, semicolon or tabulator
    Values,       // a value for each column, with the separator of the header
    Number,       // a finite number
    DecimalPoint, // the decimal sign of the earlier numbers, a point
    DecimalComma, // the decimal sign of the earlier numbers, a comma
    Rows,         // at least one line of values
    Utf8,         // UTF-8 text; the file is UTF-16 or not text
    Motion,       // the key of a segment's motion
};

struct CsvError {
    int line = 1; // from 1
    CsvExpectation expected = CsvExpectation::Header;
    std::string found; // the line or the field as read, at most 40 bytes; '?' for control characters

    bool operator==(const CsvError&) const = default;
};

// Returns the line, from 1, of row `index` behind the header; that of the last row when there are fewer.
[[nodiscard]] int csvLineOfRow(std::string_view text, std::size_t index);

namespace detail {

class CsvReader {
public:
    explicit CsvReader(std::string_view text);

    // Reads the header. A row needs `minColumns` fields; 0: all. A spreadsheet may leave out empty ones.
    [[nodiscard]] tl::expected<void, CsvError> readHeader(std::span<const std::string_view> columns,
                                                          std::size_t minColumns = 0);
    // Reads the next row that is not empty, as one field for each column. Nothing at the end.
    [[nodiscard]] tl::expected<std::optional<std::vector<std::string_view>>, CsvError> readRow();
    [[nodiscard]] tl::expected<double, CsvError> number(std::string_view field);
    [[nodiscard]] tl::unexpected<CsvError> fail(CsvExpectation expected, std::string_view found) const;
    // Returns the line that was read last, from 1.
    [[nodiscard]] int line() const { return m_line; }

private:
    std::optional<std::string_view> nextLine();

    std::string_view m_rest;
    std::size_t m_columns = 0;
    std::size_t m_minColumns = 0;
    int m_line = 0;
    char m_separator = ',';
    char m_decimalSign = 0; // unknown yet
};

} // namespace detail
} // namespace campanel::profile
