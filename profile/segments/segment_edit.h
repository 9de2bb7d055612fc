// SPDX-License-Identifier: Apache-2.0
// Edits the segments of a cam. What passes checkSegments() before an edit passes it afterwards, on the
// controller's grid.
#pragma once

#include "profile/segments/segment_cam.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace campanel::profile {

// Returns the segments on the controller's grid. Values that a motion does not use become 0, and a dwell ends
// where it begins.
[[nodiscard]] std::vector<CamSegment> onSegmentGrid(std::span<const CamSegment> segments);

// Returns the cam without an advance, whatever it was: the last segment that changes its position ends where
// the cycle began.
[[nodiscard]] SegmentCamProgram closed(SegmentCamProgram program);

// Returns the cam with segments that follow each other from 0 to 360 degrees, and without a closing error
// and without a jump of speed or acceleration at any joint. A segment gives way to a neighbor in this order:
// polynomials and laws that begin or end with an acceleration, other laws, constant speed, dwell. It becomes
// a polynomial of the fifth degree; its end position stays.
[[nodiscard]] SegmentCamProgram repaired(SegmentCamProgram program);

// Divides a segment at its middle, and keeps the curve: exactly for polynomials, constant speed and dwell; of
// a law the values at the ends of both parts. Returns the index of the second part, or nothing when the
// segment is too narrow or there are 40.
std::optional<std::size_t> splitSegment(SegmentCamProgram& program, std::size_t index);

// Inserts a dwell in the second half of a segment, at its end position. Returns the index of the dwell, or
// nothing as splitSegment().
std::optional<std::size_t> insertDwell(SegmentCamProgram& program, std::size_t index);

// Removes a segment; a neighbor takes its place in the cycle, so that all others keep their curves. Returns
// false for the only one or an invalid index.
bool removeSegment(SegmentCamProgram& program, std::size_t index);

// Moves the end of a segment as near to the wanted place as its neighbors and the grid allow. The last one
// stays at 360 degrees. The end of a dwell moves all of it. Within the closing error the end of the cycle
// snaps to its beginning.
void moveSegmentEnd(SegmentCamProgram& program, std::size_t index, double masterDeg, double slaveMm);

// Sets the motion of a segment. A polynomial begins and ends as the motion before it did.
void setSegmentMotion(SegmentCamProgram& program, std::size_t index, SegmentMotion motion);

} // namespace campanel::profile
