// SPDX-License-Identifier: Apache-2.0
// One value of an enumeration of the protocol: its number, its key and its texts.
#pragma once

#include <cstdint>
#include <string_view>

namespace campanel::modbus {

struct EnumValue {
    std::string_view name; // as in the enum class
    std::uint16_t value = 0;
    // The text on the screen: a sentence, or a label without a full stop; translated where it is marked. The
    // panel shows nothing where it is empty.
    std::string_view text;
    std::string_view detail{}; // further text for the register document
    std::string_view number{}; // for %1 in the text: a number, or the register that has it
};

template <typename E>
constexpr EnumValue entry(E value, std::string_view name, std::string_view text, std::string_view detail = {},
                          std::string_view number = {})
{
    return {name, static_cast<std::uint16_t>(value), text, detail, number};
}

} // namespace campanel::modbus
