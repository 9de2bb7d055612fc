// SPDX-License-Identifier: Apache-2.0
// The table as defined in the paper (k_i = f_i * slice time, f_i at the slice's end, rows reversed for the
// return). It is shown beside our table to compare the errors.
#pragma once

#include "profile/cutter/rotary_cutter.h"

namespace campanel::profile {

struct PaperTable {
    double pulses = 0;      // sum of all k_i over one cycle
    double errorPulses = 0; // the sum minus the pulses of one cycle
    double errorMm = 0;     // knife travel
};

[[nodiscard]] PaperTable paperTable(const RotaryCutter& cutter, int slicesPerRamp);

} // namespace campanel::profile
