// SPDX-License-Identifier: Apache-2.0
// The rounding tolerance of every comparison with a limit. Internal to profile/.
#pragma once

namespace campanel::profile::detail {

// The relative amount by which a value may exceed a limit: the rounding of a value that meets it exactly.
inline constexpr double limitTolerance = 1e-9;

} // namespace campanel::profile::detail
