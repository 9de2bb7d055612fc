// SPDX-License-Identifier: Apache-2.0
// Checks of the inputs, one by one, before anything is computed from them. Internal to profile/.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <optional>

namespace campanel::profile::detail {

// The first thing that is wrong with the inputs, without suggestions; nothing when all are in order.
[[nodiscard]] std::optional<Refusal> findInvalid(const RotaryCutterProgram& program, const Machine& machine);

// The first thing that is wrong with the machine as an axis other than the knife's.
[[nodiscard]] std::optional<Refusal> findInvalidAxis(const Machine& machine);

enum class LawUse : std::uint8_t { Speed, Displacement };

// A law that does not exist or does not serve that use, or a parameter outside its range.
[[nodiscard]] std::optional<Refusal> findInvalidLaw(LawId id, const LawParameters& parameters, LawUse use);

// The refusal of a value outside its field's range.
[[nodiscard]] Refusal outOfRange(Field field, double value);

} // namespace campanel::profile::detail
