// SPDX-License-Identifier: Apache-2.0
#include "app/machine/recipe_words.h"

namespace campanel::machine {

using profile::Field;
using profile::LawId;
using profile::Limit;

QString RecipeWords::unit(std::string_view unit)
{
    if (unit == "mm/s^2")
        return QStringLiteral("mm/s²");
    if (unit == "deg")
        return QStringLiteral("°");
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

QString RecipeWords::kindName(profile::ProgramKind kind)
{
    using profile::ProgramKind;
    switch (kind) {
    case ProgramKind::RotaryCutter:
        return tr("Rotary cutter");
    case ProgramKind::PositionMove:
        return tr("Position move");
    case ProgramKind::SpeedMove:
        return tr("Speed move");
    case ProgramKind::PointCam:
        return tr("Point cam");
    case ProgramKind::Press:
        return tr("Press");
    }
    return {};
}

QString RecipeWords::choiceName(program::Choice choice)
{
    using program::Choice;
    switch (choice) {
    case Choice::Law:
        return tr("Law");
    case Choice::Duration:
        return tr("Duration");
    case Choice::Execution:
        return tr("Executed as");
    case Choice::SplineEnds:
        return tr("Spline ends");
    case Choice::MasterRampShape:
        return tr("Shape of the ramp");
    }
    return {};
}

QString RecipeWords::optionName(std::string_view key)
{
    if (key == "given_time")
        return tr("In a given time");
    if (key == "fastest")
        return tr("As fast as possible");
    if (key == "over_distance")
        return tr("Over a distance");
    if (key == "cam_points")
        return tr("Cam points");
    if (key == "intervals")
        return tr("Intervals");
    if (key == "natural")
        return tr("Natural");
    if (key == "clamped")
        return tr("Clamped");
    if (key == "periodic")
        return tr("Periodic");
    if (key == "trapezoid")
        return tr("Trapezoid");
    if (key == "s_curve")
        return tr("S curve");
    return QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
}

QString RecipeWords::limitName(Limit limit)
{
    switch (limit) {
    case Limit::MotorSpeed:
        return tr("motor speed");
    case Limit::KnifeAcceleration:
    case Limit::AxisAcceleration:
        return tr("acceleration");
    case Limit::MotorTorque:
        return tr("motor torque");
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
    case Limit::NoMotion:
    case Limit::DistanceTooShort:
    case Limit::DistanceSign:
    case Limit::KnotCount:
    case Limit::KnotOrder:
    case Limit::KnotSpacing:
    case Limit::KnotRange:
    case Limit::KnotEnds:
    case Limit::Overshoot:
    case Limit::WrapJump:
    case Limit::StageOrder:
    case Limit::ForceOrder:
    case Limit::MasterTooFast:
    case Limit::TableRange:
    case Limit::Reversal:
    case Limit::SpeedError:
        break;
    }
    return tr("largest rate");
}

} // namespace campanel::machine
