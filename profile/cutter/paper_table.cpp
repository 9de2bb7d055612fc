// SPDX-License-Identifier: Apache-2.0
// Sums Table 1 of the paper. The return repeats the rows, so the error does not cancel.
#include "profile/cutter/paper_table.h"

namespace campanel::profile {

PaperTable paperTable(const RotaryCutter& cutter, int slicesPerRamp)
{
    const auto segments = cutter.motion.segments();
    const Segment& ramp = segments[1];
    const double sliceS = ramp.durationS / slicesPerRamp;
    const double toHz = pulsesPerMm(cutter.machine);
    PaperTable table;
    for (int i = 1; i <= slicesPerRamp; ++i)
        table.pulses += 2 * ramp.at(ramp.startS + i * sliceS).velocityMmPerS * toHz * sliceS;
    for (const Segment& segment : segments) {
        if (segment.law == nullptr)
            table.pulses += segment.startVelocityMmPerS * toHz * segment.durationS;
    }
    table.errorPulses = table.pulses - pulsesPerCycle(cutter.machine).asDouble();
    table.errorMm = table.errorPulses / toHz;
    return table;
}

} // namespace campanel::profile
