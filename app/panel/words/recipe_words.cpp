// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/recipe_words.h"

#include "app/panel/kit/format.h"

namespace campanel::panel {

using profile::Field;
using profile::LawId;
using profile::Limit;

QString RecipeWords::valueText(Field field, double value)
{
    const int decimals = profile::info(field).decimals;
    const Format format;
    return decimals > 2 ? format.compact(value, 2, decimals) : format.number(value, decimals);
}

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

QString RecipeWords::lawStrength(LawId law)
{
    switch (law) {
    case LawId::Cubic:
        return tr("As a speed law, acceleration is zero at both ends and peaks at only 1.5 times its mean.");
    case LawId::Quintic:
        return tr("Speed and acceleration are zero at both ends, with a short polynomial.");
    case LawId::Polynomial4567:
        return tr("Speed, acceleration and jerk are zero at both ends, which excites little vibration.");
    case LawId::Harmonic:
        return tr("Half a cosine wave gives a low peak speed (1.57) and a low peak acceleration (4.93).");
    case LawId::Cycloidal:
        return tr("Acceleration is one full sine wave: smooth, and zero at both ends.");
    case LawId::ModifiedSine:
        return tr("Low peak speed (1.76), moderate peak acceleration (5.53) and continuous acceleration suit "
                  "large inertia.");
    case LawId::ModifiedTrapezoid:
        return tr("This law has the lowest peak acceleration (4.89) of the laws without parameters and "
                  "acceleration jumps.");
    case LawId::Parabolic:
        return tr("This law has the lowest possible peak acceleration (4) from rest to rest.");
    case LawId::Trapezoid:
        return tr("At the same peak acceleration, no law has a lower peak speed; the ramp fraction trades "
                  "one for the other.");
    case LawId::SCurve:
        return tr("Acceleration does not jump; the peaks of acceleration and jerk can be set.");
    case LawId::Exponential:
        return tr("Acceleration is highest at low speed, where the motor has the most torque, and lowest "
                  "near the end speed.");
    case LawId::HalfModifiedSine:
        return tr("Acceleration is zero at both ends and peaks at only 1.57 times its mean.");
    }
    return {};
}

QString RecipeWords::lawWeakness(LawId law)
{
    switch (law) {
    case LawId::Cubic:
        return tr("As a displacement law, acceleration jumps to its peak (6) at both ends; as a speed law, "
                  "jerk does.");
    case LawId::Quintic:
        return tr("Jerk jumps at both ends; a trapezoid with ramps above 22.29 % of the move needs less peak "
                  "acceleration.");
    case LawId::Polynomial4567:
        return tr("This law has the highest peak speed (2.19) and peak acceleration (7.51) of the "
                  "displacement laws without parameters.");
    case LawId::Harmonic:
        return tr("As a displacement law, full acceleration at start and end causes jolts.");
    case LawId::Cycloidal:
        return tr("Peak speed (2) and peak acceleration (6.28) are high, and jerk jumps at both ends.");
    case LawId::ModifiedSine:
        return tr(
            "Jerk jumps at both ends and has the highest finite peak (69.5) of the laws without parameters.");
    case LawId::ModifiedTrapezoid:
        return tr("Peak speed (2) and peak jerk (61.4) are high, and jerk jumps at both ends.");
    case LawId::Parabolic:
        return tr("As a displacement law, acceleration jumps at both ends and in the middle, and peak speed "
                  "(2) is high.");
    case LawId::Trapezoid:
        return tr(
            "As a displacement law, acceleration jumps at both ends of both ramps, so jerk is unbounded.");
    case LawId::SCurve:
        return tr("Jerk jumps at every joint of the segments; a smaller jerk share means a higher jerk.");
    case LawId::Exponential:
        return tr("Acceleration jumps at both ends; a larger k increases the jump at the low speed.");
    case LawId::HalfModifiedSine:
        return tr("The law is not symmetric: from rest, the travel is 0.568 of end speed times time; jerk "
                  "jumps at both ends.");
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
        return tr("Execution");
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
        return tr("max. rate");
    case Limit::FieldRange: // for the fastest rate: the limit of the speeds in a recipe
        return tr("knife speed");
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
    case Limit::RampTooLong:
        break;
    }
    return {};
}

} // namespace campanel::panel
