// SPDX-License-Identifier: Apache-2.0
// Checks of the inputs of a point cam before anything is computed from them. Internal to profile/.
#pragma once

#include "profile/cam/point_cam.h"

#include <cstddef>
#include <optional>

namespace campanel::profile::detail {

// Angles this close are one.
inline constexpr double angleToleranceDeg = 1e-9;

// The first thing that is wrong with the inputs, without suggestions; nothing when all are in order.
[[nodiscard]] std::optional<Refusal> findInvalid(const PointCamProgram& program, const Machine& machine);

// The refusal of a knot, by its index.
[[nodiscard]] Refusal knotRefusal(Limit limit, std::size_t index, double actual, double allowed,
                                  std::string_view unit);

} // namespace campanel::profile::detail
