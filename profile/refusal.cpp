// SPDX-License-Identifier: Apache-2.0
// The English sentences of refusals.
#include "profile/refusal.h"

#include "profile/text.h"

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

std::string outOfRange(const Refusal& r)
{
    const FieldInfo& f = info(r.field);
    if (!std::isfinite(r.actual)) {
        return concat({f.name, " has no finite value; it must be from ", fixedText(f.min, f.decimals), " to ",
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

std::string reason(const Refusal& r)
{
    switch (r.limit) {
    case Limit::FieldRange:
        return outOfRange(r);
    case Limit::PinnedPair:
        return "Pin two different ones of bag length, rate, base speed and film speed.";
    case Limit::LawUnknown:
        return concat(
            {"There is no speed law with the code ", fixedText(r.actual, 0), "; choose one of the list."});
    case Limit::LawParameter:
        return concat({"Speed law parameter ", r.lawParameter, " = ", significantText(r.actual),
                       " is outside its range; the nearest allowed value is ", significantText(r.allowed),
                       "."});
    case Limit::RatioOrder:
        return concat({"The ratios must descend: ", info(r.field).id, " = ", significantText(r.actual),
                       " must be below ", significantText(r.allowed), "."});
    case Limit::StrokeCannotClose:
        return concat({"A bag of ", withUnit(fixedText(r.actual, 1), r.unit),
                       " takes more than the knife's stroke; with these ratios at most ",
                       withUnit(fixedText(r.allowed, 1), r.unit), " can be cut."});
    case Limit::MotorSpeed:
        return overLimit("Motor speed", r);
    case Limit::KnifeAcceleration:
        return overLimit("Knife acceleration", r);
    case Limit::PulseFrequency:
        return overLimit("Pulse frequency", r);
    case Limit::MachineRate:
        return overLimit("Rate", r);
    case Limit::RowCapacity:
        return concat({"The table needs ", fixedText(r.actual, 0), " rows; the controller holds ",
                       fixedText(r.allowed, 0), "."});
    case Limit::TooFewPulses:
        return concat({"A cycle has ", significantText(r.actual), " pulses; it needs at least ",
                       fixedText(r.allowed, 0), "."});
    }
    return {};
}

} // namespace

std::string_view limitId(Limit limit)
{
    static constexpr std::array<std::string_view, 12> ids{
        "field_range",     "pinned_pair",         "law_unknown",  "law_parameter",
        "ratio_order",     "stroke_cannot_close", "motor_speed",  "knife_acceleration",
        "pulse_frequency", "machine_rate",        "row_capacity", "too_few_pulses"};
    return ids[static_cast<std::size_t>(limit)];
}

std::string describe(const Refusal& refusal)
{
    std::string text = reason(refusal);
    for (std::size_t i = 0; i < refusal.nearest.size(); ++i) {
        const Suggestion& s = refusal.nearest[i];
        text.append(i == 0 ? " Nearest that works: " : ", or ");
        text.append(concat({info(s.field).name, " ", fieldValue(s.field, s.value)}));
    }
    return refusal.nearest.empty() ? text : text.append(".");
}

} // namespace campanel::profile
