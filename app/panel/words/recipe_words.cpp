// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/recipe_words.h"

#include "app/panel/kit/format.h"
#include "profile/laws/laws.h"

namespace campanel::panel {

using profile::Field;
using profile::LawId;
using profile::Limit;

// Translates a text of a table of profile/. Its sources are listed in the catalogue by hand.
QString RecipeWords::inWords(std::string_view text)
{
    return tr(std::string(text).c_str());
}

QString RecipeWords::valueText(Field field, double value)
{
    if (value == 0 && profile::isUnknownAtZero(field))
        return Format::unknownText();
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
    if (unit == "mm/deg")
        return QStringLiteral("mm/°");
    if (unit == "mm/deg^2")
        return QStringLiteral("mm/°²");
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
    const profile::Law* row = profile::findLaw(law);
    return row ? inWords(row->name) : QString();
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
    case ProgramKind::SegmentCam:
        return tr("Segment cam");
    }
    return {};
}

QString RecipeWords::listName(profile::ProgramKind kind)
{
    return program::kindInfo(kind).list == &program::segmentList ? tr("Segments") : tr("Knots");
}

QString RecipeWords::listSize(const profile::Program& program)
{
    const program::ListInfo& list = *program::kindInfo(profile::kindOf(program)).list;
    const std::size_t size = list.size(program);
    if (&list == &program::segmentList)
        return size == 1 ? tr("1 segment") : tr("%1 segments").arg(size);
    return tr("%1 knots").arg(size);
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
    case Choice::Ratios:
        return tr("Ratios");
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
    if (key == "hand")
        return tr("Set by hand");
    if (key == "gentle")
        return tr("Gentle");
    if (key == "cool")
        return tr("Cool");
    if (key == "slow")
        return tr("Slow");
    if (key == "between")
        return tr("Between");
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
    case Limit::RmsTorque:
        return tr("RMS torque");
    case Limit::NaturalFrequency:
        return tr("natural frequency");
    case Limit::PulseFrequency:
        return tr("pulse frequency");
    case Limit::StrokeCannotClose:
        return tr("knife stroke");
    case Limit::RowCapacity:
        return tr("table rows");
    case Limit::MachineRate:
        return tr("max. rate");
    case Limit::JawWindow:
        return tr("sync window");
    case Limit::SealTime:
        return tr("seal time");
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
    case Limit::SegmentCount:
    case Limit::SegmentRange:
    case Limit::SegmentWidth:
    case Limit::SegmentOverlap:
    case Limit::SegmentGap:
    case Limit::SegmentEnds:
    case Limit::SegmentMotion:
    case Limit::JointJump:
        break;
    }
    return {};
}

} // namespace campanel::panel
