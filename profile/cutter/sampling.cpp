// SPDX-License-Identifier: Apache-2.0
// Samples each segment separately, so that a joint keeps its value before and after.
#include "profile/cutter/sampling.h"

#include "profile/model/bounds.h"

#include <cmath>

namespace campanel::profile {

Curves sampleCurves(const MotionProfile& motion, double pulsesPerMm, std::size_t points)
{
    const std::size_t intervals = maxOf<std::size_t>(points, 2) - 1;
    const double total = motion.durationS();
    const auto segments = motion.segments();

    Curves curves;
    const std::size_t capacity = intervals + 1 + 2 * segments.size();
    for (auto* array : {&curves.timeS, &curves.positionMm, &curves.velocityMmPerS,
                        &curves.accelerationMmPerS2, &curves.jerkMmPerS3, &curves.frequencyHz})
        array->reserve(capacity);

    const auto append = [&](const Segment& segment, double timeS) {
        const MotionPoint p = segment.at(timeS);
        curves.timeS.push_back(timeS);
        curves.positionMm.push_back(p.positionMm);
        curves.velocityMmPerS.push_back(p.velocityMmPerS);
        curves.accelerationMmPerS2.push_back(p.accelerationMmPerS2);
        curves.jerkMmPerS3.push_back(p.jerkMmPerS3);
        curves.frequencyHz.push_back(p.velocityMmPerS * pulsesPerMm);
    };
    std::size_t next = 1; // index in the even grid, whose first and last points are ends of segments
    for (const Segment& segment : segments) {
        append(segment, segment.startS);
        for (; next < intervals; ++next) {
            const double timeS = total * static_cast<double>(next) / static_cast<double>(intervals);
            if (timeS >= segment.endS())
                break;
            if (timeS > segment.startS)
                append(segment, timeS);
        }
        append(segment, segment.endS());
    }
    return curves;
}

Curves sampleCurves(const RotaryCutter& cutter, std::size_t points)
{
    Curves curves = sampleCurves(cutter.motion, pulsesPerMm(cutter.machine), points);
    addTorque(curves, knifeLoad(cutter.machine));
    return curves;
}

void addTorque(Curves& curves, const TorqueLoad& load)
{
    constexpr double restShare = 1e-9; // of the largest speed: the rounding of a standstill has no direction
    curves.torqueNm.clear();
    if (!load.isKnown())
        return;
    Extent speeds;
    for (const double speed : curves.velocityMmPerS)
        speeds.add(std::abs(speed));
    const auto speedAt = [&](std::size_t i) {
        const double speed = curves.velocityMmPerS[i];
        return std::abs(speed) > restShare * speeds.max ? speed : 0;
    };
    // Where a motion starts or comes to rest, friction has the direction of the motion beside it.
    const auto directionAt = [&](std::size_t i) {
        if (speedAt(i) != 0 || curves.accelerationMmPerS2[i] == 0)
            return speedAt(i);
        const bool ends = i + 1 == curves.timeS.size() || curves.timeS[i + 1] == curves.timeS[i];
        return ends ? (i > 0 ? speedAt(i - 1) : 0) : speedAt(i + 1);
    };
    curves.torqueNm.reserve(curves.timeS.size());
    for (std::size_t i = 0; i < curves.timeS.size(); ++i)
        curves.torqueNm.push_back(load.at(directionAt(i), curves.accelerationMmPerS2[i]));
}

} // namespace campanel::profile
