// SPDX-License-Identifier: Apache-2.0
// Writes and reads by the same tables of fields and choices, so that both directions stay consistent.
#include "app/program/bank_codec.h"

#include "app/program/register_fields.h"
#include "app/program/register_words.h"
#include "modbus/map/bank_header.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace campanel::program {
namespace {

using modbus::TableLayout;

// Writes header values; stores the first error.
class HeaderWriter {
public:
    explicit HeaderWriter(std::vector<std::uint16_t>& bank)
        : m_writer(bank, 0)
    {
    }

    void put(const modbus::RegisterInfo& info, double value)
    {
        if (const auto written = m_writer.physical(info, value); !written && !m_failure)
            m_failure = written.error();
    }
    void put(std::string_view name, double value) { put(modbus::registerNamed(name), value); }
    template <typename E> void put(std::string_view name, E value) requires std::is_enum_v<E>
    {
        put(name, static_cast<double>(value));
    }
    void text(std::string_view name, std::string_view value) { m_writer.text(name, value); }
    [[nodiscard]] const std::optional<modbus::CodecError>& failure() const { return m_failure; }

private:
    modbus::RegisterWriter m_writer;
    std::optional<modbus::CodecError> m_failure;
};

TableLayout layoutOf(const Table& table)
{
    static_assert(std::variant_size_v<Table> == static_cast<std::size_t>(TableLayout::PressStages));
    return static_cast<TableLayout>(table.index() + 1);
}

// The figures of a table that only its layout has.
void writeFigures(HeaderWriter& header, const SolvedProgram& solved, const profile::StepTable& table)
{
    const profile::RotaryCutter& cutter = solved.cutter.value();
    const double syncStartDeg = cutter.angleDegAt(cutter.cycle.tbS);
    const double syncEndDeg = cutter.angleDegAt(cutter.cycle.tcS);
    header.put("bank.cycle_pulses", static_cast<double>(table.pulses.whole));
    header.put("bank.remainder", static_cast<double>(table.pulses.remainder));
    header.put("bank.divisor", static_cast<double>(table.pulses.divisor));
    header.put("bank.carry_row", static_cast<double>(table.carryRow));
    header.put("bank.sync_start", syncStartDeg);
    header.put("bank.sync_end", syncEndDeg);
    // The jaws meet in the middle of the synchronous segment.
    header.put("bank.cut_angle", (syncStartDeg + syncEndDeg) / 2);
}

void writeFigures(HeaderWriter& header, const SolvedProgram&, const profile::CamTable& table)
{
    header.put("bank.advance", static_cast<double>(table.advance.whole));
    header.put("bank.remainder", static_cast<double>(table.advance.remainder));
    header.put("bank.divisor", static_cast<double>(table.advance.divisor));
}

void writeFigures(HeaderWriter& header, const SolvedProgram&, const profile::IntervalTable& table)
{
    header.put("bank.advance", static_cast<double>(table.advance));
    header.put("interval.fraction_bits", table.fractionBits);
    header.put("bank.divisor", 1);
}

void writeFigures(HeaderWriter& header, const SolvedProgram&, const profile::PressTable&)
{
    header.put("bank.divisor", 1);
}

void writeTable(HeaderWriter& header, const Recipe& recipe, const SolvedProgram& solved, const Table& table)
{
    const TableLayout layout = layoutOf(table);
    header.put("bank.layout", layout);
    std::visit(
        [&](const auto& rows) {
            header.put("bank.row_count", static_cast<double>(rows.rows.size()));
            header.put("bank.cycle_ticks", rows.cycleTicks);
            writeFigures(header, solved, rows);
        },
        table);
    if (layout == TableLayout::CamPoints || layout == TableLayout::Intervals)
        header.put("bank.end_behavior", kindInfo(recipe.kind()).end);
    if (const ListInfo* list = kindInfo(recipe.kind()).list)
        header.put(list->countRegister, static_cast<double>(list->size(recipe.program)));
}

void appendRows(std::vector<std::uint16_t>& bank, const profile::StepTable& table)
{
    for (const profile::StepRow& row : table.rows) {
        bank.push_back(row.pulses);
        append32(bank, row.ticks);
    }
}

void appendRows(std::vector<std::uint16_t>& bank, const profile::CamTable& table)
{
    for (const profile::CamRow& row : table.rows) {
        append32(bank, row.position256);
        append32(bank, row.slope256);
    }
}

void appendRows(std::vector<std::uint16_t>& bank, const profile::IntervalTable& table)
{
    for (const profile::IntervalRow& row : table.rows) {
        append32(bank, row.pulses);
        append32(bank, row.firstSpeed);
        append32(bank, row.lastSpeed);
        append32(bank, row.acceleration);
    }
}

void appendRows(std::vector<std::uint16_t>& bank, const profile::PressTable& table)
{
    for (const profile::PressRow& row : table.rows) {
        append32(bank, row.speedHz);
        append32(bank, row.endPulses);
        append32(bank, row.forceN);
        append32(bank, row.timeMs);
    }
}

constexpr std::string_view pinnedRegister = "program.pinned";

std::uint16_t pinnedBits(const profile::RotaryCutterProgram& program)
{
    unsigned bits = 0;
    for (std::size_t i = 0; i < profile::cycleFields.size(); ++i) {
        if (profile::isPinned(program, profile::cycleFields[i]))
            bits |= 1u << i;
    }
    return static_cast<std::uint16_t>(bits);
}

// Returns false unless the bits pin exactly two values.
bool setPinned(profile::RotaryCutterProgram& program, unsigned bits)
{
    std::size_t pinned = 0;
    for (std::size_t i = 0; i < profile::cycleFields.size(); ++i) {
        if ((bits & (1u << i)) != 0 && pinned++ < program.pinned.size())
            program.pinned[pinned - 1] = profile::cycleFields[i];
    }
    return pinned == program.pinned.size();
}

// Returns the recipe with all four values of the cycle: the header has the derived ones too.
Recipe withCycleValues(const Recipe& recipe, const SolvedProgram& solved)
{
    Recipe result = recipe;
    if (solved.cutter) {
        const profile::CycleNumbers& cycle = solved.cutter->cycle;
        result.cutter().bagLengthMm = cycle.bagLengthMm;
        result.cutter().rateBagsPerMin = cycle.rateBagsPerMin;
        result.cutter().baseSpeedMmPerS = cycle.baseSpeedMmPerS;
        result.cutter().filmSpeedMmPerS = cycle.filmSpeedMmPerS;
    }
    return result;
}

void writeInputs(HeaderWriter& header, const Recipe& recipe)
{
    const KindInfo& kind = kindInfo(recipe.kind());
    header.put("bank.kind", recipe.kind());
    for (const RegisterField& entry : registerFields(kind))
        header.put(*entry.info, value(recipe, entry.field) * entry.perUnit);
    for (const ChoiceInfo& entry : kind.choices) {
        if (const auto* info = registerOf(kind, entry.registerName))
            header.put(*info, choice(recipe.program, entry.choice));
    }
    if (const auto* parameters = lawParameters(recipe.program)) {
        for (std::size_t i = 0; i < parameters->size(); ++i)
            header.put(*registerOf(kind, lawParameterSuffixes[i]), (*parameters)[i]);
    }
    if (recipe.isCutter())
        header.put(pinnedRegister, pinnedBits(recipe.cutter()));
    header.put("program.recipe_version", recipe.version);
    header.text("program.recipe_name", recipe.name);
}

} // namespace

tl::expected<std::vector<std::uint16_t>, modbus::CodecError>
encodeBank(const Recipe& recipe, const SolvedProgram& solved, const Table& table)
{
    const std::size_t rowCount = std::visit([](const auto& rows) { return rows.rows.size(); }, table);
    const double capacity = modbus::rowSize(layoutOf(table)).capacity;
    if (static_cast<double>(rowCount) > capacity)
        return tl::unexpected(
            modbus::CodecError{"bank.row_count", static_cast<double>(rowCount), 1, capacity, "rows"});
    std::vector<std::uint16_t> bank(modbus::bankHeaderRegisters, 0);
    HeaderWriter header(bank);
    writeInputs(header, withCycleValues(recipe, solved));
    writeTable(header, recipe, solved, table);
    if (header.failure())
        return tl::unexpected(*header.failure());
    std::visit([&](const auto& rows) { appendRows(bank, rows); }, table);
    if (const ListInfo* list = kindInfo(recipe.kind()).list)
        list->append(recipe.program, bank);
    return bank;
}

bool decodeBank(std::span<const std::uint16_t> header, std::span<const std::uint16_t> list, Recipe& recipe)
{
    const KindInfo& kind = kindInfo(recipe.kind());
    const modbus::RegisterReader reader(header, 0);
    for (const RegisterField& entry : registerFields(kind))
        setValue(recipe, entry.field, reader.physical(*entry.info) / entry.perUnit);
    for (const ChoiceInfo& entry : kind.choices) {
        if (const auto* info = registerOf(kind, entry.registerName))
            setChoice(recipe.program, entry.choice, static_cast<std::uint16_t>(reader.raw(*info)));
    }
    const bool isIntervals = reader.u16("bank.layout") == static_cast<std::uint16_t>(TableLayout::Intervals);
    setChoice(recipe.program, Choice::Execution,
              static_cast<std::uint16_t>(isIntervals ? profile::Execution::Intervals
                                                     : profile::Execution::CamPoints));
    if (auto* parameters = lawParameters(recipe.program)) {
        for (std::size_t i = 0; i < parameters->size(); ++i)
            (*parameters)[i] = reader.physical(*registerOf(kind, lawParameterSuffixes[i]));
    }
    if (kind.list != nullptr)
        kind.list->read(list, recipe.program);
    recipe.version = reader.u16("program.recipe_version");
    recipe.name = reader.text("program.recipe_name");
    return !recipe.isCutter() || setPinned(recipe.cutter(), reader.u16(pinnedRegister));
}

} // namespace campanel::program
