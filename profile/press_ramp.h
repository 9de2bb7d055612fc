// SPDX-License-Identifier: Apache-2.0
// What the press's curve and its table share. Internal to profile/.
#pragma once

#include "profile/machine.h"
#include "profile/refusal.h"

#include <cstdint>

namespace campanel::profile::detail {

// Milliseconds from standstill to this speed: the least whole number, at least 1, with which acceleration and
// torque stay within the machine's.
[[nodiscard]] std::int64_t pressRampMs(double speedMmPerS, const Machine& machine);

[[nodiscard]] Refusal stageOrder(Field field, double actual, double allowed);

} // namespace campanel::profile::detail
