// SPDX-License-Identifier: Apache-2.0
// Converts registers to values and back. Scales are negative powers of ten, so dividing by the reciprocal
// gives the double that is nearest to the decimal number.
#include "modbus/map/codec.h"

#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace campanel::modbus {
namespace {

struct RawRange {
    std::int64_t minimum = 0;
    std::int64_t maximum = 0;
};

RawRange rangeOf(RegisterType type)
{
    switch (type) {
    case RegisterType::I16:
        return {INT16_MIN, INT16_MAX};
    case RegisterType::U32:
        return {0, UINT32_MAX};
    case RegisterType::I32:
        return {INT32_MIN, INT32_MAX};
    case RegisterType::U16:
    case RegisterType::Text:
    case RegisterType::Block:
        break;
    }
    return {0, UINT16_MAX};
}

bool hasLimits(const RegisterInfo& info)
{
    return info.access == Access::ReadWrite && info.maximum > info.minimum;
}

} // namespace

const RegisterInfo& registerNamed(std::string_view name)
{
    const RegisterInfo* const info = findRegister(name);
    if (info == nullptr) {
        std::fprintf(stderr, "no register is called %.*s\n", static_cast<int>(name.size()), name.data());
        std::abort();
    }
    return *info;
}

tl::expected<std::int64_t, CodecError> toRaw(const RegisterInfo& info, double physical)
{
    const RawRange range = rangeOf(info.type);
    const double minimum = hasLimits(info) ? info.minimum : toPhysical(info, range.minimum);
    const double maximum = hasLimits(info) ? info.maximum : toPhysical(info, range.maximum);
    const auto refused = [&] {
        return tl::unexpected(CodecError{info.name, physical, minimum, maximum, info.unit});
    };
    // A tolerance of half a step: a value that rounds to the limit is valid.
    if (!std::isfinite(physical) || physical < minimum - info.scale / 2 ||
        physical > maximum + info.scale / 2)
        return refused();
    const auto raw = static_cast<std::int64_t>(std::llround(physical * std::round(1.0 / info.scale)));
    if (raw < range.minimum || raw > range.maximum)
        return refused();
    return raw;
}

double toPhysical(const RegisterInfo& info, std::int64_t raw)
{
    return static_cast<double>(raw) / std::round(1.0 / info.scale);
}

tl::expected<double, CodecError> quantise(const RegisterInfo& info, double physical)
{
    return toRaw(info, physical).map([&info](std::int64_t raw) { return toPhysical(info, raw); });
}

std::uint16_t RegisterReader::at(std::uint16_t address) const
{
    const auto index = static_cast<std::size_t>(address - m_base);
    assert(address >= m_base && index < m_registers.size());
    return m_registers[index];
}

std::int64_t RegisterReader::raw(const RegisterInfo& info) const
{
    const std::uint16_t first = at(info.address);
    switch (info.type) {
    case RegisterType::I16:
        return static_cast<std::int16_t>(first);
    case RegisterType::U32:
    case RegisterType::I32: {
        const auto low = at(static_cast<std::uint16_t>(info.address + 1));
        const std::uint32_t wide = (static_cast<std::uint32_t>(first) << 16) | low;
        return info.type == RegisterType::U32 ? static_cast<std::int64_t>(wide)
                                              : static_cast<std::int32_t>(wide);
    }
    case RegisterType::U16:
    case RegisterType::Text:
    case RegisterType::Block:
        break;
    }
    return first;
}

double RegisterReader::physical(const RegisterInfo& info) const
{
    return toPhysical(info, raw(info));
}

std::string RegisterReader::text(const RegisterInfo& info) const
{
    std::string result;
    for (std::uint16_t i = 0; i < info.count; ++i) {
        const std::uint16_t pair = at(static_cast<std::uint16_t>(info.address + i));
        result += static_cast<char>(pair >> 8);
        result += static_cast<char>(pair & 0xFFu);
    }
    return result.substr(0, result.find('\0'));
}

std::uint16_t RegisterReader::u16(std::string_view name) const
{
    return static_cast<std::uint16_t>(raw(registerNamed(name)));
}

std::uint32_t RegisterReader::u32(std::string_view name) const
{
    return static_cast<std::uint32_t>(raw(registerNamed(name)));
}

std::int32_t RegisterReader::i32(std::string_view name) const
{
    return static_cast<std::int32_t>(raw(registerNamed(name)));
}

tl::expected<void, CodecError> RegisterWriter::physical(const RegisterInfo& info, double value)
{
    return toRaw(info, value).map([&](std::int64_t raw) {
        const auto index = static_cast<std::size_t>(info.address - m_base);
        assert(info.address >= m_base && index + info.count <= m_registers.size());
        const auto bits = static_cast<std::uint32_t>(raw);
        if (info.count == 2)
            m_registers[index] = static_cast<std::uint16_t>(bits >> 16);
        m_registers[index + info.count - 1u] = static_cast<std::uint16_t>(bits & 0xFFFFu);
    });
}

void RegisterWriter::text(std::string_view name, std::string_view value)
{
    const RegisterInfo& info = registerNamed(name);
    const std::string_view kept = fittingUtf8(value, 2u * info.count);
    const auto byteAt = [kept](std::size_t i) {
        return i < kept.size() ? static_cast<std::uint8_t>(kept[i]) : std::uint8_t{0};
    };
    for (std::size_t i = 0; i < info.count; ++i) {
        m_registers[static_cast<std::size_t>(info.address - m_base) + i] =
            static_cast<std::uint16_t>((byteAt(2 * i) << 8) | byteAt(2 * i + 1));
    }
}

std::string_view fittingUtf8(std::string_view value, std::size_t bytes)
{
    if (value.size() <= bytes)
        return value;
    std::size_t end = bytes;
    while (end > 0 && (static_cast<std::uint8_t>(value[end]) & 0xC0u) == 0x80u)
        --end;
    return value.substr(0, end);
}

} // namespace campanel::modbus
