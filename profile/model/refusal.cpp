// SPDX-License-Identifier: Apache-2.0
// The English sentences of refusals.
#include "profile/model/refusal.h"

#include "profile/model/text.h"

#include <array>
#include <cmath>

namespace campanel::profile {
namespace {

using detail::concat;
using detail::fixedText;
using detail::significantText;
using detail::withUnit;

std::string fieldValue(Field field, double value)
{
    const FieldInfo& f = info(field);
    return withUnit(fixedText(value, f.decimals), f.unit);
}

std::string rangeReason(const Refusal& r)
{
    const FieldInfo& f = info(r.field);
    if (!std::isfinite(r.actual)) {
        return concat({f.name, " has no finite value; the range is ", fixedText(f.min, f.decimals), " to ",
                       fieldValue(r.field, f.max), "."});
    }
    return concat({f.name, " ", withUnit(significantText(r.actual), f.unit), " must be at ",
                   r.actual > r.allowed ? "most " : "least ", fieldValue(r.field, r.allowed), "."});
}

std::string overLimit(std::string_view what, const Refusal& r)
{
    const bool isClose = std::abs(r.actual - r.allowed) < 1;
    const int decimals = isClose ? 3 : 0;
    const std::string time = r.timeS ? concat({" at ", fixedText(*r.timeS, 3), " s"}) : std::string();
    const std::string angle =
        r.angleDeg ? concat({" (", fixedText(*r.angleDeg, 1), " degrees)"}) : std::string();
    const std::string percent = fixedText((r.actual / r.allowed - 1) * 100, 1);
    return concat({what, " ", withUnit(fixedText(r.actual, decimals), r.unit), time, angle, " is ", percent,
                   " % over the limit of ", withUnit(fixedText(r.allowed, decimals), r.unit), "."});
}

std::string knotReason(const Refusal& r)
{
    const std::string knot = concat({"Knot ", std::to_string(r.index + 1)});
    const std::string actual = withUnit(significantText(r.actual), r.unit);
    const std::string allowed = withUnit(significantText(r.allowed), r.unit);
    switch (r.limit) {
    case Limit::KnotCount:
        return concat({"A cam of ", fixedText(r.actual, 0), " knots; the nearest number it can have is ",
                       fixedText(r.allowed, 0), "."});
    case Limit::KnotOrder:
        return concat({knot, " at ", actual, " must come after the previous knot at ", allowed, "."});
    case Limit::KnotSpacing:
        return concat({knot, " is ", actual, " after the previous knot; the minimum is ", allowed, "."});
    case Limit::KnotRange:
        if (!std::isfinite(r.actual))
            return concat({knot, " has no finite value; the nearest position is ", allowed, "."});
        return concat({knot, " at ", actual, " is out of range; the nearest position is ", allowed, "."});
    case Limit::KnotEnds:
        return concat({knot, " is at ", actual, "; the cam needs a knot at ", allowed, "."});
    case Limit::Overshoot:
        return concat({"Near knot ", std::to_string(r.index + 1), " the curve reaches ", actual,
                       ", beyond the end of the knots' range at ", allowed,
                       ". Move the knot or add another knot."});
    case Limit::WrapJump:
        return concat({"At the end of the cycle, the ", r.lawParameter, " jumps by ", actual,
                       ". Choose periodic ends."});
    default:
        return {};
    }
}

std::string reason(const Refusal& r)
{
    switch (r.limit) {
    case Limit::FieldRange:
        return rangeReason(r);
    case Limit::PinnedPair:
        return "Pin two of bag length, rate, base speed and film speed.";
    case Limit::LawUnknown:
        return concat(
            {"The law is unknown for this program (code ", fixedText(r.actual, 0), "). Choose another law."});
    case Limit::LawParameter:
        return concat({"Law parameter ", r.lawParameter, " = ", significantText(r.actual),
                       " is outside its range; the nearest allowed value is ", significantText(r.allowed),
                       "."});
    case Limit::RatioOrder:
        return concat({"The ratios must descend: ", info(r.field).id, " = ", significantText(r.actual),
                       " must be below ", significantText(r.allowed), "."});
    case Limit::StrokeCannotClose:
        return concat({"A bag of ", withUnit(fixedText(r.actual, 1), r.unit),
                       " exceeds the knife stroke; with these ratios the maximum is ",
                       withUnit(fixedText(r.allowed, 1), r.unit), "."});
    case Limit::MotorSpeed:
        return overLimit("Motor speed", r);
    case Limit::KnifeAcceleration:
        return overLimit("Knife acceleration", r);
    case Limit::PulseFrequency:
        return overLimit("Pulse frequency", r);
    case Limit::MachineRate:
        return overLimit("Rate", r);
    case Limit::RowCapacity:
        return concat({"The table needs ", fixedText(r.actual, 0), " rows; the controller has ",
                       fixedText(r.allowed, 0), "."});
    case Limit::TooFewPulses:
        return concat({"A cycle has ", significantText(r.actual), " pulses; the minimum is ",
                       fixedText(r.allowed, 0), "."});
    case Limit::AxisAcceleration:
        return overLimit("Acceleration", r);
    case Limit::MotorTorque:
        return overLimit("Motor torque", r);
    case Limit::NoMotion:
        return concat({info(r.field).name, " is ", fieldValue(r.field, r.actual),
                       ", which gives no motion. Enter another value."});
    case Limit::DistanceTooShort:
        return concat({"These speeds require at least ", fieldValue(Field::Distance, r.allowed), ", not ",
                       fieldValue(Field::Distance, r.actual), "."});
    case Limit::DistanceSign:
        return concat({"The distance ", fieldValue(Field::Distance, r.actual),
                       " and the speeds have opposite directions. Change the sign of the distance."});
    case Limit::MasterTooFast:
        return overLimit("Pulse frequency between two updates of the master", r);
    case Limit::StageOrder:
        return concat({info(r.field).name, " ", fieldValue(r.field, r.actual), " must be beyond ",
                       fieldValue(r.field, r.allowed), "."});
    case Limit::ForceOrder:
        return concat({info(r.field).name, " ", fieldValue(r.field, r.actual), " must be at most ",
                       fieldValue(r.field, r.allowed), "."});
    case Limit::TableRange:
        return concat({"The table exceeds the controller's range: ", significantText(r.actual),
                       " instead of at most ", significantText(r.allowed),
                       ". Use fewer pulses per revolution or a shorter motion."});
    case Limit::Reversal:
        return concat({"The motion reverses at ", fixedText(r.timeS.value_or(0), 3),
                       " s, but intervals run in one direction. Choose cam points."});
    case Limit::SpeedError:
        return concat({"Intervals cannot keep a speed error of ", withUnit(significantText(r.actual), r.unit),
                       "; they can keep ", withUnit(significantText(r.allowed), r.unit), "."});
    case Limit::RampTooLong:
        return concat({info(r.field).name, " needs a ramp of ", withUnit(fixedText(r.actual, 0), r.unit),
                       " at maximum acceleration; the controller allows ",
                       withUnit(fixedText(r.allowed, 0), r.unit),
                       ". Enter a lower speed or a higher acceleration."});
    case Limit::KnotCount:
    case Limit::KnotOrder:
    case Limit::KnotSpacing:
    case Limit::KnotRange:
    case Limit::KnotEnds:
    case Limit::Overshoot:
    case Limit::WrapJump:
        return knotReason(r);
    }
    return {};
}

} // namespace

std::string_view limitId(Limit limit)
{
    static constexpr std::array<std::string_view, 31> ids{
        "field_range",         "pinned_pair",     "law_unknown",        "law_parameter",   "ratio_order",
        "stroke_cannot_close", "motor_speed",     "knife_acceleration", "pulse_frequency", "machine_rate",
        "row_capacity",        "too_few_pulses",  "axis_acceleration",  "motor_torque",    "no_motion",
        "distance_too_short",  "distance_sign",   "knot_count",         "knot_order",      "knot_spacing",
        "knot_range",          "knot_ends",       "overshoot",          "wrap_jump",       "stage_order",
        "force_order",         "master_too_fast", "table_range",        "reversal",        "speed_error",
        "ramp_too_long"};
    return ids[static_cast<std::size_t>(limit)];
}

std::string describe(const Refusal& refusal)
{
    std::string text = reason(refusal);
    for (std::size_t i = 0; i < refusal.nearest.size(); ++i) {
        const Suggestion& s = refusal.nearest[i];
        text.append(i == 0 ? " Nearest possible value: " : ", or ");
        text.append(concat({info(s.field).name, " ", fieldValue(s.field, s.value)}));
    }
    return refusal.nearest.empty() ? text : text.append(".");
}

} // namespace campanel::profile
