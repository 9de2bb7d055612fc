// SPDX-License-Identifier: Apache-2.0
// Validates the inputs of a point cam before any computation. Internal to profile/.
#pragma once

#include "profile/cam/point_cam.h"

#include <cstddef>
#include <optional>

namespace campanel::profile::detail {

// Returns the first fault of the inputs, without suggestions; nothing when all are valid.
[[nodiscard]] std::optional<Refusal> findInvalid(const PointCamProgram& program, const Machine& machine);

} // namespace campanel::profile::detail
