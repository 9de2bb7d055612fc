// SPDX-License-Identifier: Apache-2.0
// Validates the inputs of a point cam before any computation. Internal to profile/.
#pragma once

#include "profile/cam/point_cam.h"

#include <cstddef>
#include <optional>

namespace campanel::profile::detail {

// The difference up to which two angles are equal.
inline constexpr double angleToleranceDeg = 1e-9;

// Returns the first fault of the inputs, without suggestions; nothing when all are valid.
[[nodiscard]] std::optional<Refusal> findInvalid(const PointCamProgram& program, const Machine& machine);

[[nodiscard]] Refusal knotRefusal(Limit limit, std::size_t index, double actual, double allowed,
                                  std::string_view unit);

} // namespace campanel::profile::detail
