// SPDX-License-Identifier: Apache-2.0
// The table as the paper makes it (k_i = f_i * slice time, f_i at the slice's end, rows reversed for the way
// back), to show beside ours what that costs.
#pragma once

#include "profile/cutter/rotary_cutter.h"

namespace campanel::profile {

struct PaperTable {
    double pulses = 0;      // sum of all its k_i over one cycle
    double errorPulses = 0; // the same minus the pulses of one cycle
    double errorMm = 0;     // of knife travel
};

[[nodiscard]] PaperTable paperTable(const RotaryCutter& cutter, int slicesPerRamp);

} // namespace campanel::profile
