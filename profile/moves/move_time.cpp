// SPDX-License-Identifier: Apache-2.0
// Shared functions of position and speed moves.
#include "profile/moves/move_time.h"

#include "profile/cutter/validate.h"
#include "profile/model/bounds.h"
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

Refusal noTorqueLeft(const Machine& machine, Limit limit)
{
    Refusal refusal;
    refusal.limit = limit;
    refusal.field = limit == Limit::MotorTorque ? Field::MaxTorque : Field::RatedTorque;
    refusal.actual = machine.frictionNm;
    refusal.allowed = value(machine, refusal.field);
    refusal.unit = info(refusal.field).unit;
    return refusal;
}

tl::expected<double, Refusal> timeOnGrid(double shortestS)
{
    // The share within which a time counts as a grid point; far below the tolerance of limits.
    constexpr double roundingShare = 2e-10;
    const FieldInfo& f = info(Field::MoveTime);
    const double steps = std::ceil(shortestS / f.resolution() * (1 - roundingShare));
    const double timeS = maxOf(steps * f.resolution(), f.min);
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
