// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/master_fields.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"

#include <array>
#include <cmath>
#include <vector>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr const char* masterSource = "master.source";
constexpr const char* masterCounts = "master.counts";
constexpr const char* masterRevolution = "master.revolution";
constexpr const char* masterIndexLimit = "master.index_limit";
constexpr const char* masterDelay = "master.delay";
constexpr const char* masterSmoothing = "master.smoothing";
constexpr const char* masterSlipLimit = "master.slip_limit";

struct MasterField {
    const char* name;
    const char* words;
    bool hasChoices = false;
};

// The fields in the order of the screen.
constexpr std::array masterFields{
    MasterField{"master.phase",
                QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Phase: line ahead of the master")},
    MasterField{masterSource, QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Master"), true},
    MasterField{"master.place", QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Place of the encoder"),
                true},
    MasterField{"master.signal", QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Signal of the encoder"),
                true},
    MasterField{"master.reversed", QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Reversed counting"),
                true},
    MasterField{masterCounts, QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Counts per revolution")},
    MasterField{masterRevolution, QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Film per revolution")},
    MasterField{"master.lead",
                QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Compensation of the delay"), true},
    MasterField{masterDelay, QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Delay of the drive")},
    MasterField{masterSmoothing,
                QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Smoothing: time constant")},
    MasterField{"master.engage", QT_TRANSLATE_NOOP("campanel::panel::MasterFields",
                                                   "Minimum stretch for engaging, of a cycle")},
    MasterField{"master.speed_max",
                QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Maximum speed, of the recipe's rate")},
    MasterField{"master.backward",
                QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Cam follows the master backward"), true},
    MasterField{masterIndexLimit,
                QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Index mark: tolerance")},
    MasterField{masterSlipLimit,
                QT_TRANSLATE_NOOP("campanel::panel::MasterFields", "Wheel: maximum slip between two marks")},
};

} // namespace

MasterFields::MasterFields(Controller& controller, QObject* parent)
    : ParameterFields(controller, parent)
{
    std::vector<Field> fields;
    for (const MasterField& field : masterFields)
        fields.push_back({&controller.parameter(field.name), field.words, field.hasChoices});
    setFields(std::move(fields));
}

void MasterFields::update(bool isAvailable, double smoothingMs, const program::MasterDelay& delay)
{
    Field& field = find(masterDelay);
    const auto suggestion = field.value() ? delay.offered(*field.value()) : std::nullopt;
    const bool isEqual =
        isAvailable == m_isAvailable && smoothingMs == m_smoothingMs && suggestion == field.suggestion;
    m_isAvailable = isAvailable;
    m_smoothingMs = smoothingMs;
    field.suggestion = suggestion;
    if (!isEqual)
        notifyChange();
}

QString MasterFields::label(const Field& field) const
{
    return tr(field.words);
}

// Critically damped: the position lags by acceleration x time squared, and one count is seen as a speed of at
// most one count per time constant.
QString MasterFields::smoothingNote(const Field& field) const
{
    const double setMs = field.value().value_or(unknown);
    const double timeMs = setMs > 0 ? setMs : m_smoothingMs;
    const double countMm = value(masterRevolution) / value(masterCounts);
    if (!(timeMs > 0) || !std::isfinite(countMm))
        return tr("%1 · 0: automatic").arg(range(field));
    constexpr double accelerationMmPerS2 = 1000;
    constexpr double msOfS = 1000;
    const double timeS = timeMs / msOfS;
    const Format format;
    return tr("0: automatic, %1 · lag %2 · noise %3")
        .arg(format.compactMeasure(timeMs, 0, 2, u"ms"_s),
             format.measure(accelerationMmPerS2 * timeS * timeS, 3, u"mm"_s),
             format.measure(countMm / timeS, 1, u"mm/s"_s));
}

QString MasterFields::note(const Field& field) const
{
    const std::string_view name = field.info().name;
    if (field.parameter->isMissing())
        return ParameterFields::note(field);
    if (name == masterSmoothing)
        return smoothingNote(field);
    if (name == masterIndexLimit || name == masterSlipLimit)
        return tr("%1 · 0: not monitored").arg(range(field));
    const double countMm = value(masterRevolution) / value(masterCounts);
    if (name == masterCounts && std::isfinite(countMm))
        return tr("One count is %1 of film").arg(Format().compactMeasure(countMm, 0, 4, u"mm"_s));
    return ParameterFields::note(field);
}

QString MasterFields::objection(const Field& field, double value) const
{
    const std::string_view name = field.info().name;
    if (name == masterSource && value > 0 && !m_isAvailable)
        return tr("This controller has no input for an encoder. Select the clock, or use a controller with "
                  "such an input.");
    const double counts = name == masterCounts ? value : this->value(masterCounts);
    const double limit = name == masterIndexLimit ? value : this->value(masterIndexLimit);
    if ((name == masterCounts || name == masterIndexLimit) && limit > 0 && 2 * limit >= counts)
        return tr("The tolerance of the index mark would be half a revolution or more: %1 of %2 counts. "
                  "Enter a "
                  "smaller tolerance first.")
            .arg(Format().number(limit, 0), Format().grouped(counts, 0));
    return {};
}

} // namespace campanel::panel
