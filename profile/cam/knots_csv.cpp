// SPDX-License-Identifier: Apache-2.0
// Reads line by line; the header determines the separator, the first fractional number the decimal sign.
#include "profile/cam/knots_csv.h"

#include "profile/model/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace campanel::profile {
namespace {

constexpr std::string_view masterColumn = "master_deg";
constexpr std::string_view slaveColumn = "slave_mm";
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

class Reader {
public:
    explicit Reader(std::string_view text)
        : m_rest(text.substr(0, byteOrderMark.size()) == byteOrderMark ? text.substr(byteOrderMark.size())
                                                                       : text)
    {
    }

    [[nodiscard]] tl::expected<std::vector<Knot>, CsvError> read()
    {
        // UTF-16 begins with one of these marks or has zero bytes.
        if (m_rest.starts_with("\xFF\xFE") || m_rest.starts_with("\xFE\xFF") ||
            m_rest.find('\0') != std::string_view::npos)
            return fail(CsvExpectation::Utf8, {});
        const auto header = nextLine();
        if (!header || !takeHeader(*header))
            return fail(CsvExpectation::Header, header.value_or(std::string_view{}));
        std::vector<Knot> knots;
        while (const auto line = nextLine()) {
            const std::size_t end = line->find(m_separator);
            if (end == std::string_view::npos || line->find(m_separator, end + 1) != std::string_view::npos)
                return fail(CsvExpectation::TwoValues, *line);
            const auto master = number(trimmed(line->substr(0, end)));
            if (!master)
                return tl::unexpected(master.error());
            const auto slave = number(trimmed(line->substr(end + 1)));
            if (!slave)
                return tl::unexpected(slave.error());
            knots.push_back({*master, *slave});
        }
        if (knots.empty())
            return fail(CsvExpectation::Knots, {});
        return knots;
    }

    [[nodiscard]] int lineOfKnot(std::size_t index)
    {
        static_cast<void>(nextLine()); // the header
        int line = m_line;
        for (std::size_t i = 0; i <= index && nextLine(); ++i)
            line = m_line;
        return line;
    }

private:
    // Returns the next line that is not empty.
    std::optional<std::string_view> nextLine()
    {
        while (!m_rest.empty()) {
            const std::size_t end = std::min(m_rest.find('\n'), m_rest.size());
            const std::string_view line = trimmed(m_rest.substr(0, end));
            m_rest.remove_prefix(std::min(end + 1, m_rest.size()));
            ++m_line;
            if (!line.empty())
                return line;
        }
        return std::nullopt;
    }

    bool takeHeader(std::string_view line)
    {
        const std::size_t end = line.find_first_of(",;");
        if (end == std::string_view::npos)
            return false;
        m_separator = line[end];
        return trimmed(line.substr(0, end)) == masterColumn && trimmed(line.substr(end + 1)) == slaveColumn;
    }

    [[nodiscard]] tl::expected<double, CsvError> number(std::string_view field)
    {
        std::array<char, 64> digits{};
        if (field.empty() || field.size() > digits.size())
            return fail(CsvExpectation::Number, field);
        std::copy(field.begin(), field.end(), digits.begin());
        const std::size_t sign = field.find_first_of(".,");
        if (sign != std::string_view::npos) {
            if (m_decimalSign == 0)
                m_decimalSign = field[sign];
            if (m_decimalSign != field[sign])
                return fail(m_decimalSign == '.' ? CsvExpectation::DecimalPoint
                                                 : CsvExpectation::DecimalComma,
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

    [[nodiscard]] tl::unexpected<CsvError> fail(CsvExpectation expected, std::string_view found) const
    {
        constexpr std::size_t maxBytes = 40;
        std::size_t end = std::min(found.size(), maxBytes);
        while (end > 0 && end < found.size() && (static_cast<unsigned char>(found[end]) & 0xC0U) == 0x80U)
            --end; // not inside a UTF-8 character
        const auto isControl = [](char c) {
            return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7F;
        };
        std::string shown(found.substr(0, end));
        std::ranges::replace_if(shown, isControl, '?');
        return tl::unexpected(CsvError{std::max(m_line, 1), expected, std::move(shown)});
    }

    std::string_view m_rest;
    int m_line = 0;
    char m_separator = ',';
    char m_decimalSign = 0; // unknown yet
};

void appendNumber(std::string& text, double value)
{
    std::array<char, 352> buffer{}; // the longest double in fixed notation and its sign
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
    text.append(buffer.data(), end.ptr);
}

} // namespace

tl::expected<std::vector<Knot>, CsvError> readKnotsCsv(std::string_view text)
{
    return Reader(text).read();
}

int lineOfKnot(std::string_view text, std::size_t index)
{
    return Reader(text).lineOfKnot(index);
}

std::string writeKnotsCsv(std::span<const Knot> knots)
{
    std::string text = detail::concat({masterColumn, ",", slaveColumn, "\n"});
    for (const Knot& knot : knots) {
        appendNumber(text, knot.masterDeg);
        text.push_back(',');
        appendNumber(text, knot.slaveMm);
        text.push_back('\n');
    }
    return text;
}

} // namespace campanel::profile
