// SPDX-License-Identifier: Apache-2.0
// Writes CSV text (RFC 4180) of numbers and of words of the program. Texts from elsewhere need
// app/store/files/csv.h. Lines end with a line feed alone.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace campanel::profile {

// The signs of a file. The default is read by programs; spreadsheets of some languages need others.
struct CsvDialect {
    char separator = ',';
    char decimalSign = '.';
    bool hasByteOrderMark = false; // spreadsheets then know UTF-8

    bool operator==(const CsvDialect&) const = default;
};

class CsvWriter {
public:
    explicit CsvWriter(const CsvDialect& dialect = {});

    // Adds a field, in quotation marks when they are necessary.
    void add(std::string_view field);
    // Adds the shortest number that reads back exactly, without an exponent.
    void addNumber(double value);
    // Adds a number with this many decimals, or with up to this many significant digits.
    void addFixed(double value, int decimals);
    void addSignificant(double value, int digits);
    void addWhole(std::int64_t value);
    // Adds a number that is text already, with a decimal point.
    void addDigits(std::string_view digits);
    void endLine();

    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    void beginField();

    CsvDialect m_dialect;
    std::string m_text;
    bool m_isLineBegun = false;
};

} // namespace campanel::profile
