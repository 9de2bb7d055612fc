// SPDX-License-Identifier: Apache-2.0
// Validates the inputs, one by one, before any computation. Internal to profile/.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <optional>

namespace campanel::profile::detail {

// Returns the first fault of the inputs, without suggestions; nothing when all are valid.
[[nodiscard]] std::optional<Refusal> findInvalid(const RotaryCutterProgram& program, const Machine& machine);

// Returns true when the ratios descend from k1 to k4.
[[nodiscard]] bool hasDescendingRatios(const RotaryCutterProgram& program);

enum class LawUse : std::uint8_t { Speed, Displacement };

// Returns the refusal of a law that does not exist or does not serve that use, or of a parameter outside its
// range.
[[nodiscard]] std::optional<Refusal> findInvalidLaw(LawId id, const LawParameters& parameters, LawUse use);

[[nodiscard]] Refusal outOfRange(Field field, double value);

// Returns the refusal of the first number that is outside its range; `isRead(member)` is false for one that
// the program does not use.
template <typename P, typename IsRead>
[[nodiscard]] std::optional<Refusal> findOutOfRange(const P& inputs, IsRead isRead)
{
    for (const Member<P>& member : membersOf<P>) {
        if (isRead(member) && !inRange(member.field, member.get(inputs)))
            return outOfRange(member.field, member.get(inputs));
    }
    return std::nullopt;
}

// Returns the first fault of the machine's data; `use` is one of machine_use, an axis also for a press.
[[nodiscard]] inline std::optional<Refusal> findInvalidMachine(const Machine& machine, unsigned use)
{
    return findOutOfRange(machine, [use](const Member<Machine>& member) { return (member.uses & use) != 0; });
}

} // namespace campanel::profile::detail
