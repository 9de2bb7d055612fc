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
        const double startS = static_cast<double>(slice.startTick) / clock;
        const double endS = static_cast<double>(slice.startTick + slice.ticks) / clock;
        const double speed = frequency(slice) / perMm;
        // Looks at one moment of the slice; returns the position error in pulses.
        const auto look = [&](double timeS, const MotionPoint& p) {
            const double ahead =
                static_cast<double>(pulsesBefore) + (speed * (timeS - startS) - p.positionMm) * perMm;
            keepLargest(speed - p.velocityMmPerS, timeS, errors.speedMmPerS, errors.speedTimeS);
            keepLargest(ahead, timeS, errors.insidePulses, errors.insideTimeS);
            return ahead;
        };
        const MotionPoint atStart = cutter.motion.at(startS);
        const MotionPoint atEnd = cutter.motion.at(endS);
        const double middleS = (startS + endS) / 2;
        const double errorStart = look(startS, atStart);
        const double errorMiddle = look(middleS, cutter.motion.at(middleS));
        const double errorEnd = look(endS, atEnd);
        keepLargest(errorEnd, endS, errors.boundaryPulses, errors.boundaryTimeS);
        keepLargest(frequency(slice) - frequency(*last), startS, errors.frequencyStepHz,
                    errors.frequencyStepTimeS);
        for (const Segment& segment : cutter.motion.segments()) {
            if (segment.startS > startS && segment.startS < endS)
                look(segment.startS, cutter.motion.at(segment.startS));
        }
        const double change = atEnd.velocityMmPerS - atStart.velocityMmPerS;
        if (change != 0) {
            const double share = std::clamp((speed - atStart.velocityMmPerS) / change, 0.0, 1.0);
            const double agreeS = startS + share * (endS - startS);
            look(agreeS, cutter.motion.at(agreeS));
        }
        // The square of the parabola through the three errors, integrated.
        squares += (2 * errorStart * errorStart + 8 * errorMiddle * errorMiddle + 2 * errorEnd * errorEnd +
                    2 * errorMiddle * (errorStart + errorEnd) - errorStart * errorEnd) /
                   15 * (endS - startS);
        pulsesBefore += slice.pulses;
        last = &slice;
    }
    errors.rmsPulses = std::sqrt(squares / cutter.cycle.cycleTimeS);
    errors.speedPercent =
        100 * errors.speedMmPerS / std::max(cutter.cycle.baseSpeedMmPerS, cutter.cycle.filmSpeedMmPerS);
    return errors;
}

} // namespace campanel::profile
