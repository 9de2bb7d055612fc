// SPDX-License-Identifier: Apache-2.0
// One list of header fields for both directions, so that reading and writing stay consistent.
#include "modbus/map/bank_header.h"

#include <optional>
#include <type_traits>

namespace campanel::modbus {
namespace {

// Calls visit(register name, member) for every numeric field of the header, in the order of the map.
template <typename Header, typename Visitor> void visitFields(Header& header, Visitor visit)
{
    visit("bank.layout", header.layout);
    visit("bank.kind", header.kind);
    visit("bank.row_count", header.rowCount);
    visit("bank.cycle_ticks", header.cycleTicks);
    visit("bank.cycle_pulses", header.cyclePulses);
    visit("bank.remainder", header.remainder);
    visit("bank.divisor", header.divisor);
    visit("bank.carry_row", header.carryRow);
    visit("bank.cut_angle", header.cutAngleDeg);
    visit("bank.sync_start", header.syncStartDeg);
    visit("bank.sync_end", header.syncEndDeg);
    visit("program.knife_radius", header.knifeRadiusMm);
    visit("program.knives", header.knives);
    visit("program.pulses_per_motor_rev", header.pulsesPerMotorRev);
    visit("program.gear_numerator", header.gearNumerator);
    visit("program.gear_denominator", header.gearDenominator);
    visit("program.pinned", header.pinned);
    visit("program.bag_length", header.bagLengthMm);
    visit("program.rate", header.rateBagsPerMin);
    visit("program.base_speed", header.baseSpeedMmPerS);
    visit("program.film_speed", header.filmSpeedMmPerS);
    visit("program.sync_ratio", header.syncRatio);
    visit("program.k1", header.k[0]);
    visit("program.k2", header.k[1]);
    visit("program.k3", header.k[2]);
    visit("program.k4", header.k[3]);
    visit("program.law", header.law);
    visit("program.law_parameter1", header.lawParameters[0]);
    visit("program.law_parameter2", header.lawParameters[1]);
    visit("program.ramp_slices", header.rampSlices);
    visit("program.recipe_version", header.recipeVersion);
}

} // namespace

KnotSpan knotSpan(std::span<const std::uint16_t> header)
{
    const RegisterReader reader(header, 0);
    if (reader.u16("bank.kind") != static_cast<std::uint16_t>(ProgramKind::PointCam))
        return {};
    const unsigned rows = reader.u16("bank.row_count");
    const unsigned knots = reader.u16("cam.knot_count");
    if (rows > camPointCapacity || knots > knotCapacity)
        return {};
    return {static_cast<std::uint16_t>(bankHeaderRegisters + camPointRegisters * rows),
            static_cast<std::uint16_t>(knotRegisters * knots)};
}

std::optional<std::uint16_t> bankLength(std::span<const std::uint16_t> header)
{
    const RegisterReader reader(header, 0);
    unsigned rowLength = 0;
    switch (static_cast<TableLayout>(reader.u16("bank.layout"))) {
    case TableLayout::StepTable:
        rowLength = rowRegisters;
        break;
    case TableLayout::CamPoints:
        rowLength = camPointRegisters;
        break;
    case TableLayout::Intervals:
        rowLength = intervalRegisters;
        break;
    case TableLayout::PressStages:
        rowLength = stageRegisters;
        break;
    case TableLayout::None:
        break;
    }
    const unsigned length =
        bankHeaderRegisters + rowLength * reader.u16("bank.row_count") + knotSpan(header).count;
    if (rowLength == 0 || length > bankRegisters)
        return std::nullopt;
    return static_cast<std::uint16_t>(length);
}

BankHeader decodeBankHeader(std::span<const std::uint16_t> registers)
{
    const RegisterReader reader(registers, 0);
    BankHeader header;
    visitFields(header, [&reader](std::string_view name, auto& member) {
        using Member = std::remove_reference_t<decltype(member)>;
        if constexpr (std::is_floating_point_v<Member>)
            member = reader.physical(name);
        else
            member = static_cast<Member>(reader.raw(registerNamed(name)));
    });
    header.recipeName = reader.text("program.recipe_name");
    return header;
}

tl::expected<std::vector<std::uint16_t>, CodecError> encodeBank(const BankHeader& header,
                                                                std::span<const TableRow> rows)
{
    if (rows.size() > rowCapacity)
        return tl::unexpected(
            CodecError{"bank.row_count", static_cast<double>(rows.size()), 1, rowCapacity, "rows"});
    BankHeader counted = header;
    counted.rowCount = static_cast<std::uint16_t>(rows.size());
    std::vector<std::uint16_t> bank(bankHeaderRegisters + rowRegisters * rows.size(), 0);
    RegisterWriter writer(bank, 0);
    std::optional<CodecError> failure;
    visitFields(counted, [&](std::string_view name, const auto& member) {
        const auto written = writer.physical(name, static_cast<double>(member));
        if (!written && !failure)
            failure = written.error();
    });
    if (failure)
        return tl::unexpected(*failure);
    writer.text("program.recipe_name", header.recipeName);
    std::size_t next = bankHeaderRegisters;
    for (const TableRow& row : rows) {
        bank[next++] = row.pulses;
        bank[next++] = static_cast<std::uint16_t>(row.ticks >> 16);
        bank[next++] = static_cast<std::uint16_t>(row.ticks & 0xFFFFu);
    }
    return bank;
}

std::vector<TableRow> decodeRows(std::span<const std::uint16_t> bank)
{
    if (bank.size() < bankHeaderRegisters)
        return {};
    const std::size_t count = decodeBankHeader(bank).rowCount;
    if (bank.size() < bankHeaderRegisters + rowRegisters * count)
        return {};
    std::vector<TableRow> rows(count);
    std::size_t next = bankHeaderRegisters;
    for (TableRow& row : rows) {
        row.pulses = bank[next];
        row.ticks = (static_cast<std::uint32_t>(bank[next + 1]) << 16) | bank[next + 2];
        next += rowRegisters;
    }
    return rows;
}

} // namespace campanel::modbus
