// SPDX-License-Identifier: Apache-2.0
// Typed access to register vectors by the rows of the register table: raw integers, physical values (raw *
// scale, rounded and range-checked) and text. Two registers: high word first.
#pragma once

#include "modbus/map/register_map.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace campanel::modbus {

// The error of a value that does not fit its register, or is outside the limits of a writable one.
struct CodecError {
    std::string_view registerName;
    double value = 0.0;
    double minimum = 0.0;
    double maximum = 0.0;
    std::string_view unit;
};

// Returns the row of that name. The name must exist: a missing one is a programming error and ends the
// program.
[[nodiscard]] const RegisterInfo& registerNamed(std::string_view name);

// Returns the nearest raw value. Errors: not finite, outside the register's type, outside a writable
// register's limits.
[[nodiscard]] tl::expected<std::int64_t, CodecError> toRaw(const RegisterInfo& info, double physical);

// Returns raw * scale, computed so that toRaw() returns the same raw value.
[[nodiscard]] double toPhysical(const RegisterInfo& info, std::int64_t raw);

// Returns the physical value after a conversion to its register and back.
[[nodiscard]] tl::expected<double, CodecError> quantise(const RegisterInfo& info, double physical);

// Reads from a range of registers that starts at address `base` (for a bank: 0, as its rows are offsets).
class RegisterReader {
public:
    RegisterReader(std::span<const std::uint16_t> registers, std::uint16_t base)
        : m_registers(registers)
        , m_base(base)
    {
    }

    [[nodiscard]] std::int64_t raw(const RegisterInfo& info) const;
    [[nodiscard]] double physical(const RegisterInfo& info) const;
    [[nodiscard]] std::string text(const RegisterInfo& info) const;

    [[nodiscard]] std::uint16_t u16(std::string_view name) const;
    [[nodiscard]] std::uint32_t u32(std::string_view name) const;
    [[nodiscard]] std::int32_t i32(std::string_view name) const;
    [[nodiscard]] double physical(std::string_view name) const { return physical(registerNamed(name)); }
    [[nodiscard]] std::string text(std::string_view name) const { return text(registerNamed(name)); }

private:
    [[nodiscard]] std::uint16_t at(std::uint16_t address) const;

    std::span<const std::uint16_t> m_registers;
    std::uint16_t m_base = 0;
};

// Writes to a range of registers that starts at address `base`.
class RegisterWriter {
public:
    RegisterWriter(std::span<std::uint16_t> registers, std::uint16_t base)
        : m_registers(registers)
        , m_base(base)
    {
    }

    [[nodiscard]] tl::expected<void, CodecError> physical(const RegisterInfo& info, double value);
    [[nodiscard]] tl::expected<void, CodecError> physical(std::string_view name, double value)
    {
        return physical(registerNamed(name), value);
    }
    // Writes UTF-8, cut at a character boundary when it is too long, padded with zeros.
    void text(std::string_view name, std::string_view value);

private:
    std::span<std::uint16_t> m_registers;
    std::uint16_t m_base = 0;
};

// Returns the longest prefix of `value` that fits `bytes` bytes without cutting a UTF-8 character.
[[nodiscard]] std::string_view fittingUtf8(std::string_view value, std::size_t bytes);

} // namespace campanel::modbus
