// SPDX-License-Identifier: Apache-2.0
// Shared functions of position and speed moves.
#include "profile/moves/move_time.h"

#include "profile/cutter/validate.h"
#include "profile/model/torque.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::profile::detail {

Refusal noMotion(Field field, double value)
{
    Refusal refusal;
    refusal.limit = Limit::NoMotion;
    refusal.field = field;
    refusal.actual = value;
    refusal.unit = info(field).unit;
    return refusal;
}

std::optional<Refusal> noTorqueLeft(const Machine& machine)
{
    const TorqueLoad load = axisLoad(machine);
    Refusal refusal;
    refusal.actual = machine.frictionNm;
    if (!(load.peakAllowance(machine.maxTorqueNm) > 0)) {
        refusal.limit = Limit::MotorTorque;
        refusal.field = Field::MaxTorque;
        refusal.allowed = machine.maxTorqueNm;
    } else if (!(load.rmsAllowance(machine.ratedTorqueNm) > 0)) {
        refusal.limit = Limit::RmsTorque;
        refusal.field = Field::RatedTorque;
        refusal.allowed = machine.ratedTorqueNm;
    } else {
        return std::nullopt;
    }
    refusal.unit = info(refusal.field).unit;
    return refusal;
}

tl::expected<double, Refusal> timeOnGrid(double shortestS)
{
    // The share within which a time counts as a grid point; far below the tolerance of limits.
    constexpr double roundingShare = 2e-10;
    const FieldInfo& f = info(Field::MoveTime);
    const double steps = std::ceil(shortestS / f.resolution() * (1 - roundingShare));
    const double timeS = std::max(steps * f.resolution(), f.min);
    if (!inRange(Field::MoveTime, timeS))
        return tl::unexpected(outOfRange(Field::MoveTime, shortestS));
    return snapToGrid(Field::MoveTime, timeS);
}

AxisMotion checkedMotion(MotionProfile motion, const Machine& machine)
{
    AxisMotion result;
    result.peaks = axisPeaks(motion, machine);
    result.broken = checkAxis(motion, result.peaks, machine);
    result.motion = std::move(motion);
    return result;
}

} // namespace campanel::profile::detail
