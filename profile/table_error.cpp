// SPDX-License-Identifier: Apache-2.0
// Walks the slices beside the curve. Within a slice the table is straight, so its distance to the curve is
// largest where the speeds agree; the slices are short enough to find that place by interpolation.
#include "profile/table_error.h"

#include <algorithm>
#include <cmath>

namespace campanel::profile {
namespace {

// Keeps the larger magnitude and where it was seen.
void keepLargest(double candidate, double timeS, double& largest, double& largestTimeS)
{
    if (std::abs(candidate) <= largest)
        return;
    largest = std::abs(candidate);
    largestTimeS = timeS;
}

struct SliceView {
    double startS = 0;
    double endS = 0;
    double speedMmPerS = 0; // of the table
    double pulsesBefore = 0;
};

} // namespace

TableErrors tableErrors(const RotaryCutter& cutter, std::span<const TableSlice> slices)
{
    TableErrors errors;
    if (slices.empty())
        return errors;
    const double clock = cutter.machine.timerClockHz;
    const double perMm = pulsesPerMm(cutter.machine);
    const auto frequency = [clock](const TableSlice& s) {
        return static_cast<double>(s.pulses) / static_cast<double>(s.ticks) * clock;
    };
    double squares = 0; // integral of the squared position error
    std::int64_t pulsesBefore = 0;
    const TableSlice* last = &slices.back();
    for (const TableSlice& slice : slices) {
        const Segment& segment = cutter.motion.segments()[slice.segment];
        const SliceView view{static_cast<double>(slice.startTick) / clock,
                             static_cast<double>(slice.startTick + slice.ticks) / clock,
                             frequency(slice) / perMm, static_cast<double>(pulsesBefore)};
        const auto positionError = [&](double timeS, const MotionPoint& p) {
            return view.pulsesBefore + (view.speedMmPerS * (timeS - view.startS) - p.positionMm) * perMm;
        };
        const MotionPoint atStart = segment.at(view.startS);
        const MotionPoint atEnd = segment.at(view.endS);
        const double v0 = atStart.velocityMmPerS;
        const double v1 = atEnd.velocityMmPerS;
        keepLargest(view.speedMmPerS - v0, view.startS, errors.speedMmPerS, errors.speedTimeS);
        keepLargest(view.speedMmPerS - v1, view.endS, errors.speedMmPerS, errors.speedTimeS);
        keepLargest(frequency(slice) - frequency(*last), view.startS, errors.frequencyStepHz,
                    errors.frequencyStepTimeS);

        const double errorStart = positionError(view.startS, atStart);
        const double errorEnd = positionError(view.endS, atEnd);
        double errorMiddle = (errorStart + errorEnd) / 2;
        keepLargest(errorEnd, view.endS, errors.boundaryPulses, errors.boundaryTimeS);
        keepLargest(errorEnd, view.endS, errors.insidePulses, errors.insideTimeS);
        if (v0 != v1) {
            const double middleS = (view.startS + view.endS) / 2;
            errorMiddle = positionError(middleS, segment.at(middleS));
            const double share = std::clamp((view.speedMmPerS - v0) / (v1 - v0), 0.0, 1.0);
            const double worstS = view.startS + share * (view.endS - view.startS);
            keepLargest(positionError(worstS, segment.at(worstS)), worstS, errors.insidePulses,
                        errors.insideTimeS);
        }
        // Simpson's rule over the slice.
        squares += (errorStart * errorStart + 4 * errorMiddle * errorMiddle + errorEnd * errorEnd) / 6 *
                   (view.endS - view.startS);
        pulsesBefore += slice.pulses;
        last = &slice;
    }
    errors.rmsPulses = std::sqrt(squares / cutter.cycle.cycleTimeS);
    errors.speedPercent =
        100 * errors.speedMmPerS / std::max(cutter.cycle.baseSpeedMmPerS, cutter.cycle.filmSpeedMmPerS);
    return errors;
}

} // namespace campanel::profile
