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

std::vector<std::string_view> fieldsOf(std::string_view line, char separator)
{
    std::vector<std::string_view> fields;
    for (std::size_t end = 0; end != std::string_view::npos;) {
        end = line.find(separator);
        fields.push_back(trimmed(line.substr(0, end)));
        line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
    }
    return fields;
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
        const std::size_t end = minOf(m_rest.find('\n'), m_rest.size());
        const std::string_view line = trimmed(m_rest.substr(0, end));
        m_rest.remove_prefix(minOf(end + 1, m_rest.size()));
        ++m_line;
        if (!line.empty())
            return line;
    }
    return std::nullopt;
}

tl::expected<void, CsvError> CsvReader::readHeader(std::span<const std::string_view> columns)
{
    // UTF-16 begins with one of these marks or has zero bytes.
    if (m_rest.starts_with("\xFF\xFE") || m_rest.starts_with("\xFE\xFF") ||
        m_rest.find('\0') != std::string_view::npos)
        return fail(CsvExpectation::Utf8, {});
    const std::string_view line = nextLine().value_or(std::string_view{});
    const std::size_t end = line.find_first_of(",;");
    m_separator = end == std::string_view::npos ? ',' : line[end];
    if (!std::ranges::equal(fieldsOf(line, m_separator), columns))
        return fail(CsvExpectation::Header, line);
    m_columns = columns.size();
    return {};
}

tl::expected<std::optional<std::vector<std::string_view>>, CsvError> CsvReader::readRow()
{
    const auto line = nextLine();
    if (!line)
        return std::nullopt;
    std::vector<std::string_view> fields = fieldsOf(*line, m_separator);
    if (fields.size() != m_columns)
        return fail(CsvExpectation::Values, *line);
    return fields;
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

void appendCsvHeader(std::string& text, std::span<const std::string_view> columns)
{
    for (const std::string_view column : columns) {
        text.append(column);
        text.push_back(',');
    }
    text.back() = '\n';
}

void appendCsvNumber(std::string& text, double value)
{
    std::array<char, longestNumber> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
    text.append(buffer.data(), end.ptr);
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
