// SPDX-License-Identifier: Apache-2.0
#include "profile/cam/csv_writer.h"

#include <array>
#include <charconv>
#include <utility>

namespace campanel::profile {
namespace {

// The longest double in fixed notation, its sign and the decimals of a table.
constexpr std::size_t longestNumber = 384;
using Buffer = std::array<char, longestNumber>;

template <typename... Format> std::string_view digitsOf(Buffer& buffer, double value, Format... format)
{
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
    return {buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data())};
}

} // namespace

CsvWriter::CsvWriter(const CsvDialect& dialect)
    : m_dialect(dialect)
    , m_text(dialect.hasByteOrderMark ? "\xEF\xBB\xBF" : "")
{
}

void CsvWriter::beginField()
{
    if (std::exchange(m_isLineBegun, true))
        m_text.push_back(m_dialect.separator);
}

void CsvWriter::add(std::string_view field)
{
    beginField();
    // Both separators: a spreadsheet may expect the other one.
    if (field.find_first_of(",;\t\"\r\n") == std::string_view::npos) {
        m_text.append(field);
        return;
    }
    m_text.push_back('"');
    for (const char c : field)
        m_text.append(c == '"' ? 2 : 1, c);
    m_text.push_back('"');
}

void CsvWriter::addDigits(std::string_view digits)
{
    beginField();
    for (const char c : digits)
        m_text.push_back(c == '.' ? m_dialect.decimalSign : c);
}

void CsvWriter::addNumber(double value)
{
    Buffer buffer;
    addDigits(digitsOf(buffer, value, std::chars_format::fixed));
}

void CsvWriter::addFixed(double value, int decimals)
{
    Buffer buffer;
    addDigits(digitsOf(buffer, value, std::chars_format::fixed, decimals));
}

void CsvWriter::addSignificant(double value, int digits)
{
    Buffer buffer;
    addDigits(digitsOf(buffer, value, std::chars_format::general, digits));
}

void CsvWriter::addWhole(std::int64_t value)
{
    addDigits(std::to_string(value));
}

void CsvWriter::endLine()
{
    m_text.push_back('\n');
    m_isLineBegun = false;
}

} // namespace campanel::profile
