// SPDX-License-Identifier: Apache-2.0
#include "profile/cam/knots_csv.h"

#include <array>

namespace campanel::profile {

std::span<const std::string_view> knotColumns()
{
    static constexpr std::array<std::string_view, 2> columns{"master_deg", "slave_mm"};
    return columns;
}

tl::expected<std::vector<Knot>, CsvError> readKnotsCsv(std::string_view text)
{
    detail::CsvReader reader(text);
    if (const auto header = reader.readHeader(knotColumns()); !header)
        return tl::unexpected(header.error());
    std::vector<Knot> knots;
    for (;;) {
        const auto row = reader.readRow();
        if (!row)
            return tl::unexpected(row.error());
        if (!*row)
            break;
        const auto master = reader.number((**row)[0]);
        if (!master)
            return tl::unexpected(master.error());
        const auto slave = reader.number((**row)[1]);
        if (!slave)
            return tl::unexpected(slave.error());
        knots.push_back({*master, *slave});
    }
    if (knots.empty())
        return reader.fail(CsvExpectation::Rows, {});
    return knots;
}

std::string writeKnotsCsv(std::span<const Knot> knots, const CsvDialect& dialect)
{
    CsvWriter csv(dialect);
    for (const std::string_view column : knotColumns())
        csv.add(column);
    csv.endLine();
    for (const Knot& knot : knots) {
        csv.addNumber(knot.masterDeg);
        csv.addNumber(knot.slaveMm);
        csv.endLine();
    }
    return csv.text();
}

} // namespace campanel::profile
