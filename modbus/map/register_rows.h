// SPDX-License-Identifier: Apache-2.0
// Short forms of the rows of the register tables, and the compile-time check of every table. Internal to
// modbus/.
#pragma once

#include "modbus/map/register_map.h"

namespace campanel::modbus::rows {

constexpr RegisterInfo ro16(std::string_view name, std::uint16_t address, std::string_view text,
                            std::string_view enumName = {}, double scale = 1.0, std::string_view unit = {})
{
    return {name, address, RegisterType::U16, 1, Access::ReadOnly, scale, unit, 0, 0, 0, enumName, text};
}

constexpr RegisterInfo ro32(std::string_view name, std::uint16_t address, std::string_view text,
                            double scale = 1.0, std::string_view unit = {})
{
    return {name, address, RegisterType::U32, 2, Access::ReadOnly, scale, unit, 0, 0, 0, {}, text};
}

constexpr RegisterInfo roI32(std::string_view name, std::uint16_t address, std::string_view text,
                             std::string_view unit)
{
    return {name, address, RegisterType::I32, 2, Access::ReadOnly, 1.0, unit, 0, 0, 0, {}, text};
}

constexpr RegisterInfo roI16(std::string_view name, std::uint16_t address, std::string_view text,
                             double scale, std::string_view unit)
{
    return {name, address, RegisterType::I16, 1, Access::ReadOnly, scale, unit, 0, 0, 0, {}, text};
}

constexpr RegisterInfo roScaled32(std::string_view name, std::uint16_t address, std::string_view text,
                                  double scale, std::string_view unit)
{
    return {name, address, RegisterType::I32, 2, Access::ReadOnly, scale, unit, 0, 0, 0, {}, text};
}

constexpr RegisterInfo rw16(std::string_view name, std::uint16_t address, std::string_view text,
                            std::string_view enumName = {}, double minimum = 0, double maximum = 65535,
                            double defaultValue = 0, double scale = 1.0, std::string_view unit = {})
{
    return {name,    address,      RegisterType::U16, 1,   Access::ReadWrite, scale, unit, minimum,
            maximum, defaultValue, enumName,          text};
}

constexpr RegisterInfo rwI16(std::string_view name, std::uint16_t address, std::string_view text,
                             double minimum, double maximum, double defaultValue, double scale,
                             std::string_view unit)
{
    return {name,  address, RegisterType::I16, 1,       Access::ReadWrite,
            scale, unit,    minimum,           maximum, defaultValue,
            {},    text};
}

constexpr RegisterInfo rw32(std::string_view name, std::uint16_t address, std::string_view text,
                            double minimum, double maximum, double defaultValue, double scale = 1.0,
                            std::string_view unit = {})
{
    return {name,  address, RegisterType::U32, 2,       Access::ReadWrite,
            scale, unit,    minimum,           maximum, defaultValue,
            {},    text};
}

constexpr RegisterInfo block(std::string_view name, std::uint16_t address, std::uint16_t count, Access access,
                             std::string_view text)
{
    return {name, address, RegisterType::Block, count, access, 1.0, {}, 0, 0, 0, {}, text};
}

constexpr RegisterInfo withKind(ProgramKind kind, RegisterInfo row)
{
    row.kinds = RegisterInfo::bitOf(kind);
    return row;
}

constexpr RegisterInfo since(std::uint16_t minor, RegisterInfo row)
{
    row.minor = minor;
    return row;
}

constexpr RegisterInfo cutter(RegisterInfo row)
{
    return withKind(ProgramKind::RotaryCutter, row);
}

template <typename... Layouts> constexpr RegisterInfo withLayout(RegisterInfo row, Layouts... layouts)
{
    row.layouts = static_cast<std::uint16_t>((RegisterInfo::bitOf(layouts) | ...));
    return row;
}

// Returns true when the row is valid: registers of the same kind and layout do not overlap, and each has the
// size of its type.
constexpr bool isConsistent(const RegisterInfo& row)
{
    const bool wide = row.type == RegisterType::U32 || row.type == RegisterType::I32;
    const bool narrow = row.type == RegisterType::U16 || row.type == RegisterType::I16;
    return (!wide || row.count == 2) && (!narrow || row.count == 1) && row.count != 0 &&
           static_cast<unsigned>(row.address) + row.count <= 0x10000;
}

constexpr bool mayMeet(const RegisterInfo& row, const RegisterInfo& other)
{
    const bool kinds = row.kinds == 0 || other.kinds == 0 || (row.kinds & other.kinds) != 0;
    const bool layouts = row.layouts == 0 || other.layouts == 0 || (row.layouts & other.layouts) != 0;
    return kinds && layouts;
}

template <std::size_t N> consteval bool isConsistent(const std::array<RegisterInfo, N>& rows)
{
    for (std::size_t i = 0; i < N; ++i) {
        const RegisterInfo& row = rows[i];
        if (!isConsistent(row))
            return false;
        for (std::size_t j = 0; j < i; ++j) {
            const RegisterInfo& other = rows[j];
            const bool overlap =
                row.address < other.address + other.count && other.address < row.address + row.count;
            if (overlap && mayMeet(row, other))
                return false;
        }
    }
    return true;
}

} // namespace campanel::modbus::rows
