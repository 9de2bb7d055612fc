// SPDX-License-Identifier: Apache-2.0
// The common part of all cams that follow a virtual master: the cycle in time, jumps of the speed, the checks
// of the axis, and the nearest master rate.
#pragma once

#include "profile/cam/spline.h"
#include "profile/model/axis_motion.h"
#include "profile/model/bounds.h"
#include "profile/program/programs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

inline constexpr double camCycleDeg = 360;
inline constexpr double masterStepDeg = 1e-4; // grid of a knot or joint in the controller
inline constexpr double slaveStepMm = 1e-3;
inline constexpr double maxSlaveMm = info(Field::Distance).max; // limit of the magnitude
inline constexpr double minMasterSpacingDeg = 0.1;              // between two knots or joints
// The share of a cam's span up to which a difference between its two ends is a closing error: curve and table
// end where they began. A larger difference is the net advance of a progressive cam.
inline constexpr double closingShare = 0.01;
// The interval, in seconds, at which the master's position is updated. The slave's pulses are spread evenly
// over it.
inline constexpr double masterUpdateS = 0.002;

// Returns the seconds of one cam cycle at full speed: 60 / |rate| * masterRatio * masterScale. Infinite at
// rate 0.
[[nodiscard]] double camCycleS(const CamMaster& master);

namespace detail {

// The difference up to which two angles are equal.
inline constexpr double angleToleranceDeg = 1e-9;

// A speed step of the curve at an angle, before scaling: the speed behind it minus the speed before it.
struct SpeedStep {
    double masterDeg = 0;
    double speedMmPerDeg = 0;
};

// Returns the net advance of a cam whose ends differ by this much: 0 for a closing error.
[[nodiscard]] double withoutClosingError(double differenceMm, double spanMm);

// Returns the value on the grid of a knot or joint: 1e-4 degrees, 1e-3 mm within the range, or another grid.
[[nodiscard]] double onStep(double value, double step);
[[nodiscard]] double slaveOnGrid(double slaveMm);
// Returns the grid angle nearest to `wantedDeg` that is far enough from both neighbors, if there is one.
[[nodiscard]] std::optional<double> masterBetween(double beforeDeg, double afterDeg, double wantedDeg);

[[nodiscard]] double phaseWithinCycleDeg(const CamMaster& master);
// Returns degrees of the cam per second, negative at a negative rate.
[[nodiscard]] double camDegPerS(const CamMaster& master);
// Returns the time from the start of the cycle, at the phase, to this angle.
[[nodiscard]] double timeOfAngleS(const CamMaster& master, double angleDeg);

// Returns one cycle from the phase on. degPerS is negative for backward motion. `pieces` ascend and cover the
// cycle; each has start and end(). add(motion, piece, fromDeg, toDeg) appends a part of one.
template <typename Piece, typename Add>
MotionProfile camCycleMotion(const CamMaster& master, double degPerS, std::span<const Piece> pieces,
                             double startMm, Add add)
{
    const double phase = phaseWithinCycleDeg(master);
    MotionProfile motion;
    motion.setStartPosition(startMm);
    const auto addWithin = [&](const Piece& piece, double low, double high) {
        const double from = maxOf(piece.start, low);
        const double to = minOf(piece.end(), high);
        if (to - from > angleToleranceDeg)
            add(motion, piece, degPerS > 0 ? from : to, degPerS > 0 ? to : from);
    };
    // Two passes over the pieces: the part after the phase in the first, the part before it in the second.
    if (degPerS > 0) {
        for (const Piece& piece : pieces)
            addWithin(piece, phase, camCycleDeg);
        for (const Piece& piece : pieces)
            addWithin(piece, 0, phase);
    } else {
        for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece)
            addWithin(*piece, 0, phase);
        for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece)
            addWithin(*piece, phase, camCycleDeg);
    }
    return motion;
}

// Returns the peaks of the motion and its exceeded limits. A speed step is spread over one update of the
// master; the peaks include it. `jump` is the limit that a step above the allowed one exceeds, `index` that
// of the step. `unmendable` is a fault that no rate corrects. Otherwise every refusal gets the nearest rate.
struct StepRule {
    Limit jump = Limit::WrapJump;
    bool isIndexed = false;
};
[[nodiscard]] AxisMotion solveCycle(const CamMaster& master, const Machine& machine, MotionProfile motion,
                                    std::span<const SpeedStep> steps, StepRule rule,
                                    std::optional<Refusal> unmendable);

// Returns the first fault of the axis or of the master, without suggestions.
[[nodiscard]] std::optional<Refusal> findInvalidMaster(const CamMaster& master, const Machine& machine);
// Returns the refusal of a cam without motion: no rate, no scale, or a flat curve.
[[nodiscard]] std::optional<Refusal> findNoMotion(const CamMaster& master, bool isFlat);
// Returns the refusal of a knot or segment.
[[nodiscard]] Refusal indexedRefusal(Limit limit, std::size_t index, double actual, double allowed,
                                     std::string_view unit);

// Solves a cam by its own findInvalid() and solveValid(). A refused field gets the nearest value when it
// alone makes the cam feasible.
template <typename Cam, typename FindInvalid, typename SolveValid>
tl::expected<AxisMotion, Refusal> solveCam(const Cam& cam, const Machine& machine, FindInvalid findInvalid,
                                           SolveValid solveValid)
{
    auto refusal = findInvalid(cam, machine);
    if (!refusal)
        return solveValid(cam, machine);
    if (refusal->limit == Limit::FieldRange) {
        Cam mended = cam;
        Machine mendedMachine = machine;
        const double inside =
            std::isfinite(refusal->actual) ? refusal->allowed : info(refusal->field).defaultValue;
        setValue(mended, refusal->field, inside);
        setValue(mendedMachine, refusal->field, inside);
        if (!findInvalid(mended, mendedMachine) && solveValid(mended, mendedMachine).broken.empty())
            refusal->nearest.push_back({refusal->field, inside});
    }
    return tl::unexpected(*std::move(refusal));
}

} // namespace detail
} // namespace campanel::profile
