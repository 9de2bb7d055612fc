// SPDX-License-Identifier: Apache-2.0
#include "profile/cam/csv_reader.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace campanel::profile::detail {
namespace {

// The longest double in fixed notation and its sign.
constexpr std::size_t longestNumber = 352;
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Returns the length of the quoted field at the begin of the text, with both marks; 0: it has none, or is not
// closed before the separator or the end.
std::size_t quotedLength(std::string_view text, char separator)
{
    if (!text.starts_with('"'))
        return 0;
    std::size_t end = text.find('"', 1);
    while (end != std::string_view::npos && text.substr(end + 1).starts_with('"')) // a doubled mark
        end = text.find('"', end + 2);
    if (end == std::string_view::npos)
        return 0;
    const std::string_view behind = trimmed(text.substr(end + 1, text.find(separator, end) - end - 1));
    return behind.empty() ? end + 1 : 0;
}

// A field is a part of the line. Doubled marks stay: no number and no key has one.
std::vector<std::string_view> fieldsOf(std::string_view line, char separator)
{
    std::vector<std::string_view> fields;
    for (std::size_t end = 0; end != std::string_view::npos;) {
        line.remove_prefix(minOf(line.find_first_not_of(' '), line.size()));
        const std::size_t quoted = quotedLength(line, separator);
        // An open quotation mark takes the rest of the line.
        end = quoted == 0 && line.starts_with('"') ? std::string_view::npos : line.find(separator, quoted);
        fields.push_back(trimmed(quoted > 0 ? line.substr(1, quoted - 2) : line.substr(0, end)));
        line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
    }
    return fields;
}

// Removes what spreadsheets write behind the last column.
void removeEmptyEnd(std::vector<std::string_view>& fields, std::size_t columns)
{
    while (fields.size() > columns && fields.back().empty())
        fields.pop_back();
}

} // namespace

CsvReader::CsvReader(std::string_view text)
    : m_rest(text.substr(0, byteOrderMark.size()) == byteOrderMark ? text.substr(byteOrderMark.size()) : text)
{
}

// Returns the next line that is not empty.
std::optional<std::string_view> CsvReader::nextLine()
{
    while (!m_rest.empty()) {
        const std::size_t end = minOf(m_rest.find_first_of("\r\n"), m_rest.size());
        const std::string_view line = trimmed(m_rest.substr(0, end));
        const std::size_t endLength = m_rest.substr(end).starts_with("\r\n") ? 2 : 1;
        m_rest.remove_prefix(minOf(end + endLength, m_rest.size()));
        ++m_line;
        if (!line.empty())
            return line;
    }
    return std::nullopt;
}

tl::expected<void, CsvError> CsvReader::readHeader(std::span<const std::string_view> columns,
                                                   std::size_t minColumns)
{
    // UTF-16 begins with one of these marks or has zero bytes.
    if (m_rest.starts_with("\xFF\xFE") || m_rest.starts_with("\xFE\xFF") ||
        m_rest.find('\0') != std::string_view::npos)
        return fail(CsvExpectation::Utf8, {});
    std::string_view line = nextLine().value_or(std::string_view{});
    if (line.starts_with("sep=")) // for Excel; the header has the separator as well
        line = nextLine().value_or(std::string_view{});
    const std::size_t end = line.find_first_of(",;\t");
    m_separator = end == std::string_view::npos ? ',' : line[end];
    std::vector<std::string_view> names = fieldsOf(line, m_separator);
    removeEmptyEnd(names, columns.size());
    if (!std::ranges::equal(names, columns))
        return fail(CsvExpectation::Header, line);
    m_columns = columns.size();
    m_minColumns = minColumns == 0 ? m_columns : minColumns;
    return {};
}

tl::expected<std::optional<std::vector<std::string_view>>, CsvError> CsvReader::readRow()
{
    while (const auto line = nextLine()) {
        std::vector<std::string_view> fields = fieldsOf(*line, m_separator);
        if (std::ranges::all_of(fields, &std::string_view::empty))
            continue;
        removeEmptyEnd(fields, m_columns);
        if (fields.size() < m_minColumns || fields.size() > m_columns)
            return fail(CsvExpectation::Values, *line);
        fields.resize(m_columns);
        return fields;
    }
    return std::nullopt;
}

tl::expected<double, CsvError> CsvReader::number(std::string_view field)
{
    std::array<char, longestNumber> digits{};
    if (field.empty() || field.size() > digits.size())
        return fail(CsvExpectation::Number, field);
    std::copy(field.begin(), field.end(), digits.begin());
    const std::size_t sign = field.find_first_of(".,");
    if (sign != std::string_view::npos) {
        if (m_decimalSign == 0)
            m_decimalSign = field[sign];
        if (m_decimalSign != field[sign])
            return fail(m_decimalSign == '.' ? CsvExpectation::DecimalPoint : CsvExpectation::DecimalComma,
                        field);
        digits[sign] = '.';
    }
    const std::size_t start = field.front() == '+' && field.size() > 1 && field[1] != '-' ? 1 : 0;
    double value = 0;
    const auto end = std::from_chars(digits.data() + start, digits.data() + field.size(), value);
    if (end.ec != std::errc{} || end.ptr != digits.data() + field.size() || !std::isfinite(value))
        return fail(CsvExpectation::Number, field);
    return value;
}

tl::unexpected<CsvError> CsvReader::fail(CsvExpectation expected, std::string_view found) const
{
    constexpr std::size_t maxBytes = 40;
    std::size_t end = minOf(found.size(), maxBytes);
    while (end > 0 && end < found.size() && (static_cast<unsigned char>(found[end]) & 0xC0U) == 0x80U)
        --end; // not inside a UTF-8 character
    const auto isControl = [](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7F;
    };
    std::string shown(found.substr(0, end));
    std::ranges::replace_if(shown, isControl, '?');
    return tl::unexpected(CsvError{maxOf(m_line, 1), expected, std::move(shown)});
}

} // namespace campanel::profile::detail

namespace campanel::profile {

int csvLineOfRow(std::string_view text, std::size_t index)
{
    detail::CsvReader reader(text);
    static_cast<void>(reader.readHeader({})); // any header
    int line = reader.line();
    for (std::size_t i = 0; i <= index; ++i) {
        const auto row = reader.readRow();
        if (row && !*row)
            break;
        line = reader.line();
    }
    return line;
}

} // namespace campanel::profile
