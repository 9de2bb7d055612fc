// SPDX-License-Identifier: Apache-2.0
// The property getters of Editor, from the recipe and its solution.
#include "app/panel/editor/editor.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor_views.h"
#include "app/panel/recipe/curve_shape.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/program/cam_advance.h"

namespace campanel::panel {

using profile::Field;

QString Editor::lawName() const
{
    return RecipeWords::lawName(
        static_cast<profile::LawId>(program::choice(m_recipe.program, program::Choice::Law)));
}

QStringList Editor::lawColumns() const
{
    return EditorViews(m_recipe, m_solution, nullptr).lawColumns();
}

QString Editor::verdict() const
{
    const QString refusal = feasible() ? m_controller.masterSetting()->refusal(m_recipe) : QString();
    return refusal.isEmpty() ? EditorViews(m_recipe, m_solution, nullptr).verdict() : refusal;
}

Editor::Severity Editor::severity() const
{
    if (!feasible() && !m_solution.isTablePending)
        return Severity::Bad;
    const bool warns = m_solution.isCloseToLimit() || !program::isAdvanceConfirmed(m_recipe.program) ||
                       !m_controller.masterSetting()->refusal(m_recipe).isEmpty();
    return warns ? Severity::Warning : Severity::Good;
}

QString Editor::suggestionText() const
{
    return suggestion() ? RefusalSentences::suggestion(*suggestion()) : QString();
}

CutterParts Editor::cutter()
{
    return {ramps(), map()};
}

EditorField* Editor::field(const QString& name)
{
    const std::optional<profile::Field> field = profile::fieldById(name.toStdString());
    return field ? item(*field) : nullptr;
}

EditorPlot Editor::plot() const
{
    EditorPlot plot;
    plot.peakText = peakText();
    if (m_solution.curves)
        plot.curves = QVariant::fromValue(m_solution.curves);
    plot.cycleSeconds = m_cycleSeconds;
    const profile::Machine& limits = m_solution.solved ? m_solution.solved->machine : m_recipe.machine;
    plot.limitFrequency = profile::pulseFrequencyLimitHz(limits);
    plot.hasTorque = m_solution.curves && !m_solution.curves->torqueNm.empty();
    if (m_solution.solved)
        plot.rmsTorque = m_solution.solved->peaks.rmsTorqueNm;
    if (limits.maxTorqueNm > 0)
        plot.limitTorque = limits.maxTorqueNm;
    if (m_recipe.isCutter()) {
        for (const double k : m_recipe.cutter().k)
            plot.ratioTimes << m_cycleSeconds / k;
        plot.markTimes = plot.ratioTimes;
        plot.limitVelocity = limits.maxMotorRpm / profile::motorRpmPerMmPerS(limits);
        plot.limitAcceleration = limits.maxKnifeAccelerationMmPerS2;
    } else {
        if (m_solution.solved)
            plot.markTimes = {m_solution.solved->marksS.begin(), m_solution.solved->marksS.end()};
        plot.limitVelocity = limits.maxMotorRpm / profile::axisRpmPerMmPerS(limits);
        plot.limitAcceleration = limits.maxAccelerationMmPerS2;
    }
    for (const profile::Refusal& refusal : m_solution.refusals) {
        for (const profile::TimeSpan& span : refusal.brokenDuring)
            plot.violations << QPointF(span.fromS, span.toS);
    }
    return plot;
}

QString Editor::peakText() const
{
    return EditorViews(m_recipe, m_solution, nullptr).peaks();
}

QVariantList Editor::fields() const
{
    QVariantList items;
    for (const Field field : m_shownFields)
        items << QVariant::fromValue(m_fields[static_cast<std::size_t>(field)]);
    return items;
}

QVariantList Editor::machineFields() const
{
    QVariantList items;
    for (const Field field : program::kindInfo(m_recipe.kind()).machineFields)
        items << QVariant::fromValue(m_fields[static_cast<std::size_t>(field)]);
    return items;
}

QVariantList Editor::kinds() const
{
    QVariantList kinds;
    for (const program::KindInfo& kind : program::kinds())
        kinds << QVariant::fromValue(
            ShapedName{RecipeWords::kindName(kind.kind), shapeOf(program::defaultRecipe(kind.kind))});
    return kinds;
}

QString Editor::lawTitle() const
{
    if (!hasLaw())
        return {};
    return m_recipe.kind() == profile::ProgramKind::PositionMove ? tr("Displacement law") : tr("Speed law");
}

QVariant Editor::overlayCurves() const
{
    if (m_comparedCurves)
        return QVariant::fromValue(m_comparedCurves);
    const auto& active = m_controller.program();
    return active && active->recipe.kind() == m_recipe.kind() ? m_controller.active().curves : QVariant();
}

void Editor::watchLaws(bool isWatched)
{
    m_areLawsWatched = isWatched;
    if (!isWatched && m_comparedLaw)
        compareLaw({}); // ends where it was begun
    m_laws.setRows(isWatched
                       ? EditorViews(m_recipe, m_solution, m_controller.program().get()).laws(m_comparedLaw)
                       : QList<LawRow>{});
}

QString Editor::overlayName() const
{
    return m_comparedLaw ? RecipeWords::lawName(*m_comparedLaw) : QString();
}

const profile::Suggestion* Editor::suggestion() const
{
    return m_solution.refusals.empty() || m_solution.refusals.front().nearest.empty()
               ? nullptr
               : &m_solution.refusals.front().nearest.front();
}

} // namespace campanel::panel
