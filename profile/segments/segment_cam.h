// SPDX-License-Identifier: Apache-2.0
// The cam of segments: the cycle of a virtual master is divided into segments, each with a motion of its own.
// It is executed as cam points, like a cam through knots.
#pragma once

#include "profile/cam/cam_cycle.h"
#include "profile/model/axis_motion.h"
#include "profile/program/programs.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

inline constexpr std::size_t maxSegments = 40;
// The limits of the magnitudes at a boundary, and the grids of the controller.
inline constexpr double maxBoundarySpeedMmPerDeg = 2000;
inline constexpr double boundarySpeedStepMmPerDeg = 1e-6;
inline constexpr double maxBoundaryAccelerationMmPerDeg2 = 200;
inline constexpr double boundaryAccelerationStepMmPerDeg2 = 1e-7;

// A motion that a segment may have: a new displacement law is one more of them.
struct SegmentMotionInfo {
    SegmentMotion motion = SegmentMotion::Dwell;
    std::string_view key; // in the recipe file
    std::string_view name;
    const Law* law = nullptr; // only for a displacement law
    // The derivatives that are entered at both ends: 0 none, 1 the speeds, 2 the accelerations as well.
    int boundaryOrder = 0;
};

[[nodiscard]] std::span<const SegmentMotionInfo> segmentMotions();
// Returns the row, or null.
[[nodiscard]] const SegmentMotionInfo* findSegmentMotion(SegmentMotion motion);
[[nodiscard]] const SegmentMotionInfo* findSegmentMotion(std::string_view key);

// Returns the first fault of the segments: SegmentCount, SegmentRange, SegmentMotion, LawParameter,
// SegmentWidth, SegmentOverlap, SegmentGap, SegmentEnds.
[[nodiscard]] std::optional<Refusal> checkSegments(std::span<const CamSegment> segments);

// One segment as a curve: slave mm over master degrees, before scaling. A law is no polynomial and keeps its
// distance; the third derivative and those above are those at the start.
struct SegmentPiece {
    double start = 0; // degrees
    double width = 0;
    double startMm = 0;
    double distanceMm = 0;
    SegmentBoundary boundary;  // at the start
    double thirdMmPerDeg3 = 0; // at the start, of a polynomial
    double fourthMmPerDeg4 = 0;
    double fifthMmPerDeg5 = 0;
    const Law* law = nullptr;
    LawParameters lawParameters{};

    [[nodiscard]] double end() const { return start + width; }
    [[nodiscard]] SplinePoint at(double masterDeg) const;
};

// Returns the curve of valid segments, one piece for each.
[[nodiscard]] std::vector<SegmentPiece> segmentPieces(std::span<const CamSegment> segments);

// Returns the slave positions at the beginnings of the segments, and at the end of the cycle. A closing error
// is closed: the last segment that changes its position ends at 0.
[[nodiscard]] std::vector<double> jointPositionsMm(std::span<const CamSegment> segments);

// The change of the curve where a segment begins: behind the joint minus before it, before scaling.
struct SegmentJoint {
    double masterDeg = 0;
    double speedMmPerDeg = 0; // 0 within the rounding of the terms that it is computed from
    double accelerationMmPerDeg2 = 0;
    bool isSmooth = true; // the changes are at most one step of the controller's grid
};

// Returns the joints by the segment that begins there; joint 0 is the wrap. The segments must pass
// checkSegments().
[[nodiscard]] std::vector<SegmentJoint> segmentJoints(const SegmentCamProgram& program);

// Returns the net advance of a cycle in mm, before scaling: the end of the last segment, 0 within the closing
// error.
[[nodiscard]] double netAdvanceMm(const SegmentCamProgram& program);
// Returns the entered end of the last segment where that is a closing error, which the curve does not have;
// else 0.
[[nodiscard]] double closingErrorMm(const SegmentCamProgram& program);

// Returns one cam cycle from the phase on with a forward master, regardless of the sign of the rate.
[[nodiscard]] MotionProfile forwardMotion(const SegmentCamProgram& program);

// Returns one cam cycle in time, from the phase on, backward at a negative rate. The position is slave *
// slaveScale. Refusals: FieldRange, NoMotion (master rate or slave scale is 0, or every segment stands),
// those of checkSegments(). `broken` lists limits of the axis, and JointJump when a speed step exceeds the
// maximum acceleration or torque (mm/s). The step is spread over one update of the master, and the peaks
// include it. The nearest master rate is added when it alone corrects everything.
[[nodiscard]] tl::expected<AxisMotion, Refusal> solve(const SegmentCamProgram& program,
                                                      const Machine& machine);

namespace detail {

// Returns the positions of the joints as entered, with their closing error.
[[nodiscard]] std::vector<double> enteredPositionsMm(std::span<const CamSegment> segments);
// Sets the last position, and those before it that are the same, to 0.
void closePositions(std::vector<double>& positionsMm);

} // namespace detail
} // namespace campanel::profile
