// SPDX-License-Identifier: Apache-2.0
#include "app/machine/refusal_sentences.h"

#include "app/machine/recipe_words.h"

#include <cmath>

namespace campanel::machine {

using profile::Limit;

namespace {

// What the machine would do, in the units of the plots: accelerations in m/s².
QString quantityText(profile::Field field, double value)
{
    if (field != profile::Field::MaxKnifeAcceleration)
        return RefusalSentences::valueWithUnit(field, value);
    constexpr double mmPerM = 1000;
    return RefusalSentences::tr("%1 %2", "%1: number, %2: unit")
        .arg(Format().grouped(value / mmPerM, 2), QStringLiteral("m/s²"));
}

} // namespace

QString RefusalSentences::valueWithUnit(profile::Field field, double value)
{
    const profile::FieldInfo& info = profile::info(field);
    const QString number = Format().grouped(value, info.decimals);
    return info.unit.empty() ? number
                             : tr("%1 %2", "%1: number, %2: unit").arg(number, RecipeWords::unit(info.unit));
}

QString RefusalSentences::suggestion(const profile::Suggestion& suggestion)
{
    return tr("%1 %2", "%1: name of a field, %2: value with unit")
        .arg(RecipeWords::fieldName(suggestion.field), valueWithUnit(suggestion.field, suggestion.value));
}

QString RefusalSentences::withinLimits(const std::optional<profile::FastestRate>& fastest)
{
    if (!fastest)
        return tr("Within all limits.");
    return tr("Within all limits. Fastest possible: %1 (%2).", "%1: rate with unit, %2: name of the limit")
        .arg(valueWithUnit(profile::Field::Rate, fastest->rateBagsPerMin),
             RecipeWords::limitName(fastest->limitedBy));
}

QString RefusalSentences::closeToLimits(const std::optional<profile::FastestRate>& fastest)
{
    if (!fastest)
        return tr("Just within the limits.");
    return tr("Just within the limits. Fastest possible: %1 (%2).",
              "%1: rate with unit, %2: name of the limit")
        .arg(valueWithUnit(profile::Field::Rate, fastest->rateBagsPerMin),
             RecipeWords::limitName(fastest->limitedBy));
}

QString RefusalSentences::limitBrokenAt(const profile::Refusal& refusal)
{
    const Format format;
    const QString actual = quantityText(refusal.field, refusal.actual);
    const QString allowed = quantityText(refusal.field, refusal.allowed);
    const QString time = format.number(*refusal.timeS, 3);
    const QString angle = format.number(refusal.angleDeg.value_or(NAN), 0);
    switch (refusal.limit) {
    case Limit::MotorSpeed:
        return tr("The motor would turn at %1 at %3 s (%4°); the limit is %2.")
            .arg(actual, allowed, time, angle);
    case Limit::KnifeAcceleration:
        return tr("The knife would accelerate with %1 at %3 s (%4°); the limit is %2.")
            .arg(actual, allowed, time, angle);
    default:
        return tr("The pulse frequency would be %1 at %3 s (%4°); the limit is %2.")
            .arg(actual, allowed, time, angle);
    }
}

QString RefusalSentences::limitBroken(const profile::Refusal& refusal)
{
    if (refusal.timeS && refusal.limit != Limit::MachineRate)
        return limitBrokenAt(refusal);
    return tr("%1 would be needed; the limit of the machine is %2.")
        .arg(valueWithUnit(refusal.field, refusal.actual), valueWithUnit(refusal.field, refusal.allowed));
}

QString RefusalSentences::refusal(const profile::Refusal& refusal)
{
    const Format format;
    const profile::FieldInfo& field = profile::info(refusal.field);
    const QString name = RecipeWords::fieldName(refusal.field);
    switch (refusal.limit) {
    case Limit::FieldRange:
        if (!std::isfinite(refusal.actual))
            return tr("%1 has no value. Enter %2 to %3.")
                .arg(name, format.number(field.min, field.decimals), valueWithUnit(refusal.field, field.max));
        return tr("%1 would be %2; possible is %3 to %4.")
            .arg(name, valueWithUnit(refusal.field, refusal.actual), format.number(field.min, field.decimals),
                 valueWithUnit(refusal.field, field.max));
    case Limit::PinnedPair:
        return tr("Pin two different ones of bag length, rate, base speed and film speed.");
    case Limit::LawUnknown:
        return tr("This speed law is not known. Choose another one.");
    case Limit::LawParameter:
        return tr("%1 is %2; the nearest possible value is %3.")
            .arg(RecipeWords::lawParameterName(refusal.lawParameter), format.compact(refusal.actual, 0, 3),
                 format.compact(refusal.allowed, 0, 3));
    case Limit::RatioOrder:
        return tr("The ratios must descend from k1 to k4: %1 is %2 and must stay below %3.")
            .arg(name, format.compact(refusal.actual, 2, 4), format.compact(refusal.allowed, 2, 4));
    case Limit::StrokeCannotClose:
        return tr("A bag of %1 takes more than the knife's stroke; with these ratios %2 is the longest.")
            .arg(valueWithUnit(profile::Field::BagLength, refusal.actual),
                 valueWithUnit(profile::Field::BagLength, refusal.allowed));
    case Limit::RowCapacity:
        return tr("The table needs %1 rows, the controller holds %2. Use fewer slices per ramp.")
            .arg(format.number(refusal.actual, 0), format.number(refusal.allowed, 0));
    case Limit::TooFewPulses:
        return tr("A cycle has only %1 pulses. Check pulses per revolution, gear and knives.")
            .arg(format.compact(refusal.actual, 0, 3));
    case Limit::MotorSpeed:
    case Limit::KnifeAcceleration:
    case Limit::PulseFrequency:
    case Limit::MachineRate:
        return limitBroken(refusal);
    }
    return {};
}

} // namespace campanel::machine
