// SPDX-License-Identifier: Apache-2.0
// Widens the synchronous window until it holds the sealing jaws. Internal to profile/.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <optional>

namespace campanel::profile::detail {

// Returns the ratios whose window is sigma = A' / (c L), A' = R (theta_c + 2 degrees), around the present
// middle of the window. k1 and k4 change when a ramp would be shorter than 1 % of the cycle, or too steep for
// the machine. Where no ratios work at the present rate, the suggestion also has the fastest rate with which
// they do. Returns nothing when the jaws do not fit.
[[nodiscard]] std::optional<Suggestion> widenedWindow(const RotaryCutterProgram& program,
                                                      const Machine& machine);

} // namespace campanel::profile::detail
