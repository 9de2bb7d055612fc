// SPDX-License-Identifier: Apache-2.0
// The numbers of a segment by their names, for recipe files and CSV.
#pragma once

#include "profile/segments/segment_cam.h"

#include <array>
#include <string_view>

namespace campanel::profile {

// A number of a segment; `number` gives access to it. A motion uses it when isUsed() is true.
struct SegmentValueInfo {
    std::string_view id; // in the recipe file and in the header of a CSV file
    double& (*number)(CamSegment& segment) = nullptr;
    bool (*isUsed)(const SegmentMotionInfo& motion) = nullptr;
};

inline constexpr std::array segmentEndValues{
    SegmentValueInfo{"end_mm", [](CamSegment& s) -> double& { return s.endMm; },
                     [](const SegmentMotionInfo& m) { return m.motion != SegmentMotion::Dwell; }},
    SegmentValueInfo{"start_speed_mm_per_deg", [](CamSegment& s) -> double& { return s.start.speedMmPerDeg; },
                     [](const SegmentMotionInfo& m) { return m.boundaryOrder > 0; }},
    SegmentValueInfo{"start_acceleration_mm_per_deg2",
                     [](CamSegment& s) -> double& { return s.start.accelerationMmPerDeg2; },
                     [](const SegmentMotionInfo& m) { return m.boundaryOrder > 1; }},
    SegmentValueInfo{"end_speed_mm_per_deg", [](CamSegment& s) -> double& { return s.end.speedMmPerDeg; },
                     [](const SegmentMotionInfo& m) { return m.boundaryOrder > 0; }},
    SegmentValueInfo{"end_acceleration_mm_per_deg2",
                     [](CamSegment& s) -> double& { return s.end.accelerationMmPerDeg2; },
                     [](const SegmentMotionInfo& m) { return m.boundaryOrder > 1; }},
    SegmentValueInfo{
        "law_parameter1", [](CamSegment& s) -> double& { return s.lawParameters[0]; },
        [](const SegmentMotionInfo& m) { return m.law != nullptr && !m.law->parameters.empty(); }},
    SegmentValueInfo{
        "law_parameter2", [](CamSegment& s) -> double& { return s.lawParameters[1]; },
        [](const SegmentMotionInfo& m) { return m.law != nullptr && m.law->parameters.size() > 1; }},
};

} // namespace campanel::profile
