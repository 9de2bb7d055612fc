// SPDX-License-Identifier: Apache-2.0
// The property getters of Editor, from the recipe and its solution.
#include "app/machine/editor.h"

#include "app/machine/editor_views.h"
#include "app/machine/machine.h"
#include "app/machine/recipe_words.h"
#include "app/machine/refusal_sentences.h"
#include "app/machine/table_text.h"

namespace campanel::machine {

using profile::Field;

QString Editor::lawName() const
{
    return RecipeWords::lawName(
        static_cast<profile::LawId>(program::choice(m_recipe.program, program::Choice::Law)));
}

QString Editor::verdict() const
{
    return EditorViews(m_recipe, m_solution, nullptr).verdict();
}

Editor::Severity Editor::severity() const
{
    if (!feasible() && !m_solution.isTablePending)
        return Severity::Bad;
    return m_solution.isCloseToLimit() ? Severity::Warning : Severity::Good;
}

QString Editor::suggestionText() const
{
    return suggestion() ? RefusalSentences::suggestion(*suggestion()) : QString();
}

QVariant Editor::curves() const
{
    return m_solution.curves ? QVariant::fromValue(m_solution.curves) : QVariant();
}

QList<double> Editor::ratioTimes() const
{
    QList<double> times;
    if (!m_recipe.isCutter())
        return times;
    for (const double k : m_recipe.cutter().k)
        times << m_cycleSeconds / k;
    return times;
}

QList<double> Editor::markTimes() const
{
    if (m_recipe.isCutter())
        return ratioTimes();
    return m_solution.solved
               ? QList<double>(m_solution.solved->marksS.begin(), m_solution.solved->marksS.end())
               : QList<double>();
}

const profile::Machine& Editor::limits() const
{
    return m_solution.solved ? m_solution.solved->machine : m_recipe.machine;
}

double Editor::limitVelocity() const
{
    return limits().maxMotorRpm /
           (m_recipe.isCutter() ? profile::motorRpmPerMmPerS(limits()) : profile::axisRpmPerMmPerS(limits()));
}

double Editor::limitAcceleration() const
{
    return m_recipe.isCutter() ? limits().maxKnifeAccelerationMmPerS2 : limits().maxAccelerationMmPerS2;
}

double Editor::limitFrequency() const
{
    return profile::pulseFrequencyLimitHz(limits());
}

QList<QPointF> Editor::violations() const
{
    QList<QPointF> spans;
    for (const profile::Refusal& refusal : m_solution.refusals) {
        for (const profile::TimeSpan& span : refusal.brokenDuring)
            spans << QPointF(span.fromS, span.toS);
    }
    return spans;
}

QString Editor::peakText() const
{
    return EditorViews(m_recipe, m_solution, nullptr).peaks();
}

QStringList Editor::tableSummary() const
{
    return m_solution.image ? TableText(*m_solution.image).summary() : QStringList();
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

QStringList Editor::kindNames() const
{
    QStringList names;
    for (const program::KindInfo& kind : program::kinds())
        names << RecipeWords::kindName(kind.kind);
    return names;
}

QString Editor::lawTitle() const
{
    return m_recipe.kind() == profile::ProgramKind::PositionMove ? tr("Displacement law") : tr("Speed law");
}

QVariant Editor::overlayCurves() const
{
    if (m_comparedCurves)
        return QVariant::fromValue(m_comparedCurves);
    const auto& active = m_machine.program();
    return active && active->recipe.kind() == m_recipe.kind() ? m_machine.targetCurves() : QVariant();
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

} // namespace campanel::machine
