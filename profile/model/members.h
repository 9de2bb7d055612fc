// SPDX-License-Identifier: Apache-2.0
// The members of a structure of numbers, one row each: which field is which member.
#pragma once

#include "profile/model/bounds.h"
#include "profile/model/fields.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <variant>

namespace campanel::profile {

// The four ratios k1 to k4 are one member.
using Ratios = std::array<double, 4>;

template <typename P> struct Member {
    Field field = Field::BagLength;
    std::variant<double P::*, int P::*, std::uint32_t P::*, Ratios P::*> at;
    unsigned uses = 0; // only for the machine's data: who has it, see MachineUse

    [[nodiscard]] constexpr bool isCount() const
    {
        return std::holds_alternative<int P::*>(at) || std::holds_alternative<std::uint32_t P::*>(at);
    }
    [[nodiscard]] constexpr double get(const P& inputs) const
    {
        return std::visit(
            [&](auto member) -> double {
                if constexpr (std::is_same_v<decltype(member), Ratios P::*>)
                    return (inputs.*member)[ratio()];
                else
                    return static_cast<double>(inputs.*member);
            },
            at);
    }
    // A count is rounded.
    constexpr void set(P& inputs, double value) const
    {
        std::visit(
            [&](auto member) {
                using T = decltype(member);
                if constexpr (std::is_same_v<T, Ratios P::*>)
                    (inputs.*member)[ratio()] = value;
                else if constexpr (std::is_same_v<T, double P::*>)
                    inputs.*member = value;
                else if constexpr (std::is_same_v<T, int P::*>)
                    inputs.*member = wholeOf(value);
                else
                    inputs.*member = static_cast<std::uint32_t>(maxOf(wholeOf(value), 0));
            },
            at);
    }

private:
    [[nodiscard]] constexpr std::size_t ratio() const
    {
        return static_cast<std::size_t>(field) - static_cast<std::size_t>(Field::K1);
    }
};

// The rows of a structure, in the order in which a person enters them; specialized beside each structure.
template <typename P> inline constexpr std::array<Member<P>, 0> membersOf{};

// Returns the fields of the rows for which `isWanted(row)` is true.
template <typename P, std::size_t count> [[nodiscard]] consteval auto fieldsOf(auto isWanted)
{
    std::array<Field, count> found{};
    std::size_t next = 0;
    for (const Member<P>& member : membersOf<P>) {
        if (isWanted(member))
            found[next++] = member.field;
    }
    return found;
}

template <typename P>
inline constexpr auto memberFields = fieldsOf<P, membersOf<P>.size()>([](const Member<P>&) { return true; });

// Returns the row of the field, or null when the structure does not have it.
template <typename P> [[nodiscard]] constexpr const Member<P>* memberOf(Field field)
{
    constexpr auto places = [] {
        std::array<const Member<P>*, fields.size()> result{};
        for (const Member<P>& member : membersOf<P>)
            result[static_cast<std::size_t>(member.field)] = &member;
        return result;
    }();
    return places[static_cast<std::size_t>(field)];
}

// Access by field. Another structure's field gives NaN and has no effect.
template <typename P> [[nodiscard]] double value(const P& inputs, Field field) requires(!membersOf<P>.empty())
{
    const Member<P>* member = memberOf<P>(field);
    return member == nullptr ? std::numeric_limits<double>::quiet_NaN() : member->get(inputs);
}

template <typename P> void setValue(P& inputs, Field field, double value) requires(!membersOf<P>.empty())
{
    if (const Member<P>* member = memberOf<P>(field))
        member->set(inputs, value);
}

} // namespace campanel::profile
