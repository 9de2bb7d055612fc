// SPDX-License-Identifier: Apache-2.0
// The English sentences of refusals.
#include "profile/refusal.h"

#include "profile/text.h"

#include <array>
#include <cmath>

namespace campanel::profile {
namespace {

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
    std::string text{f.name};
    if (std::isfinite(r.actual))
        text += " " + withUnit(significantText(r.actual), f.unit) + " is outside its range ";
    else
        text += " has no finite value; its range is ";
    return text + fixedText(f.min, f.decimals) + " to " + fieldValue(r.field, f.max) + ".";
}

std::string overLimit(std::string what, const Refusal& r)
{
    const int decimals = r.limit == Limit::MachineRate ? 1 : 0;
    what += " " + withUnit(fixedText(r.actual, decimals), r.unit);
    if (r.timeS)
        what += " at " + fixedText(*r.timeS, 3) + " s";
    if (r.angleDeg)
        what += " (" + fixedText(*r.angleDeg, 1) + " degrees)";
    const double percent = (r.actual / r.allowed - 1) * 100;
    return what + " is " + fixedText(percent, 1) + " % over the limit of " +
           withUnit(fixedText(r.allowed, decimals), r.unit) + ".";
}

std::string reason(const Refusal& r)
{
    switch (r.limit) {
    case Limit::FieldRange:
        return outOfRange(r);
    case Limit::PinnedPair:
        return "Pin two different ones of bag length, rate, base speed and film speed.";
    case Limit::LawUnknown:
        return "There is no speed law with the code " + fixedText(r.actual, 0) + ".";
    case Limit::LawParameter:
        return "Speed law parameter " + std::string(r.lawParameter) + " = " + significantText(r.actual) +
               " is outside its range; the nearest allowed value is " + significantText(r.allowed) + ".";
    case Limit::RatioOrder:
        return "The ratios must descend: " + std::string(info(r.field).id) + " = " +
               significantText(r.actual) + " must be below " + significantText(r.allowed) + ".";
    case Limit::StrokeCannotClose:
        return "A bag of " + withUnit(fixedText(r.actual, 1), r.unit) +
               " takes more than the knife's stroke; with these ratios at most " +
               withUnit(fixedText(r.allowed, 1), r.unit) + " can be cut.";
    case Limit::MotorSpeed:
        return overLimit("Motor speed", r);
    case Limit::KnifeAcceleration:
        return overLimit("Knife acceleration", r);
    case Limit::PulseFrequency:
        return overLimit("Pulse frequency", r);
    case Limit::MachineRate:
        return overLimit("Rate", r);
    case Limit::RowCapacity:
        return "The table needs " + fixedText(r.actual, 0) + " rows; the controller holds " +
               fixedText(r.allowed, 0) + ".";
    case Limit::TooFewPulses:
        return "A cycle has " + significantText(r.actual) + " pulses; it needs at least " +
               fixedText(r.allowed, 0) + ".";
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
        text += (i == 0 ? " Nearest that works: " : ", or ") + std::string(info(s.field).name) + " " +
                fieldValue(s.field, s.value);
    }
    return refusal.nearest.empty() ? text : text + ".";
}

} // namespace campanel::profile
