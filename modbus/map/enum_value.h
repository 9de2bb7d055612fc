// SPDX-License-Identifier: Apache-2.0
// One value of an enumeration of the protocol, with its name and its sentence for the generated documents.
#pragma once

#include <cstdint>
#include <string_view>

namespace campanel::modbus {

struct EnumValue {
    std::string_view name; // as in the enum class
    std::uint16_t value = 0;
    std::string_view text; // one sentence for the register document
};

template <typename E> constexpr EnumValue entry(E value, std::string_view name, std::string_view text)
{
    return {name, static_cast<std::uint16_t>(value), text};
}

} // namespace campanel::modbus
