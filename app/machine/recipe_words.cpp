// SPDX-License-Identifier: Apache-2.0
#include "app/machine/recipe_words.h"

namespace campanel::machine {

using profile::Field;
using profile::LawId;
using profile::Limit;

QString RecipeWords::fieldName(Field field)
{
    switch (field) {
    case Field::BagLength:
        return tr("Bag length");
    case Field::Rate:
        return tr("Rate");
    case Field::BaseSpeed:
        return tr("Base speed v_a");
    case Field::FilmSpeed:
        return tr("Film speed v_b");
    case Field::K1:
        return tr("Ratio k1");
    case Field::K2:
        return tr("Ratio k2");
    case Field::K3:
        return tr("Ratio k3");
    case Field::K4:
        return tr("Ratio k4");
    case Field::SyncRatio:
        return tr("Sync ratio");
    case Field::SlicesPerRamp:
        return tr("Slices per ramp");
    case Field::KnifeRadius:
        return tr("Knife radius R");
    case Field::Knives:
        return tr("Knives N");
    case Field::PulsesPerMotorRev:
        return tr("Pulses per motor rev. K");
    case Field::GearNumerator:
        return tr("Gear Z, motor revs");
    case Field::GearDenominator:
        return tr("Gear Z, knife revs");
    case Field::MaxMotorRpm:
        return tr("Max. motor speed");
    case Field::MaxKnifeAcceleration:
        return tr("Max. acceleration");
    case Field::MaxPulseFrequency:
        return tr("Max. pulse frequency");
    case Field::MaxRate:
        return tr("Max. rate");
    case Field::TimerClock:
        return tr("Timer clock");
    case Field::TimerBits:
        return tr("Timer width");
    case Field::RowCapacity:
        return tr("Rows in the controller");
    }
    return {};
}

QString RecipeWords::unit(std::string_view unit)
{
    if (unit == "mm/s^2")
        return QStringLiteral("mm/s²");
    if (unit == "bags/min")
        return tr("bags/min");
    if (unit == "r/min")
        return tr("r/min");
    if (unit == "pulses")
        return tr("pulses");
    return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

QString RecipeWords::lawName(LawId law)
{
    switch (law) {
    case LawId::Cubic:
        return tr("Cubic (paper)");
    case LawId::Quintic:
        return tr("Quintic 3-4-5");
    case LawId::Polynomial4567:
        return tr("Polynomial 4-5-6-7");
    case LawId::Harmonic:
        return tr("Harmonic");
    case LawId::Cycloidal:
        return tr("Cycloidal");
    case LawId::ModifiedSine:
        return tr("Modified sine");
    case LawId::ModifiedTrapezoid:
        return tr("Modified trapezoid");
    case LawId::Parabolic:
        return tr("Parabolic");
    case LawId::Trapezoid:
        return tr("Trapezoid");
    case LawId::SCurve:
        return tr("Seven-segment S");
    case LawId::Exponential:
        return tr("Exponential");
    case LawId::HalfModifiedSine:
        return tr("Half modified sine");
    }
    return {};
}

QString RecipeWords::lawHint(LawId law)
{
    switch (law) {
    case LawId::Cubic:
        return tr("The paper's law: low acceleration; jerk steps at both ends.");
    case LawId::Quintic:
        return tr("No jerk step at the ends; a quarter more acceleration than the cubic.");
    case LawId::Polynomial4567:
        return tr("The gentlest ends of all; highest acceleration in the middle.");
    case LawId::Harmonic:
        return tr("Close to the cubic; jerk steps at both ends.");
    case LawId::Cycloidal:
        return tr("No jerk step at the ends; a third more acceleration than the cubic.");
    case LawId::ModifiedSine:
        return tr("Tolerates changing loads well; moderate acceleration.");
    case LawId::ModifiedTrapezoid:
        return tr("Low jerk without steps at the ends; a third more acceleration than the cubic.");
    case LawId::Parabolic:
        return tr("Lowest jerk, but stepped; acceleration has a sharp peak in the middle.");
    case LawId::Trapezoid:
        return tr("Lowest acceleration, held for long; jerk steps at its four corners.");
    case LawId::SCurve:
        return tr("Trapezoid with rounded corners; two shares to tune.");
    case LawId::Exponential:
        return tr("Fast at first, then gentle; acceleration steps at both ends.");
    case LawId::HalfModifiedSine:
        return tr("Quick first half; acceleration is zero at both ends.");
    }
    return {};
}

QString RecipeWords::lawParameterName(std::string_view parameterId)
{
    if (parameterId == "ramp_fraction")
        return tr("Ramp fraction r");
    if (parameterId == "jerk_share")
        return tr("Jerk share q");
    if (parameterId == "k")
        return tr("Exponent k");
    return QString::fromUtf8(parameterId.data(), static_cast<qsizetype>(parameterId.size()));
}

QString RecipeWords::limitName(Limit limit)
{
    switch (limit) {
    case Limit::MotorSpeed:
        return tr("motor speed");
    case Limit::KnifeAcceleration:
        return tr("acceleration");
    case Limit::PulseFrequency:
        return tr("pulse frequency");
    case Limit::StrokeCannotClose:
        return tr("knife stroke");
    case Limit::RowCapacity:
        return tr("table rows");
    case Limit::MachineRate:
    case Limit::FieldRange:
    case Limit::PinnedPair:
    case Limit::LawUnknown:
    case Limit::LawParameter:
    case Limit::RatioOrder:
    case Limit::TooFewPulses:
        break;
    }
    return tr("largest rate");
}

} // namespace campanel::machine
