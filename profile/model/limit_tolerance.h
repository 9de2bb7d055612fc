// SPDX-License-Identifier: Apache-2.0
// The room that every comparison with a limit leaves for rounding. Internal to profile/.
#pragma once

namespace campanel::profile::detail {

// A value may pass a limit by this relative amount: the rounding of a value that meets it exactly.
inline constexpr double limitTolerance = 1e-9;

} // namespace campanel::profile::detail
