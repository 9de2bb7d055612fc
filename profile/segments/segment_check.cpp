// SPDX-License-Identifier: Apache-2.0
// Checks the segments one by one, then how they follow each other. What is refused names the nearest value.
#include "profile/model/bounds.h"
#include "profile/segments/segment_cam.h"

#include "profile/cutter/validate.h"

#include <array>
#include <cmath>

namespace campanel::profile {
namespace {

using detail::angleToleranceDeg;
using detail::indexedRefusal;

// A number of a segment and the limits of its range.
struct SegmentNumber {
    std::string_view name;
    double value = 0;
    double min = 0;
    double max = 0;
    std::string_view unit;
};

std::optional<Refusal> checkNumbers(const CamSegment& segment, std::size_t index)
{
    constexpr double speed = maxBoundarySpeedMmPerDeg;
    constexpr double acceleration = maxBoundaryAccelerationMmPerDeg2;
    const std::array numbers{SegmentNumber{"from", segment.fromDeg, 0, camCycleDeg, "deg"},
                             SegmentNumber{"to", segment.toDeg, 0, camCycleDeg, "deg"},
                             SegmentNumber{"end", segment.endMm, -maxSlaveMm, maxSlaveMm, "mm"},
                             SegmentNumber{"speed", segment.start.speedMmPerDeg, -speed, speed, "mm/deg"},
                             SegmentNumber{"speed", segment.end.speedMmPerDeg, -speed, speed, "mm/deg"},
                             SegmentNumber{"acceleration", segment.start.accelerationMmPerDeg2, -acceleration,
                                           acceleration, "mm/deg^2"},
                             SegmentNumber{"acceleration", segment.end.accelerationMmPerDeg2, -acceleration,
                                           acceleration, "mm/deg^2"}};
    for (const SegmentNumber& number : numbers) {
        if (number.value >= number.min && number.value <= number.max)
            continue;
        const double nearest =
            std::isfinite(number.value) ? clamped(number.value, number.min, number.max) : 0;
        Refusal refusal = indexedRefusal(Limit::SegmentRange, index, number.value, nearest, number.unit);
        refusal.lawParameter = number.name;
        return refusal;
    }
    return std::nullopt;
}

std::optional<Refusal> checkMotion(const CamSegment& segment, std::size_t index)
{
    const SegmentMotionInfo* motion = findSegmentMotion(segment.motion);
    if (motion == nullptr)
        return indexedRefusal(Limit::SegmentMotion, index, static_cast<double>(segment.motion),
                              static_cast<double>(SegmentMotion::Polynomial5), {});
    if (motion->law == nullptr)
        return std::nullopt;
    auto refusal =
        detail::findInvalidLaw(motion->law->id, segment.lawParameters, detail::LawUse::Displacement);
    if (refusal)
        refusal->index = static_cast<int>(index);
    return refusal;
}

} // namespace

std::optional<Refusal> checkSegments(std::span<const CamSegment> segments)
{
    if (segments.empty() || segments.size() > maxSegments)
        return indexedRefusal(Limit::SegmentCount, 0, static_cast<double>(segments.size()),
                              static_cast<double>(clamped(segments.size(), std::size_t{1}, maxSegments)), {});
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (auto refusal = checkNumbers(segments[i], i))
            return refusal;
        if (auto refusal = checkMotion(segments[i], i))
            return refusal;
    }
    double endDeg = 0; // of the segment before
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const CamSegment& segment = segments[i];
        const double ahead = segment.fromDeg - endDeg;
        if (std::abs(ahead) > angleToleranceDeg) {
            const Limit limit =
                i == 0 ? Limit::SegmentEnds : (ahead < 0 ? Limit::SegmentOverlap : Limit::SegmentGap);
            return indexedRefusal(limit, i, segment.fromDeg, endDeg, "deg");
        }
        if (segment.toDeg - segment.fromDeg < minMasterSpacingDeg - angleToleranceDeg)
            return indexedRefusal(Limit::SegmentWidth, i, segment.toDeg - segment.fromDeg,
                                  minMasterSpacingDeg, "deg");
        endDeg = segment.toDeg;
    }
    if (std::abs(endDeg - camCycleDeg) > angleToleranceDeg)
        return indexedRefusal(Limit::SegmentEnds, segments.size() - 1, endDeg, camCycleDeg, "deg");
    return std::nullopt;
}

} // namespace campanel::profile
