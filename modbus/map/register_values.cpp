// SPDX-License-Identifier: Apache-2.0
#include "modbus/map/register_values.h"

#include "modbus/map/codec.h"
#include "modbus/map/register_document.h"

#include <algorithm>
#include <cstdio>

namespace campanel::modbus {
namespace {

bool isBankField(const RegisterInfo& info)
{
    const auto fields = bankFields();
    return &info >= fields.data() && &info < fields.data() + fields.size();
}

// Returns the first register of the bank that contains the address; empty outside banks.
std::optional<std::uint16_t> bankAt(std::uint16_t address)
{
    for (const std::uint16_t base : {activeBankBase, stagedBankBase}) {
        if (address >= base && address < base + bankHeaderRegisters)
            return base;
    }
    return std::nullopt;
}

struct Run {
    std::uint16_t address = 0;
    std::span<const std::uint16_t> registers;

    [[nodiscard]] bool holds(const RegisterInfo& info, std::uint16_t base) const
    {
        const int first = info.address + base;
        return first >= address && first + info.count <= static_cast<int>(address + registers.size());
    }
    [[nodiscard]] std::optional<std::uint16_t> value(std::string_view name, std::uint16_t base) const
    {
        const RegisterInfo& info = registerNamed(name);
        if (!holds(info, base))
            return std::nullopt;
        return registers[static_cast<std::size_t>(info.address + base - address)];
    }
};

const RegisterInfo* rowAt(const Run& run, std::uint16_t address, ProgramKind kind, TableLayout layout)
{
    const auto bank = bankAt(address);
    const std::uint16_t base = bank.value_or(0);
    const auto rows = bank ? bankFields() : registers();
    const auto found = std::ranges::find_if(rows, [&](const RegisterInfo& row) {
        return row.address + base == address && row.type != RegisterType::Block &&
               row.appliesTo(kind, layout) && run.holds(row, base);
    });
    return found == rows.end() ? nullptr : &*found;
}

std::string bitNames(std::string_view enumOfBits, std::int64_t bits)
{
    std::string names;
    for (int bit = 0; bit < 16; ++bit) {
        if ((bits & (1 << bit)) == 0)
            continue;
        names.append(names.empty() ? "" : ", ").append(enumName(enumOfBits, bit));
    }
    return names.empty() ? "none" : names;
}

// Returns the value of the register at `index` of the run.
NamedValue named(const Run& run, std::size_t index, const RegisterInfo* row)
{
    const auto address = static_cast<std::uint16_t>(run.address + index);
    NamedValue value;
    value.info = row;
    value.address = address;
    if (row == nullptr) {
        value.raw = run.registers[index];
        return value;
    }
    value.count = row->count;
    const std::uint16_t base = isBankField(*row) ? bankAt(address).value_or(0) : std::uint16_t{0};
    // The reader uses the table's addresses: within a bank, relative to the bank's base.
    const RegisterReader reader(run.registers.subspan(index), static_cast<std::uint16_t>(address - base));
    if (row->type == RegisterType::Text) {
        value.words = reader.text(*row);
        return value;
    }
    value.raw = reader.raw(*row);
    if (row->enumName.empty())
        value.physical = toPhysical(*row, value.raw);
    return value;
}

} // namespace

std::optional<RegisterSpan> findSpan(std::string_view name)
{
    const RegisterInfo* info = findRegister(name);
    if (info == nullptr)
        return std::nullopt;
    const std::uint16_t base = isBankField(*info) ? activeBankBase : std::uint16_t{0};
    return RegisterSpan{static_cast<std::uint16_t>(info->address + base), info->count};
}

std::string NamedValue::name() const
{
    return info != nullptr ? std::string(info->name) : hexAddress(address);
}

std::string NamedValue::text() const
{
    if (info == nullptr)
        return hexAddress(static_cast<unsigned>(raw));
    if (info->type == RegisterType::Text) {
        std::string quoted = "\"";
        return quoted.append(words).append("\"");
    }
    if (!physical)
        return info->enumName.ends_with("Bit") ? bitNames(info->enumName, raw)
                                               : enumName(info->enumName, raw);
    char digits[48];
    std::snprintf(digits, sizeof digits, "%.10g", *physical);
    std::string result = digits;
    if (!info->unit.empty())
        result.append(" ").append(info->unit);
    return result;
}

std::vector<NamedValue> namedValues(std::uint16_t address, std::span<const std::uint16_t> registers,
                                    ProgramKind kind, TableLayout layout)
{
    const Run run{address, registers};
    const auto bank = bankAt(address);
    if (const auto own = bank ? run.value("bank.kind", *bank) : run.value("status.program_kind", 0))
        kind = static_cast<ProgramKind>(*own);
    if (const auto own = bank ? run.value("bank.layout", *bank) : std::nullopt)
        layout = static_cast<TableLayout>(*own);
    std::vector<NamedValue> values;
    for (std::size_t i = 0; i < registers.size(); i += values.back().count) {
        const auto at =
            static_cast<std::uint16_t>(address + i); // a damaged frame may go beyond the last address
        values.push_back(named(run, i, rowAt(run, at, kind, layout)));
    }
    return values;
}

} // namespace campanel::modbus
