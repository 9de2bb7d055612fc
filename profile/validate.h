// SPDX-License-Identifier: Apache-2.0
// Checks of the inputs, one by one, before anything is computed from them. Internal to profile/.
#pragma once

#include "profile/rotary_cutter.h"

#include <optional>

namespace campanel::profile::detail {

// The first thing that is wrong with the inputs, without suggestions; nothing when all are in order.
[[nodiscard]] std::optional<Refusal> findInvalid(const RotaryCutterProgram& program, const Machine& machine);

// The refusal of a value outside its field's range.
[[nodiscard]] Refusal outOfRange(Field field, double value);

} // namespace campanel::profile::detail
