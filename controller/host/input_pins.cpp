// SPDX-License-Identifier: Apache-2.0
#include "input_pins.h"

#include "ctl_registers.h"

#include <algorithm>
#include <array>

namespace campanel::controller {
namespace {

struct Pin {
    std::string_view name;
    unsigned bit = 0;
};

#define CONTACT(name, bit, address) Pin{name, bit},
constexpr std::array settablePins{CTL_CONTACTS(CONTACT)};
#undef CONTACT

std::optional<unsigned> bitOf(std::string_view name)
{
    const auto found = std::ranges::find(settablePins, name, &Pin::name);
    return found == settablePins.end() ? std::nullopt : std::optional(found->bit);
}

} // namespace

std::string pinNames()
{
    std::string names;
    for (const Pin& pin : settablePins)
        names.append(names.empty() ? "" : ", ").append(pin.name);
    return names;
}

std::optional<PinStatement> parsePinStatement(std::string_view text)
{
    const std::size_t space = std::min(text.find(' '), text.size());
    const std::string_view level = text.substr(std::min(space + 1, text.size()));
    const auto bit = bitOf(text.substr(0, space));
    if (!bit || (level != "on" && level != "off"))
        return std::nullopt;
    return PinStatement{*bit, level == "on"};
}

std::optional<std::uint16_t> parsePins(std::string_view names)
{
    unsigned bits = 0;
    for (;;) {
        const std::size_t comma = names.find(',');
        const auto bit = bitOf(names.substr(0, comma));
        if (!bit)
            return std::nullopt;
        bits |= 1u << *bit;
        if (comma == std::string_view::npos)
            return static_cast<std::uint16_t>(bits);
        names.remove_prefix(comma + 1);
    }
}

} // namespace campanel::controller
