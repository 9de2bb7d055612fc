// SPDX-License-Identifier: Apache-2.0
// The cam-point table that the controller interpolates, for moves and point cams. Each row has a position and
// a slope; rows are equal master intervals apart. The curve between two rows is the cubic with these slopes.
#pragma once

#include "profile/model/machine.h"
#include "profile/model/motion_profile.h"
#include "profile/model/refusal.h"
#include "profile/program/programs.h"

#include <cstddef>
#include <cstdint>
#include <tl/expected.hpp>
#include <type_traits>
#include <vector>

namespace campanel::profile {

inline constexpr double camUnitsPerPulse = 256;

// The position in 1/256 pulse from the first row, and the slope in 1/256 pulse per interval.
struct CamRow {
    std::int32_t position256 = 0;
    std::int32_t slope256 = 0;

    bool operator==(const CamRow&) const = default;
};

struct CamTable {
    std::vector<CamRow> rows;     // intervals + 1
    std::uint32_t cycleTicks = 0; // round(duration * timer clock), at full master speed
    // The exact net pulses per cycle. advance.whole is the floor, also for a negative advance, and 0 <=
    // advance.remainder < advance.divisor. Summing whole and remainder over the cycles never drifts.
    PulsesPerCycle advance;
};

enum class CamUse : std::uint8_t {
    Once,    // a move: the end slopes are its own end speeds
    Repeats, // a cam: the slopes continue at the wrap where the motion itself continues
};

// Builds the table of a motion. Positions are round(256 K / feed * (s(t_i) - s(0))). The slopes are those of
// the twice continuously differentiable spline through the unrounded positions. The net advance is rounded to
// 1e-6 mm: the ends of a cam have 3 decimals, and so has the slave scale. The motion must have a duration,
// and the machine valid axis data. Refusals: FieldRange (CamPoints outside 100..2000); TableRange (a value,
// the ticks of the cycle or the divisor do not fit 32 bits; the field says which input is too large);
// MasterTooFast (two neighboring rows need more pulses per second than the output stage gives).
[[nodiscard]] tl::expected<CamTable, Refusal> buildCamTable(const MotionProfile& motion, int intervals,
                                                            const Machine& machine, CamUse use);

// Builds the table of a solved cam from its forward motion, regardless of the sign of the master rate. The
// advance is that of the cam itself, before scaling: no rounding of the motion makes a closed cam creep.
// FieldRange refusals get the nearest valid number of points, MasterTooFast refusals the nearest valid master
// rate.
[[nodiscard]] tl::expected<CamTable, Refusal> buildCamTable(const MotionProfile& forward,
                                                            const CamMaster& master, double netAdvanceMm,
                                                            const Machine& machine);
template <typename Cam>
[[nodiscard]] tl::expected<CamTable, Refusal>
buildCamTable(const Cam& cam, const Machine& machine) requires std::is_base_of_v<CamMaster, Cam>
{
    return buildCamTable(forwardMotion(cam), cam, netAdvanceMm(cam), machine);
}

// The position at a share 0..1 of an interval, in 1/256 pulse from the first row, and its derivative per
// interval.
struct CamPoint {
    double position256 = 0;
    double slope256 = 0;
};
[[nodiscard]] CamPoint interpolate(const CamTable& table, std::size_t index, double share);

// The deviation of the interpolated rows from the source motion, at the same share of the cycle. The figures
// are upper bounds of position and speed error, too large by a few parts in a thousand at most. Whole output
// pulses add a granularity of half a pulse.
struct CamErrors {
    double positionPulses = 0;
    double positionMm = 0;
    double positionTimeS = 0;
    double speedMmPerS = 0;
    double speedTimeS = 0;
    double wrapSpeedStepMmPerS = 0; // only a repeating table; the inner rows have no step
};

// Computes the errors. `table` must have been built from this motion for this machine.
[[nodiscard]] CamErrors camErrors(const CamTable& table, const MotionProfile& motion, const Machine& machine,
                                  CamUse use);

} // namespace campanel::profile
