// SPDX-License-Identifier: Apache-2.0
#include "app/panel/packing/packing_fields.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"

#include <array>
#include <charconv>
#include <string>
#include <utility>

namespace campanel::panel {

namespace {

constexpr std::string_view markDeadTime = "parameter.mark_dead_time";
constexpr std::string_view eyeDeadTime = "parameter.eye_dead_time";
constexpr std::string_view eyeEndDeadTime = "parameter.eye_end_dead_time";
constexpr const char* markEndLater = "parameter.mark_end_later";
constexpr const char* jawsBefore = "parameter.jaws_before";
constexpr const char* jawsBehind = "parameter.jaws_behind";
constexpr const char* markWidthMin = "parameter.mark_width_min";
constexpr const char* markWidthMax = "parameter.mark_width_max";
constexpr const char* jamDetection = "parameter.jam_detection";
constexpr const char* jamStopTime = "parameter.jam_stop_time";
constexpr const char* jamBack = "parameter.jam_back";

constexpr const char* knifeWords =
    QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Knife %1 cuts behind its place by");
constexpr std::string_view knifePrefix = "parameter.knife_";

std::string knifeName(int knife)
{
    return std::string(knifePrefix) + std::to_string(knife);
}

struct Listed {
    const char* name;
    const char* words;
    bool isSwitch;
};

// The fields in the order of the screen; the register map has the texts.
constexpr std::array listed{
    Listed{"parameter.mark_tracking", QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Mark tracking"),
           true},
    Listed{"parameter.phase_gain",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Phase gain: correction of slip"), false},
    Listed{"parameter.length_gain",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Length gain: correction of length"), false},
    Listed{"parameter.mark_distance",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Mark sensor to knife"), false},
    Listed{"parameter.mark_offset",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Cut offset behind its mark"), false},
    Listed{"parameter.mark_window", QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Mark window, ±"),
           false},
    Listed{"parameter.mark_dead_time",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Mark sensor: dead time"), false},
    Listed{markEndLater,
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Mark sensor: more dead time at a mark's end"),
           false},
    Listed{markWidthMin, QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Mark width, minimum"), false},
    Listed{markWidthMax, QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Mark width, maximum"), false},
    Listed{"parameter.mark_masking",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Ignored film behind a mark"), false},
    Listed{"parameter.mark_missing_limit",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Missing marks in a row before stop"), false},
    Listed{"parameter.phase_limit",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Phase limit: max. shift of a cut"), false},
    Listed{"parameter.length_limit",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Length limit: max. change of a bag"), false},
    Listed{"parameter.length_trim",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Length trim without marks"), false},
    Listed{"parameter.anti_cut",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Anti-cut: knife stays open over product"),
           true},
    Listed{"parameter.cut_clearance",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Clearance on both sides of a cut"), false},
    Listed{"parameter.skip_limit",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Skipped cuts in a row before stop"), false},
    Listed{"parameter.empty_bag",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Film waits for a missing product"), true},
    Listed{"parameter.product_distance",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Product placement to knife"), false},
    Listed{"parameter.eye_distance",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Product eye to placement"), false},
    Listed{"parameter.eye_dead_time",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Product eye: dead time, product comes"),
           false},
    Listed{"parameter.eye_end_dead_time",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Product eye: dead time, product ends"),
           false},
    Listed{"parameter.product_length_max",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Product length, maximum"), false},
    Listed{"parameter.flight_pitch",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Product pitch on the infeed"), false},
    Listed{"parameter.flight_pulses",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Infeed motor: pulses per product"), false},
    Listed{"parameter.thread_up",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Thread up: knife open until a mark is there"),
           true},
    Listed{jawsBefore, QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Jaws close before the cut by"),
           false},
    Listed{jawsBehind, QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Jaws open behind the cut by"),
           false},
    Listed{"parameter.park_delay",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Delay before the knife opens after a stop"),
           false},
    Listed{"parameter.jaws_closed_max",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Closed jaws spoil the film after"), false},
    Listed{jamDetection,
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Jam detection: stop at once at a jam"), true},
    Listed{
        "parameter.jam_closing",
        QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Jam detection: knife closes before the cut by"),
        false},
    Listed{
        "parameter.jam_margin",
        QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Jam detection: margin beyond the torque band"),
        false},
    Listed{jamStopTime,
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Jam: time from full speed to standstill"),
           false},
    Listed{jamBack, QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Jam: knife goes back by"), false},
    Listed{"parameter.film_feed",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Film motor: film per revolution"), false},
    Listed{"parameter.film_pulses",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Film motor: pulses per revolution"), false},
    Listed{"parameter.knife_step",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Knife: max. speed step at a change"), false},
    Listed{"parameter.film_step",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Film: max. speed step at a change"), false},
    Listed{"parameter.infeed_step",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Infeed: max. speed step at a change"), false},
};

} // namespace

PackingFields::PackingFields(Controller& controller, QObject* parent)
    : ParameterFields(controller, parent)
{
    setKnives(1);
}

void PackingFields::setKnives(int knives)
{
    std::vector<Field> fields;
    for (const Listed& field : listed)
        fields.push_back({&controller().parameter(field.name), field.words, field.isSwitch});
    for (int knife = 2; knife <= knives; ++knife)
        fields.push_back({&controller().parameter(knifeName(knife)), knifeWords});
    setFields(std::move(fields));
}

QString PackingFields::words(const QString& name)
{
    for (const Listed& field : listed) {
        if (name == QLatin1String(field.name))
            return tr(field.words);
    }
    const int knife = knifeOf(name.toStdString());
    return knife > 0 ? tr(knifeWords).arg(knife) : QString();
}

int PackingFields::knifeOf(std::string_view name)
{
    int knife = 0;
    if (name.starts_with(knifePrefix))
        std::from_chars(name.data() + knifePrefix.size(), name.data() + name.size(), knife);
    return knife;
}

QString PackingFields::label(const Field& field) const
{
    const int knife = knifeOf(field.info().name);
    return knife > 0 ? tr(field.words).arg(knife) : tr(field.words);
}

void PackingFields::suggestKnives(const program::KnifePlaces& places)
{
    for (int knife = 2; knife <= places.knives(); ++knife) {
        Field& field = find(knifeName(knife));
        field.suggestion = field.value() ? places.offered(knife, *field.value()) : std::nullopt;
    }
    notifyChange();
}

void PackingFields::suggest(const std::optional<GainSuggestion>& gains, int bags)
{
    m_gains = gains;
    m_bags = bags;
    find("parameter.phase_gain").suggestion = gains ? std::optional(gains->phaseGain) : std::nullopt;
    find("parameter.length_gain").suggestion = gains ? std::optional(gains->lengthGain) : std::nullopt;
    notifyChange();
}

void PackingFields::suggestDeadTime(const program::DeadTimeEstimate& estimate)
{
    Field& field = find(markDeadTime);
    m_deadTime = estimate.estimate();
    field.suggestion = field.value() ? estimate.offered(*field.value()) : std::nullopt;
    notifyChange();
}

void PackingFields::suggestEyeDeadTimes(const program::EyeDeadTime& measurement)
{
    using Eye = program::EyeDeadTime;
    m_eye = measurement;
    for (const auto& [name, edge] :
         {std::pair(eyeDeadTime, Eye::Begin), std::pair(eyeEndDeadTime, Eye::End)}) {
        Field& field = find(name);
        field.suggestion = field.value() ? m_eye.offered(edge, *field.value()) : std::nullopt;
    }
    notifyChange();
}

QString PackingFields::eyeNote(const Field& field, program::EyeDeadTime::Edge edge) const
{
    const auto measured = m_eye.measured(edge);
    if (!measured)
        return tr("%1 · to measure this, fix one part on the infeed and run at two speeds").arg(range(field));
    const Format format;
    const QString marginMs = format.number(measured->marginMs, 2);
    if (measured->marginMs > program::EyeDeadTime::maxMarginMs)
        return tr("%1 · not offered: margin ±%2 ms, at most %3 ms. Fix one part on the infeed and run at two "
                  "speeds.")
            .arg(range(field), marginMs, format.number(program::EyeDeadTime::maxMarginMs, 1));
    return tr("%1 · measured: %2 ms, margin ±%3 ms")
        .arg(range(field), format.number(measured->ms, 2), marginMs);
}

QString PackingFields::deadTimeNote(const Field& field) const
{
    if (!m_deadTime)
        return tr("%1 · learned from starts, stops and changes of rate: too few marks so far")
            .arg(range(field));
    const Format format;
    const QString learned =
        tr("%1 · learned: %2 ms, margin ±%3 ms")
            .arg(range(field), format.number(m_deadTime->ms, 2), format.number(m_deadTime->marginMs, 2));
    const bool isSlower =
        field.suggestion && field.value().value_or(0) > 0 && *field.suggestion > *field.value();
    return isSlower ? tr("%1. It answers later than entered: clean and check it.").arg(learned) : learned;
}

// The end of a mark has a dead time, too, within the same limits.
QString PackingFields::endObjection(const Field& field, double value) const
{
    const bool isDeadTime = field.info().name == markDeadTime;
    const double endMs = value + this->value(isDeadTime ? markEndLater : markDeadTime.data());
    if (!(endMs < 0 || endMs > program::maxDeadTimeMs))
        return {};
    const Format format;
    return tr("The end of a mark would have a dead time of %1 ms; it must be 0 to %2 ms. Change the other "
              "time "
              "first.")
        .arg(format.number(endMs, 2), format.number(program::maxDeadTimeMs, 0));
}

QString PackingFields::objection(const Field& field, double value) const
{
    // Returns the value of a field as it would be afterwards.
    const auto then = [&](const char* name) { return field.info().name == name ? value : this->value(name); };
    if (field.info().name == markDeadTime || field.info().name == markEndLater)
        return endObjection(field, value);
    if (field.info().name == markWidthMin || field.info().name == markWidthMax)
        return markWidthObjection(then(markWidthMin), then(markWidthMax));
    if (field.info().name == jamStopTime)
        return stopTimeObjection(value);
    const bool isOfJaws = field.info().name == jawsBefore || field.info().name == jamDetection;
    if (field.info().name == jamBack || (isOfJaws && then(jamDetection) > 0))
        return backObjection(then(jamBack), then(jawsBefore));
    return {};
}

QString PackingFields::markWidthObjection(double minimum, double maximum)
{
    if (!(minimum > maximum && maximum > 0))
        return {};
    const Format format;
    return tr("No mark would fit: at least %1, at most %2. Change the other one first.")
        .arg(format.measure(minimum, 2, QStringLiteral("mm")),
             format.measure(maximum, 2, QStringLiteral("mm")));
}

bool PackingFields::areJawsHalfKnown() const
{
    const double before = value(jawsBefore);
    const double behind = value(jawsBehind);
    return before + behind > 0 && before * behind == 0;
}

QString PackingFields::backObjection(double backDeg, double jawsDeg)
{
    if (!(backDeg <= jawsDeg))
        return {};
    return tr("The jaws would stay closed after a jam: they close %1° before the cut. The knife must go back "
              "by more than that.")
        .arg(Format().compact(jawsDeg, 0, 2));
}

// The knife stops from its speed at the cut; the film stops in the same time.
QString PackingFields::stopTimeObjection(double timeMs) const
{
    const auto& program = controller().program();
    const auto& machine = controller().torque()->machineData();
    const auto* cutter =
        program ? std::get_if<profile::RotaryCutterProgram>(&program->recipe.program) : nullptr;
    if (!cutter || !machine || !(machine->maxKnifeAccelerationMmPerS2 > 0))
        return {};
    constexpr double msPerS = 1000;
    const double speedMmPerS = cutter->syncRatio * program->bagLengthMm / program->cycleSeconds;
    const double leastMs = msPerS * speedMmPerS / machine->maxKnifeAccelerationMmPerS2;
    if (!(timeMs < leastMs))
        return {};
    return tr("Too short for the knife: with its maximum acceleration it needs %1 ms from its speed at the "
              "cut. Enter at least that time.")
        .arg(Format().number(std::ceil(leastMs), 0));
}

QString PackingFields::note(const Field& field) const
{
    if (field.info().name == markDeadTime && !field.parameter->isMissing())
        return deadTimeNote(field);
    if (field.info().name == eyeDeadTime && !field.parameter->isMissing())
        return eyeNote(field, program::EyeDeadTime::Begin);
    if (field.info().name == eyeEndDeadTime && !field.parameter->isMissing())
        return eyeNote(field, program::EyeDeadTime::End);
    if ((field.info().name == jawsBefore || field.info().name == jawsBehind) && areJawsHalfKnown())
        return tr("%1 · leaves out the cut: enter both angles, or 0 for both").arg(range(field));
    const bool isGain =
        field.info().name == "parameter.phase_gain" || field.info().name == "parameter.length_gain";
    if (!isGain)
        return field.info().text.find(", 0: ") == std::string_view::npos
                   ? ParameterFields::note(field)
                   : tr("%1 · 0: not used").arg(range(field));
    if (!m_gains && m_bags >= GainEstimate::minBags)
        return tr("%1 · no suggestion: the mark positions do not vary (%2 bags)")
            .arg(range(field), QString::number(m_bags));
    if (!m_gains)
        return tr("%1 · too few bags for a suggestion, still needed: %2")
            .arg(range(field), QString::number(GainEstimate::minBags - m_bags));
    const Format format;
    return tr("%1 · margin ±%5: film slip %2 per bag, sensor std dev %3 (%4 bags)")
        .arg(range(field), format.measure(m_gains->slipMm, 3, QStringLiteral("mm")),
             format.measure(m_gains->sensorMm, 3, QStringLiteral("mm")), QString::number(m_bags),
             format.number(m_gains->margin, 2));
}

} // namespace campanel::panel
