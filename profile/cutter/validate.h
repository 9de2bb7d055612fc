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

// Returns the first fault of the data of an axis other than the knife axis.
[[nodiscard]] std::optional<Refusal> findInvalidAxis(const Machine& machine);

enum class LawUse : std::uint8_t { Speed, Displacement };

// Returns the refusal of a law that does not exist or does not serve that use, or of a parameter outside its
// range.
[[nodiscard]] std::optional<Refusal> findInvalidLaw(LawId id, const LawParameters& parameters, LawUse use);

[[nodiscard]] Refusal outOfRange(Field field, double value);

} // namespace campanel::profile::detail
