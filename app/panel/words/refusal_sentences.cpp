// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/refusal_sentences.h"

#include "app/panel/words/recipe_words.h"
#include "app/panel/words/register_words.h"
#include "app/panel/words/segment_sentences.h"

#include <cmath>

namespace campanel::panel {

using profile::Limit;

namespace {

// Formats a value in the units of the plots: accelerations in m/s².
QString quantityText(profile::Field field, double value, double beside)
{
    if (field != profile::Field::MaxKnifeAcceleration && field != profile::Field::MaxAcceleration)
        return RefusalSentences::valueWithUnit(field, value, beside);
    constexpr double mmPerM = 1000;
    return Format().measure(value / mmPerM, 2, QStringLiteral("m/s²"), beside / mmPerM);
}

} // namespace

QString RefusalSentences::valueWithUnit(profile::Field field, double value, std::optional<double> beside)
{
    const profile::FieldInfo& info = profile::info(field);
    return Format().measure(value, info.decimals, RecipeWords::unit(info.unit), beside);
}

QString RefusalSentences::window(profile::Field field, const program::ApprovedWindow& window)
{
    const profile::FieldInfo& info = profile::info(field);
    const ShownUnit shown = Units::of(RecipeWords::unit(info.unit));
    const QString from = Format().number(window.min * shown.factor, shown.decimals(info.decimals));
    return tr("%1 to %2", "number, number with unit").arg(from, valueWithUnit(field, window.max));
}

QString RefusalSentences::outside(const program::Excess& excess)
{
    return tr("%1 %2, approved %3", "name, value, window")
        .arg(RecipeWords::fieldName(excess.field),
             valueWithUnit(excess.field, excess.value,
                           excess.value > excess.window.max ? excess.window.max : excess.window.min),
             window(excess.field, excess.window));
}

QString RefusalSentences::suggestion(const profile::Suggestion& suggestion)
{
    if (suggestion.ratios)
        return suggestion.field == profile::Field::Rate
                   ? tr("Widen the window, %1", "%1: rate with unit")
                         .arg(valueWithUnit(suggestion.field, suggestion.value))
                   : tr("Widen the window");
    return numbers(suggestion);
}

// Returns the values themselves: "Ratios 4 / 2.6 / 1.63 / 1.33".
QString RefusalSentences::numbers(const profile::Suggestion& suggestion)
{
    if (suggestion.ratios) {
        QStringList ratios;
        for (const double k : *suggestion.ratios)
            ratios << Format().compact(k, 0, 4);
        const QString text = tr("Ratios %1").arg(ratios.join(QStringLiteral(" / ")));
        return suggestion.field == profile::Field::Rate
                   ? tr("%1 with %2", "%1: ratios, %2: rate")
                         .arg(text, valueWithUnit(suggestion.field, suggestion.value))
                   : text;
    }
    return tr("%1 %2", "%1: name of a field, %2: value with unit")
        .arg(RecipeWords::fieldName(suggestion.field), valueWithUnit(suggestion.field, suggestion.value));
}

QString RefusalSentences::rampsName(const profile::RampOffer& offer)
{
    return offer.isLonger ? tr("Longer ramps") : tr("Shorter ramps");
}

QString RefusalSentences::rampsRate(const profile::RampOffer& offer)
{
    return valueWithUnit(profile::Field::Rate, offer.rateBagsPerMin);
}

QString RefusalSentences::withSuggestions(const profile::Refusal& refusal)
{
    QString values;
    for (const profile::Suggestion& each : refusal.nearest)
        values = values.isEmpty() ? numbers(each) : tr("%1, or %2").arg(values, numbers(each));
    QString sentence = RefusalSentences::refusal(refusal);
    if (refusal.ramps)
        sentence = tr("%1 %2 allow %3.", "%1: whole sentence, %2: longer ramps, %3: rate with unit")
                       .arg(sentence, rampsName(*refusal.ramps), rampsRate(*refusal.ramps));
    return values.isEmpty()
               ? sentence
               : tr("%1 Nearest possible value: %2.", "%1: whole sentence").arg(sentence, values);
}

QString RefusalSentences::program(const program::ProgramRefusal& refusal)
{
    QStringList sentences;
    if (refusal.unstorable)
        sentences << RegisterWords::outOfRange(*refusal.unstorable);
    for (const profile::Refusal& limit : refusal.limits)
        sentences << withSuggestions(limit);
    return sentences.join(u' ');
}

QString RefusalSentences::possible(const profile::FastestRate& fastest)
{
    return tr("This motion allows up to %1 (%2).", "%1: rate with unit, %2: name of the limit")
        .arg(valueWithUnit(profile::Field::Rate, fastest.rateBagsPerMin),
             RecipeWords::limitName(fastest.limitedBy));
}

QString RefusalSentences::withinLimits(const std::optional<profile::FastestRate>& fastest)
{
    if (!fastest)
        return tr("Within all limits.");
    return tr("Within all limits. Possible up to %1 (%2).", "%1: rate with unit, %2: name of the limit")
        .arg(valueWithUnit(profile::Field::Rate, fastest->rateBagsPerMin),
             RecipeWords::limitName(fastest->limitedBy));
}

QString RefusalSentences::closeToLimits(const std::optional<profile::FastestRate>& fastest)
{
    if (!fastest)
        return tr("Just within the limits.");
    return tr("Just within the limits. Possible up to %1 (%2).", "%1: rate with unit, %2: name of the limit")
        .arg(valueWithUnit(profile::Field::Rate, fastest->rateBagsPerMin),
             RecipeWords::limitName(fastest->limitedBy));
}

QString RefusalSentences::axisLimitBrokenAt(Limit limit, const QString& actual, const QString& allowed,
                                            const QString& time)
{
    switch (limit) {
    case Limit::MotorSpeed:
        return tr("Motor speed would reach %1 at %3 s; the limit is %2.").arg(actual, allowed, time);
    case Limit::AxisAcceleration:
        return tr("Acceleration would reach %1 at %3 s; the limit is %2.").arg(actual, allowed, time);
    case Limit::MotorTorque:
        return tr("Motor torque would reach %1 at %3 s; the limit is %2.").arg(actual, allowed, time);
    case Limit::MasterTooFast:
        return tr("Following the master would require %1 at %3 s; the limit is %2.")
            .arg(actual, allowed, time);
    default:
        return tr("Pulse frequency would reach %1 at %3 s; the limit is %2.").arg(actual, allowed, time);
    }
}

QString RefusalSentences::limitBrokenAt(const profile::Refusal& refusal)
{
    const Format format;
    const QString actual = quantityText(refusal.field, refusal.actual, refusal.allowed);
    const QString allowed = quantityText(refusal.field, refusal.allowed, refusal.actual);
    const QString time = format.number(*refusal.timeS, 3);
    if (!refusal.angleDeg)
        return axisLimitBrokenAt(refusal.limit, actual, allowed, time);
    const QString angle = format.number(*refusal.angleDeg, 0);
    switch (refusal.limit) {
    case Limit::MotorSpeed:
        return tr("Motor speed would reach %1 at %3 s (%4°); the limit is %2.")
            .arg(actual, allowed, time, angle);
    case Limit::KnifeAcceleration:
        return tr("Knife acceleration would reach %1 at %3 s (%4°); the limit is %2.")
            .arg(actual, allowed, time, angle);
    case Limit::AxisAcceleration:
        return tr("Acceleration would reach %1 at %3 s (%4°); the limit is %2.")
            .arg(actual, allowed, time, angle);
    case Limit::MotorTorque:
        return tr("Motor torque would reach %1 at %3 s (%4°); the limit is %2.")
            .arg(actual, allowed, time, angle);
    case Limit::MasterTooFast:
        return tr("Following the master would require %1 at %3 s (%4°); the limit is %2.")
            .arg(actual, allowed, time, angle);
    default:
        return tr("Pulse frequency would reach %1 at %3 s (%4°); the limit is %2.")
            .arg(actual, allowed, time, angle);
    }
}

QString RefusalSentences::limitBroken(const profile::Refusal& refusal)
{
    if (refusal.timeS && refusal.limit != Limit::MachineRate)
        return limitBrokenAt(refusal);
    return tr("%1 is required; the machine's limit is %2.")
        .arg(valueWithUnit(refusal.field, refusal.actual, refusal.allowed),
             valueWithUnit(refusal.field, refusal.allowed, refusal.actual));
}

// Returns the sentence of a window or a time that jaws or film do not have.
QString RefusalSentences::jaw(const profile::Refusal& refusal)
{
    const Format format;
    const int decimals = Format::decimalsToTell(refusal.actual, refusal.allowed, 1);
    const auto inUnit = [&](double value) {
        return format.compactMeasure(value, 0, decimals, RecipeWords::unit(refusal.unit));
    };
    const QString time = format.number(*refusal.timeS, 3);
    const QString angle = format.number(*refusal.angleDeg, 0);
    if (refusal.limit == Limit::JawWindow)
        return tr("The jaws need a sync window of %2° of the knife; at %3 s (%4°) the window has only %1°.")
            .arg(format.compact(refusal.actual, 0, decimals), format.compact(refusal.allowed, 0, decimals),
                 time, angle);
    if (refusal.actual > 0)
        return tr("Seal time would be %1 at %3 s (%4°); the film needs %2.")
            .arg(inUnit(refusal.actual), inUnit(refusal.allowed), time, angle);
    return tr("The film needs a seal time of %1, but the machine has no contact angle of the jaws. Enter the "
              "angle in Settings, Machine.")
        .arg(inUnit(refusal.allowed));
}

QString RefusalSentences::knot(const profile::Refusal& refusal)
{
    const Format format;
    const int number = refusal.index + 1;
    const QString unit = RecipeWords::unit(refusal.unit);
    const QString actual = format.compactMeasure(refusal.actual, 0, 3, unit, refusal.allowed);
    const QString allowed = format.compactMeasure(refusal.allowed, 0, 3, unit, refusal.actual);
    switch (refusal.limit) {
    case Limit::KnotCount:
        return tr("The cam has %1 knots; the nearest possible number is %2.")
            .arg(format.number(refusal.actual, 0), format.number(refusal.allowed, 0));
    case Limit::KnotOrder:
        return tr("Knot %1 at %2 must come after the previous knot at %3.").arg(number).arg(actual, allowed);
    case Limit::KnotSpacing:
        return tr("Knot %1 is only %2 after the previous knot; the minimum is %3.")
            .arg(number)
            .arg(actual, allowed);
    case Limit::KnotRange:
        return tr("Knot %1 at %2 is out of range; the nearest position is %3.")
            .arg(number)
            .arg(actual, allowed);
    case Limit::KnotEnds:
        return tr("Knot %1 is at %2; the cam needs a knot at %3.").arg(number).arg(actual, allowed);
    case Limit::Overshoot:
        return tr("Near knot %1 the curve reaches %2, beyond the end of the knots' range at %3. Move the "
                  "knot or add another knot.")
            .arg(number)
            .arg(actual, allowed);
    case Limit::WrapJump:
        return tr("Speed jumps by %1 at the end of the cycle. Choose periodic ends.").arg(actual);
    default:
        return {};
    }
}

QString RefusalSentences::refusal(const profile::Refusal& refusal)
{
    const Format format;
    const profile::FieldInfo& field = profile::info(refusal.field);
    const QString name = RecipeWords::fieldName(refusal.field);
    const QString rangeMin = format.amount(field.min, field.decimals, RecipeWords::unit(field.unit));
    const auto decimals = [&refusal](int usual) {
        return Format::decimalsToTell(refusal.actual, refusal.allowed, usual);
    };
    switch (refusal.limit) {
    case Limit::FieldRange:
        if (!std::isfinite(refusal.actual))
            return tr("%1 has no value. Enter %2 to %3.")
                .arg(name, rangeMin, valueWithUnit(refusal.field, field.max));
        return tr("%1 would be %2; the allowed range is %3 to %4.")
            .arg(name,
                 valueWithUnit(refusal.field, refusal.actual,
                               refusal.actual < field.min ? field.min : field.max),
                 rangeMin, valueWithUnit(refusal.field, field.max));
    case Limit::PinnedPair:
        return tr("Pin two of bag length, rate, base speed and film speed.");
    case Limit::LawUnknown:
        return tr("This speed law is unknown. Choose another law.");
    case Limit::LawParameter:
        if (refusal.index >= 0)
            return SegmentSentences::refusal(refusal);
        return tr("%1 is %2; the nearest possible value is %3.")
            .arg(RecipeWords::lawParameterName(refusal.lawParameter),
                 format.compact(refusal.actual, 0, decimals(3)),
                 format.compact(refusal.allowed, 0, decimals(3)));
    case Limit::RatioOrder:
        return tr("The ratios must descend from k1 to k4: %1 is %2 and must be below %3.")
            .arg(name, format.compact(refusal.actual, 2, decimals(4)),
                 format.compact(refusal.allowed, 2, decimals(4)));
    case Limit::StrokeCannotClose:
        return tr("A bag of %1 exceeds the knife stroke; with these ratios the maximum is %2.")
            .arg(valueWithUnit(profile::Field::BagLength, refusal.actual, refusal.allowed),
                 valueWithUnit(profile::Field::BagLength, refusal.allowed, refusal.actual));
    case Limit::RowCapacity:
        return tr("The table needs %1 rows, the controller has %2. Use fewer slices per ramp.")
            .arg(format.number(refusal.actual, 0), format.number(refusal.allowed, 0));
    case Limit::TooFewPulses:
        return tr("A cycle has only %1 pulses. Check pulses per revolution, gear and knives.")
            .arg(format.compact(refusal.actual, 0, 3));
    case Limit::MotorSpeed:
    case Limit::KnifeAcceleration:
    case Limit::PulseFrequency:
    case Limit::MachineRate:
    case Limit::AxisAcceleration:
    case Limit::MotorTorque:
    case Limit::MasterTooFast:
        return limitBroken(refusal);
    case Limit::JawWindow:
    case Limit::SealTime:
        return jaw(refusal);
    case Limit::RmsTorque:
        return tr("RMS torque would be %1, and the motor would overheat; its rated torque is %2.")
            .arg(valueWithUnit(refusal.field, refusal.actual, refusal.allowed),
                 valueWithUnit(refusal.field, refusal.allowed, refusal.actual));
    case Limit::NaturalFrequency:
        return tr("The cycle repeats at %1, above the shaft's natural frequency of %2. Enter a lower rate, "
                  "or "
                  "correct the machine data.")
            .arg(valueWithUnit(refusal.field, refusal.actual, refusal.allowed),
                 valueWithUnit(refusal.field, refusal.allowed, refusal.actual));
    case Limit::NoMotion:
        return tr("%1 is %2, which gives no motion. Enter another value.")
            .arg(name, valueWithUnit(refusal.field, refusal.actual));
    case Limit::DistanceTooShort:
        return tr("These speeds require at least %1, not %2.")
            .arg(valueWithUnit(profile::Field::Distance, refusal.allowed, refusal.actual),
                 valueWithUnit(profile::Field::Distance, refusal.actual, refusal.allowed));
    case Limit::DistanceSign:
        return tr("The distance %1 and the speeds have opposite directions. Change the sign of the distance.")
            .arg(valueWithUnit(profile::Field::Distance, refusal.actual));
    case Limit::StageOrder:
        return tr("%1 %2 must be beyond %3.")
            .arg(name, valueWithUnit(refusal.field, refusal.actual, refusal.allowed),
                 valueWithUnit(refusal.field, refusal.allowed, refusal.actual));
    case Limit::ForceOrder:
        return tr("%1 %2 must be at most %3.")
            .arg(name, valueWithUnit(refusal.field, refusal.actual, refusal.allowed),
                 valueWithUnit(refusal.field, refusal.allowed, refusal.actual));
    case Limit::TableRange:
        return tr(
            "The table exceeds the controller's range. Use fewer pulses per revolution or a shorter motion.");
    case Limit::Reversal:
        return tr("The motion reverses, but intervals run in one direction. Choose cam points.");
    case Limit::SpeedError:
        if (!std::isfinite(refusal.allowed))
            return tr("The motion has too few pulses for intervals. Use more pulses per revolution.");
        return tr("With whole pulses, a speed error of %1 is not possible, but %2 is. Use more "
                  "pulses per revolution.")
            .arg(format.compactMeasure(refusal.actual, 0, 9, QStringLiteral("mm/s")),
                 format.compactMeasure(refusal.allowed, 0, 9, QStringLiteral("mm/s")));
    case Limit::RampTooLong:
        return tr("%1 needs a ramp of %2 ms at maximum acceleration; the controller allows %3 ms. Enter a "
                  "lower speed or a higher acceleration.")
            .arg(name, format.number(refusal.actual, decimals(0)),
                 format.number(refusal.allowed, decimals(0)));
    case Limit::KnotCount:
    case Limit::KnotOrder:
    case Limit::KnotSpacing:
    case Limit::KnotRange:
    case Limit::KnotEnds:
    case Limit::Overshoot:
    case Limit::WrapJump:
        return knot(refusal);
    case Limit::SegmentCount:
    case Limit::SegmentRange:
    case Limit::SegmentWidth:
    case Limit::SegmentOverlap:
    case Limit::SegmentGap:
    case Limit::SegmentEnds:
    case Limit::SegmentMotion:
    case Limit::JointJump:
        return SegmentSentences::refusal(refusal);
    }
    return {};
}

} // namespace campanel::panel
