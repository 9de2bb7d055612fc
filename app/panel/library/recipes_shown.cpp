// SPDX-License-Identifier: Apache-2.0
// The list of the recipes, and the details of the chosen one.
#include "app/panel/library/recipes.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/kit/format.h"
#include "app/panel/recipe/motor_demand.h"
#include "app/panel/recipe/recipe_comparison.h"
#include "app/panel/words/alarm_words.h"
#include "app/panel/words/master_sentences.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/store/database/names.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace campanel::panel {

using program::Recipe;
using store::RecipeVersion;

// Follows the editor, which signals every step of a drag, also without a change of the list.
void Recipes::followEditor()
{
    if (m_editor.recipeName() != m_shownName || nextVersion() != m_shownNextVersion)
        show();
}

void Recipes::show()
{
    m_shownName = m_editor.recipeName();
    m_shownNextVersion = nextVersion();
    const auto& active = m_controller.program();
    QList<RecipeRow> rows;
    for (const RecipeVersion& each : m_all) {
        const QString name = nameOf(each.recipe);
        if (!name.contains(m_search, Qt::CaseInsensitive))
            continue;
        rows << RecipeRow{each.recipeId,
                          name,
                          each.version,
                          RecipeComparison::summary(each.recipe),
                          savedText(each),
                          name == m_editor.recipeName(),
                          active && active->recipe.name == each.recipe.name,
                          m_shapes.value(each.recipeId)};
    }
    sort(rows);
    m_list.setRows(rows);
    showFigures();
    emit listChanged();
    emit wantedNameChanged();
}

QVariantList Recipes::choicesOf(int kind) const
{
    QVariantList choices;
    for (const RecipeVersion& each : m_all) {
        const QString name = nameOf(each.recipe);
        if (each.recipe.kind() == static_cast<profile::ProgramKind>(kind))
            choices << QVariantMap{{QStringLiteral("key"), name},
                                   {QStringLiteral("text"), name},
                                   {QStringLiteral("note"), RecipeComparison::summary(each.recipe)}};
    }
    return choices;
}

// Sorts the rows, of which the one saved last is first. What the controller executes is the one used last,
// wherever it was downloaded.
void Recipes::sort(QList<RecipeRow>& rows) const
{
    const auto isNamedBefore = [](const QString& a, const QString& b) { return a.localeAwareCompare(b) < 0; };
    const auto lastUse = [this](const RecipeRow& row) {
        return row.isActive ? std::numeric_limits<qint64>::max()
                            : m_downloads.value(store::nameKey(row.name));
    };
    if (m_order == u"name")
        std::ranges::stable_sort(rows, isNamedBefore, &RecipeRow::name);
    else if (m_order == u"use")
        std::ranges::stable_sort(rows, std::greater(), lastUse);
}

void Recipes::showFigures()
{
    const RecipeVersion* chosen = chosenRecipe();
    if (!chosen) {
        m_figures.setRows({});
        return;
    }
    const Recipe recipe = RecipeComparison::solved(chosen->recipe);
    const program::KindInfo& kind = program::kindInfo(recipe.kind());
    QList<FigureRow> rows;
    for (const profile::Field field : kind.programFields) {
        if (program::isRead(recipe.program, field))
            rows << FigureRow{RecipeWords::fieldName(field),
                              RefusalSentences::valueWithUnit(field, program::value(recipe, field))};
    }
    if (kind.list)
        rows << FigureRow{RecipeWords::listName(recipe.kind()),
                          Format().number(static_cast<double>(kind.list->size(recipe.program)), 0)};
    if (program::lawParameters(recipe.program))
        rows << FigureRow{RecipeWords::choiceName(recipe.kind(), program::Choice::Law),
                          RecipeWords::lawName(static_cast<profile::LawId>(
                              program::choice(recipe.program, program::Choice::Law)))};
    for (std::size_t i = 0; i < program::trimCount; ++i) {
        if (recipe.trims[i] != 0)
            rows << FigureRow{RecipeComparison::trimTitle(i), RecipeComparison::trimText(recipe, i)};
    }
    for (const auto& [field, window] : recipe.windows)
        rows << FigureRow{RecipeComparison::windowTitle(field), RefusalSentences::window(field, window)};
    if (program::hasMaster(recipe))
        rows << FigureRow{MasterSentences::title(), MasterSentences::name(recipe.master)};
    addMotor(rows, chosen->recipe);
    m_figures.setRows(rows);
}

void Recipes::setSearch(const QString& search)
{
    m_search = store::keptName(search);
    show();
}

void Recipes::setOrder(const QString& order)
{
    if (std::exchange(m_order, order) != order)
        show();
}

int Recipes::chosen() const
{
    const auto found = std::ranges::find(m_list.rows(), m_chosenId, &RecipeRow::id);
    return found == m_list.rows().end() ? -1 : static_cast<int>(found - m_list.rows().begin());
}

QString Recipes::chosenName() const
{
    const RecipeVersion* chosen = chosenRecipe();
    return chosen ? nameOf(chosen->recipe) : QString();
}

QString Recipes::chosenNote() const
{
    const RecipeVersion* chosen = chosenRecipe();
    if (!chosen)
        return {};
    const QString note = tr("%1 · version %2, %3", "kind of program, number, when it was saved")
                             .arg(RecipeWords::kindName(chosen->recipe.kind()),
                                  QString::number(chosen->version), savedText(*chosen));
    return chosen->unreadableVersion == 0
               ? note
               : tr("%1 · Version %2 cannot be read. Check this version, then save it.", "note, number")
                     .arg(note, QString::number(chosen->unreadableVersion));
}

bool Recipes::chosenIsOpen() const
{
    return chosenRecipe() && chosenName() == m_editor.recipeName();
}

bool Recipes::chosenIsActive() const
{
    const auto& active = m_controller.program();
    const RecipeVersion* chosen = chosenRecipe();
    return active && chosen && active->recipe.name == chosen->recipe.name &&
           active->recipe.version == chosen->version;
}

void Recipes::choose(int row)
{
    if (row < 0 || row >= m_list.count())
        return;
    m_chosenId = m_list.rows()[row].id;
    show();
}

QString Recipes::savedText(const RecipeVersion& version) const
{
    const QString when = Format::minute(QDateTime::fromMSecsSinceEpoch(version.savedMs));
    QStringList parts{version.savedBy.isEmpty() ? when
                                                : tr("%1 by %2", "date, person").arg(when, version.savedBy)};
    if (version.isClockDoubtful)
        parts << AlarmWords::clockNote(true);
    return parts.join(QStringLiteral(" · "));
}

// Adds the torque of the recipe on this machine, and the recipe that needs the most.
void Recipes::addMotor(QList<FigureRow>& rows, const Recipe& recipe) const
{
    const auto demand = motorDemand(onThisMachine(recipe));
    if (!demand)
        return;
    const Format format;
    const auto torque = [&format](double nm) { return tr("%1 Nm").arg(format.number(nm, 3)); };
    rows << FigureRow{tr("Peak motor torque"), torque(demand->peakNm)}
         << FigureRow{tr("RMS motor torque"), torque(demand->rmsNm)};
    std::vector<Recipe> same;
    for (const RecipeVersion& each : m_all) {
        if (each.recipe.kind() == recipe.kind())
            same.push_back(onThisMachine(each.recipe));
    }
    const auto hardest = hardestForMotor(same);
    if (hardest && same.size() > 1)
        rows << FigureRow{tr("Highest RMS torque"), tr("%1, %2 Nm", "recipe, torque")
                                                        .arg(QString::fromStdString(hardest->recipeName),
                                                             format.number(hardest->rmsNm, 3))};
}

} // namespace campanel::panel
