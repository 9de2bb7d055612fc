// SPDX-License-Identifier: Apache-2.0
#include "app/machine/editor_views.h"

#include "app/machine/format.h"
#include "app/machine/recipe_edit.h"
#include "app/machine/recipe_words.h"
#include "app/machine/refusal_sentences.h"
#include "profile/explain.h"
#include "profile/laws.h"
#include "profile/paper_table.h"

#include <algorithm>
#include <cmath>

namespace campanel::machine {

namespace {

using profile::Field;

bool isRatio(Field field)
{
    return field >= Field::K1 && field <= Field::K4;
}

profile::Quantity quantityOf(Field field)
{
    switch (field) {
    case Field::BagLength:
        return profile::Quantity::BagLength;
    case Field::Rate:
        return profile::Quantity::Rate;
    case Field::BaseSpeed:
        return profile::Quantity::BaseSpeed;
    default:
        return profile::Quantity::FilmSpeed;
    }
}

} // namespace

QString EditorViews::valueText(Field field, double value)
{
    const int decimals = profile::info(field).decimals;
    const Format format;
    return decimals > 2 ? format.compact(value, 2, decimals) : format.number(value, decimals);
}

FieldView EditorViews::field(Field field) const
{
    const profile::FieldInfo& info = profile::info(field);
    FieldView view;
    view.label = RecipeWords::fieldName(field);
    view.unit = RecipeWords::unit(info.unit);
    view.minimum = info.min;
    view.maximum = info.max;
    view.defaultValue = info.defaultValue;
    view.decimals = info.decimals;
    view.pinnable = isPinnable(field);
    view.pinned = view.pinnable && profile::isPinned(m_recipe.program, field);
    view.derived = view.pinnable && !view.pinned;
    if (!view.derived || m_solution.cutter)
        view.value = program::value(m_recipe, field);
    view.text = valueText(field, view.value);
    if (m_active && program::isProgramField(field))
        view.activeText = valueText(field, program::value(m_active->recipe, field));
    if (isRatio(field))
        narrowRatio(field, view);
    if (view.derived && m_solution.cutter)
        view.explanation = explanation(field);
    return view;
}

// A ratio may be entered between its neighbors only.
void EditorViews::narrowRatio(Field field, FieldView& view) const
{
    const double step = profile::info(field).resolution();
    const auto neighbor = [&](int offset) {
        return program::value(m_recipe, static_cast<Field>(static_cast<int>(field) + offset));
    };
    if (field != Field::K1)
        view.maximum = std::min(view.maximum, neighbor(-1) - step);
    if (field != Field::K4)
        view.minimum = std::max(view.minimum, neighbor(+1) + step);
}

QString EditorViews::explanation(Field field) const
{
    const profile::Explanation explained = profile::explain(*m_solution.cutter, quantityOf(field));
    return QStringLiteral("%1\n= %2\n= %3 %4")
        .arg(QString::fromStdString(explained.formula), QString::fromStdString(explained.numbers),
             Format().compact(explained.result, 1, 4), RecipeWords::unit(explained.unit));
}

FieldView EditorViews::lawParameter(std::size_t index) const
{
    FieldView view;
    const profile::Law* law = profile::findLaw(m_recipe.program.speedLaw);
    view.visible = law && index < law->parameters.size();
    if (!view.visible)
        return view;
    const profile::LawParameterInfo& info = law->parameters[index];
    view.label = RecipeWords::lawParameterName(info.id);
    view.minimum = info.min;
    view.maximum = info.max;
    view.defaultValue = info.defaultValue;
    view.decimals = info.decimals;
    view.value = m_recipe.program.speedLawParameters[index];
    view.text = Format().number(view.value, view.decimals);
    if (m_active && m_active->recipe.program.speedLaw == m_recipe.program.speedLaw)
        view.activeText = Format().number(m_active->recipe.program.speedLawParameters[index], view.decimals);
    return view;
}

QList<LawRow> EditorViews::laws() const
{
    const Format format;
    QList<LawRow> rows;
    for (const profile::Law& law : profile::laws()) {
        if (!law.isSpeedLaw)
            continue;
        LawRow row;
        row.lawId = QString::fromUtf8(law.key.data(), static_cast<qsizetype>(law.key.size()));
        row.name = RecipeWords::lawName(law.id);
        row.hint = RecipeWords::lawHint(law.id);
        row.current = law.id == m_recipe.program.speedLaw;
        program::Recipe tried = m_recipe;
        chooseLaw(tried, law);
        const profile::Machine& machine = m_solution.cutter ? m_solution.cutter->machine : tried.machine;
        row.usable = profile::isFeasible(tried.program, machine);
        profile::Peaks peaks;
        peaks.motorRpm = peaks.accelerationMmPerS2 = peaks.pulseFrequencyHz = peaks.jerkMmPerS3 = NAN;
        if (const auto cycle = profile::solveNumbers(tried.program, machine))
            peaks = profile::peaks(*cycle, tried.program, machine);
        row.peakRpmText = tr("%1 r/min").arg(format.number(peaks.motorRpm, 0));
        row.peakAccelerationText = tr("%1 m/s²").arg(format.number(peaks.accelerationMmPerS2 / 1000, 2));
        row.peakFrequencyText = tr("%1 kHz").arg(format.number(peaks.pulseFrequencyHz / 1000, 1));
        row.peakJerkText = std::isinf(peaks.jerkMmPerS3)
                               ? tr("acceleration steps")
                               : tr("%1 m/s³").arg(format.number(peaks.jerkMmPerS3 / 1000, 1));
        rows << row;
    }
    return rows;
}

QString EditorViews::peaks() const
{
    if (!m_solution.cutter)
        return {};
    const Format format;
    return tr("peak %1 r/min · %2 m/s² · %3 kHz")
        .arg(format.number(m_solution.peaks.motorRpm, 0),
             format.number(m_solution.peaks.accelerationMmPerS2 / 1000, 2),
             format.number(m_solution.peaks.pulseFrequencyHz / 1000, 1));
}

QStringList EditorViews::tableSummary() const
{
    if (!m_solution.image)
        return {};
    const program::ProgramImage& image = *m_solution.image;
    const profile::StepTable& table = image.table;
    const profile::TableErrors& errors = table.errors;
    const Format format;
    QStringList lines;
    lines << tr("%1 rows, %2 pulses per cycle, %3 s")
                 .arg(table.rows.size())
                 .arg(format.compact(table.pulses.asDouble(), 0, 4))
                 .arg(format.compact(
                     static_cast<double>(table.cycleTicks) / image.cutter.machine.timerClockHz, 3, 6));
    lines << tr("Largest speed error: %1 mm/s (%2 %) at %3 s")
                 .arg(format.number(errors.speedMmPerS, 2), format.number(errors.speedPercent, 2),
                      format.number(errors.speedTimeS, 3));
    lines << tr("Largest frequency step: %1 Hz at %2 s")
                 .arg(format.number(errors.frequencyStepHz, 0), format.number(errors.frequencyStepTimeS, 3));
    lines << tr("Largest position error: %1 pulses between rows, %2 inside")
                 .arg(format.number(errors.boundaryPulses, 2), format.number(errors.insidePulses, 2));
    lines << tr("Drift: none, the fraction of a pulse is carried from cycle to cycle");
    const profile::PaperTable paper = profile::paperTable(image.cutter, image.recipe.program.slicesPerRamp);
    lines << tr("The paper's rule would be wrong by %1 pulses (%2 mm) in each bag")
                 .arg(format.number(std::abs(paper.errorPulses), 0),
                      format.number(std::abs(paper.errorMm), 2));
    return lines;
}

QString EditorViews::verdict() const
{
    if (!m_solution.refusals.empty())
        return RefusalSentences::refusal(m_solution.refusals.front());
    if (m_solution.unstorable)
        return tr("The controller cannot hold the value %1 (%2 to %3). Choose another one.")
            .arg(m_solution.unstorable->value)
            .arg(m_solution.unstorable->minimum)
            .arg(m_solution.unstorable->maximum);
    return m_solution.isCloseToLimit() ? RefusalSentences::closeToLimits(m_solution.fastest)
                                       : RefusalSentences::withinLimits(m_solution.fastest);
}

} // namespace campanel::machine
