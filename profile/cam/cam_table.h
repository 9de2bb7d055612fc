// SPDX-License-Identifier: Apache-2.0
// The cam-point table that the controller interpolates: equal intervals of the master, a position and a slope
// at each end, in between the cubic with these slopes. For moves and point cams.
#pragma once

#include "profile/cam/point_cam.h"
#include "profile/model/machine.h"
#include "profile/model/motion_profile.h"
#include "profile/model/refusal.h"

#include <cstddef>
#include <cstdint>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

inline constexpr double camUnitsPerPulse = 256;

// In 1/256 pulse from the first row, and 1/256 pulse per interval.
struct CamRow {
    std::int32_t position256 = 0;
    std::int32_t slope256 = 0;

    bool operator==(const CamRow&) const = default;
};

struct CamTable {
    std::vector<CamRow> rows;     // intervals + 1
    std::uint32_t cycleTicks = 0; // round(duration * timer clock), the master at full speed
    // Net pulses per cycle, exact: advance.whole is the floor, also of a negative advance, and
    // 0 <= advance.remainder < advance.divisor. Whoever sums whole and remainder over cycles never drifts.
    PulsesPerCycle advance;
};

enum class CamUse : std::uint8_t {
    Once,    // a move: its own end speeds are the end slopes
    Repeats, // a cam: the slopes continue at the wrap where the motion itself does
};

// Positions are round(256 K / feed * (s(t_i) - s(0))); the slopes are those of the twice continuously
// differentiable spline through the unrounded positions. The net advance is taken on a grid of 1e-6 mm: knots
// have 3 decimals, and so has the slave scale. The motion has a duration and the machine valid axis data.
// Refusals: FieldRange (CamPoints outside 100..2000), TableRange (a value, the cycle's ticks or the divisor
// do not fit 32 bits; the field says which input is too large), MasterTooFast (two neighboring rows need more
// pulses per second than the output stage gives).
[[nodiscard]] tl::expected<CamTable, Refusal> buildCamTable(const MotionProfile& motion, int intervals,
                                                            const Machine& machine, CamUse use);

// The table of a solved point cam: of its forward motion, whatever the sign of the master rate. The nearest
// number of points is added where it mends FieldRange, the nearest master rate where it mends MasterTooFast.
[[nodiscard]] tl::expected<CamTable, Refusal> buildCamTable(const PointCamProgram& program,
                                                            const Machine& machine);

// The position at a share 0..1 of interval `index`, in 1/256 pulse from the first row, and its derivative per
// interval.
struct CamPoint {
    double position256 = 0;
    double slope256 = 0;
};
[[nodiscard]] CamPoint interpolate(const CamTable& table, std::size_t index, double share);

// How far the interpolated rows are from the motion they were made of, at the same share of the cycle. No
// error of position or speed is larger than stated here; what is stated is too large by some parts in a
// thousand at most. The whole pulses that come out of it add half a pulse of granularity.
struct CamErrors {
    double positionPulses = 0;
    double positionMm = 0;
    double positionTimeS = 0;
    double speedMmPerS = 0;
    double speedTimeS = 0;
    double wrapSpeedStepMmPerS = 0; // of a table that repeats; at the rows inside there is none
};

// table must have been built of this motion for this machine.
[[nodiscard]] CamErrors camErrors(const CamTable& table, const MotionProfile& motion, const Machine& machine,
                                  CamUse use);

} // namespace campanel::profile
