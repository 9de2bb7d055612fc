// SPDX-License-Identifier: Apache-2.0
#include "app/panel/library/recipe_codes.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/library/recipes.h"
#include "app/store/database/names.h"
#include "app/store/recipes/recipe_json.h"

namespace campanel::panel {

namespace {

// Returns true when the code selects the recipe: a name does in each of its spellings.
bool hasCode(const program::Recipe& recipe, const QString& code)
{
    return recipe.scanCode.empty() ? store::isSameName(QString::fromStdString(recipe.name), code)
                                   : QString::fromStdString(recipe.scanCode) == code;
}

} // namespace

RecipeCodes::RecipeCodes(Recipes& recipes)
    : QObject(&recipes)
    , m_recipes(recipes)
{
    connect(&recipes, &Recipes::listChanged, this, &RecipeCodes::changed);
    connect(&recipes, &Recipes::listChanged, this, &RecipeCodes::wantedChanged);
}

QString RecipeCodes::scanText() const
{
    const auto* chosen = m_recipes.chosenRecipe();
    return chosen ? QString::fromStdString(program::codeOf(chosen->recipe)) : QString();
}

QString RecipeCodes::filmText() const
{
    const auto* chosen = m_recipes.chosenRecipe();
    if (!chosen)
        return {};
    return chosen->recipe.filmCode.empty() ? tr("Any reel") : QString::fromStdString(chosen->recipe.filmCode);
}

void RecipeCodes::setWanted(const QString& code)
{
    m_wanted = code;
    emit wantedChanged();
}

program::Recipe RecipeCodes::withWanted(program::Recipe recipe) const
{
    (m_code == Code::Recipe ? recipe.scanCode : recipe.filmCode) = m_wanted.trimmed().toStdString();
    return recipe;
}

QString RecipeCodes::formProblem() const
{
    const QString code = m_wanted.trimmed();
    if (code.toStdString().size() > program::maxCodeBytes)
        return tr("The code is too long. Enter at most %1 letters and digits.").arg(program::maxCodeBytes);
    if (!store::isScannable(code))
        return tr("The code has characters that cannot be printed. Enter letters and digits.");
    return {};
}

QString RecipeCodes::problem() const
{
    const auto* chosen = m_recipes.chosenRecipe();
    if (!chosen || !formProblem().isEmpty())
        return formProblem();
    const program::Recipe wanted = withWanted(chosen->recipe);
    const std::string& code = m_code == Code::Recipe ? program::codeOf(wanted) : wanted.filmCode;
    if (code.empty())
        return {};
    for (const auto& each : m_recipes.newest()) {
        const bool isSame = each.recipeId == chosen->recipeId;
        const QString name = QString::fromStdString(each.recipe.name);
        if (hasCode(each.recipe, QString::fromStdString(code)) && (!isSame || m_code == Code::Film))
            return tr("This is the code of the recipe %1. Enter another code.").arg(name);
        if (each.recipe.filmCode == code && m_code == Code::Recipe)
            return tr("This is the code of the film reel of %1. Enter another code.").arg(name);
    }
    return {};
}

void RecipeCodes::enter(Code code)
{
    m_code = code;
    const auto* chosen = m_recipes.chosenRecipe();
    if (!chosen)
        return setWanted({});
    setWanted(
        QString::fromStdString(code == Code::Recipe ? chosen->recipe.scanCode : chosen->recipe.filmCode));
}

void RecipeCodes::store()
{
    const auto* chosen = m_recipes.chosenRecipe();
    if (m_recipes.accessCheck().require(Level::Technician) && chosen && problem().isEmpty())
        m_recipes.setCodes(withWanted(chosen->recipe));
}

QList<store::RecipeVersion> Recipes::coded(const QString& code) const
{
    QList<store::RecipeVersion> found;
    for (const store::RecipeVersion& each : m_all) {
        if (hasCode(each.recipe, code))
            found << each;
    }
    return found;
}

AccessCheck& Recipes::accessCheck() const
{
    return m_controller.accessCheck();
}

void Recipes::chooseId(qint64 recipeId)
{
    m_chosenId = recipeId;
    setSearch({});
}

void Recipes::setCodes(const program::Recipe& withCodes)
{
    if (!m_controller.accessCheck().require(Level::Technician))
        return;
    const auto put = [](program::Recipe& recipe, const program::Recipe& kept) {
        recipe.scanCode = kept.scanCode;
        recipe.filmCode = kept.filmCode;
    };
    keepBeside(withCodes, put, [this](const store::RecipeVersion& kept) { emit codesSet(kept); });
}

void Recipes::setWindows(const program::Recipe& withWindows)
{
    if (!m_controller.accessCheck().require(Level::Technician))
        return;
    const auto put = [](program::Recipe& recipe, const program::Recipe& kept) {
        recipe.windows = kept.windows;
    };
    keepBeside(withWindows, put, {});
}

void Recipes::saveTrims(const QString& name, const program::Trims& trims)
{
    if (!m_controller.accessCheck().require(Level::Operator))
        return;
    const store::RecipeVersion* newest = named(name);
    if (newest == nullptr)
        return say(tr("The recipe %1 is not among the recipes of this panel. Save it first.").arg(name),
                   Lasts::UntilAnswered);
    program::Recipe recipe = newest->recipe;
    recipe.trims = trims;
    const auto put = [](program::Recipe& other, const program::Recipe& kept) { other.trims = kept.trims; };
    keepBeside(recipe, put, {});
}

void Recipes::keepBeside(const program::Recipe& recipe,
                         std::function<void(program::Recipe& recipe, const program::Recipe& kept)> put,
                         std::function<void(const store::RecipeVersion& kept)> done)
{
    const auto follow = [this, put, done, version = recipe.version](const store::RecipeVersion& kept) {
        const auto same = [&kept, &put, version](program::Recipe other) {
            put(other, kept.recipe);
            if (other.version == version)
                other.version = kept.version;
            return other;
        };
        const program::Recipe& stored = m_editor.storedRecipe();
        if (stored.name == kept.recipe.name) {
            const bool isEdited = m_editor.edited();
            const program::Recipe edited = m_editor.recipe();
            m_editor.open(same(stored), isEdited && edited.name == stored.name ? std::optional(same(edited))
                                        : isEdited                             ? std::optional(edited)
                                                                               : std::nullopt);
        }
        if (done)
            done(kept);
        say(tr("Saved: %1, version %2.")
                .arg(QString::fromStdString(kept.recipe.name), QString::number(kept.version)));
    };
    keep(recipe, Origin::Library, follow);
}

} // namespace campanel::panel
