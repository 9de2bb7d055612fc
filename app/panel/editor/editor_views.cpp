// SPDX-License-Identifier: Apache-2.0
#include "app/panel/editor/editor_views.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/units.h"
#include "app/panel/recipe/recipe_edit.h"
#include "app/panel/words/cam_sentences.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/panel/words/register_words.h"
#include "profile/cutter/explain.h"
#include "profile/cutter/jaw.h"
#include "profile/cutter/ratios.h"
#include "profile/laws/laws.h"

#include <algorithm>
#include <cmath>

namespace campanel::panel {

namespace {

using profile::Field;

profile::LawId lawOf(const program::Recipe& recipe)
{
    return static_cast<profile::LawId>(program::choice(recipe.program, program::Choice::Law));
}

profile::CutterQuantity quantityOf(Field field)
{
    switch (field) {
    case Field::BagLength:
        return profile::CutterQuantity::BagLength;
    case Field::Rate:
        return profile::CutterQuantity::Rate;
    case Field::BaseSpeed:
        return profile::CutterQuantity::BaseSpeed;
    default:
        return profile::CutterQuantity::FilmSpeed;
    }
}

} // namespace

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
    view.pinnable = profile::isCycleField(field);
    view.pinned = view.pinnable && profile::isPinned(m_recipe.cutter(), field);
    view.derived = view.pinnable && !view.pinned;
    if (!view.derived || m_solution.solved)
        view.value = program::value(m_recipe, field);
    view.text = RecipeWords::valueText(field, view.value);
    if (m_active && m_active->recipe.kind() == m_recipe.kind() && program::isInController(m_recipe, field))
        view.activeText = RecipeWords::valueText(field, program::value(m_active->recipe, field));
    if (field == Field::Rate && m_solution.fastest)
        view.possible = m_solution.fastest->rateBagsPerMin;
    if (profile::isRatio(field))
        narrowRatio(field, view);
    view.explanation =
        view.derived && m_solution.cutter() ? explanation(field) : RecipeWords::inWords(info.help);
    if (m_maxSpeedShare)
        tellMaster(field, view);
    return view;
}

// The rate is that of the line at its maximum speed.
void EditorViews::tellMaster(Field field, FieldView& view) const
{
    if (field == Field::MasterRate)
        view.label = tr("Max. master speed");
    if (field != Field::Rate)
        return;
    view.label = tr("Rate at max. line speed");
    const double mmPerS = program::value(m_recipe, Field::BagLength) * view.value / 60;
    if (!std::isfinite(mmPerS))
        return;
    const QString speed = QStringLiteral("mm/s");
    view.explanation +=
        (view.explanation.isEmpty() ? QString() : QStringLiteral("\n")) +
        tr("An encoder leads: the line travels %1 of film at this rate. The run ends above %2.")
            .arg(Format().measure(mmPerS, 1, speed), Format().measure(*m_maxSpeedShare * mmPerS, 1, speed));
}

// Limits a ratio to the range between its neighbors.
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
    const profile::Explanation explained = profile::explain(*m_solution.cutter(), quantityOf(field));
    const Format format;
    const QString unit = RecipeWords::unit(explained.unit);
    QString result = Format::joined(format.compact(explained.result, 1, 4), unit); // the formula is metric
    if (Units::of(unit).isConverted())
        result += QStringLiteral(" = ") + format.compactMeasure(explained.result, 1, 4, unit);
    return QStringLiteral("%1\n= %2\n= %3")
        .arg(QString::fromStdString(explained.formula), QString::fromStdString(explained.numbers), result);
}

FieldView EditorViews::lawParameter(std::size_t index) const
{
    FieldView view;
    const auto* parameters = program::lawParameters(m_recipe.program);
    const profile::Law* law = parameters ? profile::findLaw(lawOf(m_recipe)) : nullptr;
    view.visible = law && index < law->parameters.size();
    if (!view.visible)
        return view;
    const profile::LawParameterInfo& info = law->parameters[index];
    view.label = RecipeWords::inWords(info.name);
    view.minimum = info.min;
    view.maximum = info.max;
    view.defaultValue = info.defaultValue;
    view.decimals = info.decimals;
    view.value = (*parameters)[index];
    view.text = Format().number(view.value, view.decimals);
    if (m_active && m_active->recipe.kind() == m_recipe.kind() && lawOf(m_active->recipe) == law->id)
        view.activeText =
            Format().number((*program::lawParameters(m_active->recipe.program))[index], view.decimals);
    return view;
}

program::Recipe EditorViews::withLaw(const profile::Law& law) const
{
    program::Recipe tried = m_recipe;
    chooseLaw(tried, law);
    if (m_solution.solved)
        tried.machine = m_solution.solved->machine;
    return tried;
}

// Returns the demands of a recipe; unknown without a motion.
LawDemand EditorViews::demandOf(const program::Recipe& tried) const
{
    LawDemand demand;
    demand.peaks.motorRpm = demand.peaks.accelerationMmPerS2 = demand.peaks.pulseFrequencyHz =
        demand.peaks.jerkMmPerS3 = demand.peaks.torqueNm = demand.peaks.rmsTorqueNm = NAN;
    demand.rmsAccelerationMmPerS2 = NAN;
    if (!tried.isCutter()) {
        if (const auto solved = program::solveProgram(tried)) {
            demand.peaks = solved->peaks;
            demand.isFeasible = solved->broken.empty();
            demand.vibrationMm = program::vibrationMm(tried, *solved);
        }
        return demand;
    }
    // Without its curves: up to twelve cutters are solved after each change while the laws are displayed.
    demand.isFeasible = profile::isFeasible(tried.cutter(), tried.machine);
    if (const auto cycle = profile::solveNumbers(tried.cutter(), tried.machine)) {
        demand.peaks = profile::peaks(*cycle, tried.cutter(), tried.machine);
        demand.rmsAccelerationMmPerS2 = profile::rmsAcceleration(*cycle, tried.cutter());
        if (hasVibration())
            demand.vibrationMm = profile::sealErrorMm(*profile::solve(tried.cutter(), tried.machine));
    }
    return demand;
}

bool EditorViews::hasTorque() const
{
    return !m_recipe.isCutter() || m_recipe.machine.inertiaKgCm2 > 0;
}

// The column of the torque has the RMS value where the torque is known.
bool EditorViews::hasRmsAcceleration() const
{
    return m_recipe.isCutter() && !hasTorque();
}

bool EditorViews::hasVibration() const
{
    return m_recipe.machine.naturalFrequencyHz > 0;
}

QStringList EditorViews::lawColumns() const
{
    QStringList columns{tr("Peak speed"), tr("Acceleration")};
    if (hasRmsAcceleration())
        columns << tr("RMS");
    columns << tr("Jerk") << (hasTorque() ? tr("Torque,\nRMS") : tr("Frequency"));
    if (hasVibration())
        columns << (m_recipe.isCutter() ? tr("Error while\nsealing") : tr("Vibration\nafter the move"));
    return columns;
}

LawRow EditorViews::lawRow(const profile::Law& law, const LawDemand& demand) const
{
    const Format format;
    const profile::Peaks& peaks = demand.peaks;
    constexpr double mmPerM = 1000;
    const QString perS2 = QStringLiteral("m/s²");
    LawRow row;
    row.lawId = QString::fromUtf8(law.key.data(), static_cast<qsizetype>(law.key.size()));
    row.name = RecipeWords::inWords(law.name);
    row.shape = shapeOf(law);
    row.strength = RecipeWords::inWords(law.strength);
    row.weakness = RecipeWords::inWords(law.weakness);
    row.current = law.id == lawOf(m_recipe);
    row.usable = demand.isFeasible;
    row.peakRpmText = tr("%1 r/min").arg(format.number(peaks.motorRpm, 0));
    row.peakAccelerationText = format.measure(peaks.accelerationMmPerS2 / mmPerM, 2, perS2);
    if (hasRmsAcceleration())
        row.rmsText = format.measure(demand.rmsAccelerationMmPerS2 / mmPerM, 2, perS2);
    row.peakFrequencyText =
        hasTorque() ? tr("%1 Nm\nRMS %2", "peak and RMS torque")
                          .arg(format.number(peaks.torqueNm, 3), format.number(peaks.rmsTorqueNm, 3))
                    : tr("%1 kHz").arg(format.number(peaks.pulseFrequencyHz / 1000, 1));
    if (hasVibration())
        row.vibrationText = format.measure(demand.vibrationMm, 3, QStringLiteral("mm"));
    const double jerk = peaks.jerkMmPerS3 / mmPerM;
    row.peakJerkText = std::isinf(jerk) ? tr("unbounded")
                                        : format.measure(jerk, jerk < 1000 ? 1 : 0, QStringLiteral("m/s³"));
    return row;
}

QList<LawRow> EditorViews::laws(std::optional<profile::LawId> compared) const
{
    QList<LawRow> rows;
    const auto append = [&](const profile::Law& law, const LawDemand& demand) {
        LawRow row = lawRow(law, demand);
        row.compared = compared == law.id;
        rows << row;
    };
    if (m_recipe.isCutter()) {
        const bool isByHand = m_recipe.cutter().ratioMode == profile::RatioMode::ByHand;
        const profile::Machine& machine = m_solution.solved ? m_solution.solved->machine : m_recipe.machine;
        for (const profile::RankedLaw& each : profile::rankLaws(m_recipe.cutter(), machine)) {
            const profile::Law& law = *profile::findLaw(each.program.speedLaw);
            program::Recipe tried = withLaw(law);
            if (!isByHand)
                tried.cutter() = each.program;
            append(law, demandOf(tried));
        }
        return rows;
    }
    if (!program::lawParameters(m_recipe.program))
        return rows;
    for (const profile::Law& law : profile::laws()) {
        if (program::isLawOf(m_recipe.kind(), law))
            append(law, demandOf(withLaw(law)));
    }
    return rows;
}

QString EditorViews::peaks() const
{
    if (!m_solution.solved)
        return {};
    const Format format;
    const profile::Peaks& peaks = m_solution.solved->peaks;
    const QString acceleration = format.measure(peaks.accelerationMmPerS2 / 1000, 2, QStringLiteral("m/s²"));
    // The recipe of a press has no inertia, that of a cutter may have one.
    if (m_recipe.kind() != profile::ProgramKind::Press && hasTorque())
        return tr("peak %1 r/min · %2 · %3 Nm (RMS %5) · %4 kHz")
            .arg(format.number(peaks.motorRpm, 0), acceleration, format.number(peaks.torqueNm, 3),
                 format.number(peaks.pulseFrequencyHz / 1000, 1), format.number(peaks.rmsTorqueNm, 3));
    const auto* cutter = m_solution.cutter();
    if (cutter && cutter->machine.contactAngleDeg > 0)
        return tr("peak %1 r/min · %2 · %3 kHz · seal %4 ms")
            .arg(format.number(peaks.motorRpm, 0), acceleration,
                 format.number(peaks.pulseFrequencyHz / 1000, 1),
                 format.number(profile::sealTimeMs(cutter->cycle, cutter->machine), 0));
    return tr("peak %1 r/min · %2 · %3 kHz")
        .arg(format.number(peaks.motorRpm, 0), acceleration, format.number(peaks.pulseFrequencyHz / 1000, 1));
}

QString EditorViews::verdict() const
{
    if (!m_solution.refusals.empty()) {
        const profile::Refusal& refusal = m_solution.refusals.front();
        const QString sentence = RefusalSentences::refusal(refusal);
        return refusal.limit == profile::Limit::MachineRate && m_solution.fastest
                   ? QStringLiteral("%1 %2").arg(sentence, RefusalSentences::possible(*m_solution.fastest))
                   : sentence;
    }
    if (m_solution.unstorable)
        return RegisterWords::outOfRange(*m_solution.unstorable);
    if (m_solution.isTablePending)
        return tr("Within all limits; building the table …");
    if (!m_recipe.isCutter()) {
        const QString limits =
            m_solution.isCloseToLimit() ? tr("Just within the limits.") : tr("Within all limits.");
        return QStringLiteral("%1 %2").arg(limits, CamSentences::ends(m_recipe.program)).trimmed();
    }
    return m_solution.isCloseToLimit() ? RefusalSentences::closeToLimits(m_solution.fastest)
                                       : RefusalSentences::withinLimits(m_solution.fastest);
}

} // namespace campanel::panel
