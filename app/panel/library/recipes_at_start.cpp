// SPDX-License-Identifier: Apache-2.0
// The open recipe at the start. Nobody is there who could have changed the machine data: they stay those of
// the database.
#include "app/panel/library/recipes.h"

#include "app/panel/editor/editor.h"
#include "app/panel/recipe/recipe_edit.h"
#include "app/panel/words/recipe_words.h"

#include <QFileInfo>

#include <algorithm>
#include <map>

using namespace Qt::StringLiterals;

namespace campanel::panel {

using program::Recipe;
using store::RecipeVersion;
using Source = store::LastRecipe::Source;

// Says which recipes are missing from the list; the open one may just have been kept again.
void Recipes::nameUnreadable()
{
    work([](store::RecipeLibrary& library) { return library.unreadable(); },
         [this](const QStringList& names) {
             if (!names.isEmpty())
                 say(tr("No version of these recipes can be read: %1. Restore a backup that has them.")
                         .arg(names.join(u", "_s)));
         });
}

void Recipes::checkOpenRecipe(const Recipe& open, bool isKept, bool isLibraryEmpty)
{
    reportLostMachineData();
    const Source source = m_editor.sources().stored;
    if (source == Source::Saved && !isKept)
        keep(open, Origin::Editor, {});
    if (source == Source::Saved)
        return;
    if (isLibraryEmpty) { // a new panel: nothing is stored before somebody saves
        if (source == Source::Copy)
            keep(open, Origin::Library, [this, open](const RecipeVersion& kept) {
                if (sameRecipe(m_editor.storedRecipe(), open))
                    m_editor.takeStored(kept.recipe);
            });
        return;
    }
    const RecipeVersion* sameName = named(QString::fromStdString(open.name));
    const bool isNews = source == Source::Copy && !isKept &&
                        (!sameName || sameName->version < open.version); // the database is an older copy
    if (isNews || m_all.isEmpty()) {
        openAtStart(open);
        if (isNews)
            keep(m_editor.storedRecipe(), Origin::Library, {});
        return;
    }
    const bool isNameKnown = m_editor.sources().working != Source::Default;
    const RecipeVersion* last = isNameKnown ? named(m_editor.recipeName()) : nullptr;
    last = last ? last : &m_all.first();
    m_chosenId = last->recipeId;
    openAtStart(last->recipe);
}

QString Recipes::openedInsteadText(const QString& name, int version)
{
    if (version == 0)
        return tr("The file of the open recipe was lost or damaged. Opened instead: a new recipe, with this "
                  "panel's machine data.");
    return tr("The file of the open recipe was lost or damaged. Opened instead: %1, version %2, with this "
              "panel's "
              "machine data.")
        .arg(name, QString::number(version));
}

void Recipes::openAtStart(const Recipe& recipe)
{
    std::optional<Recipe> edited;
    if (m_editor.sources().working == Source::Saved)
        edited = m_editor.recipe();
    else if (m_editor.sources().working == Source::Copy)
        edited = onThisMachine(m_editor.recipe());
    m_editor.open(onThisMachine(recipe), edited);
    const QString name = QString::fromStdString(recipe.name);
    m_editor.showNotice(openedInsteadText(name, recipe.version));
    note(u"recipe.file_lost"_s, name, {}, u"version %1"_s.arg(recipe.version));
}

void Recipes::reportLostMachineData()
{
    for (const store::MachineData& each : m_machineData) {
        if (each.takenFrom.isEmpty())
            continue;
        m_editor.showNotice(
            tr("The machine data for %1 were lost or damaged. Those saved with the recipe %2 are "
               "used; check them on the Motion page.")
                .arg(RecipeWords::kindName(each.recipe.kind()), each.takenFrom));
        note(u"recipe.machine_lost"_s, each.takenFrom, {}, {});
    }
}

void Recipes::takeFromBuilder(const QString& folder, const QString& keyFolder,
                              std::function<void(int count, const QMap<QString, QString>& refused)> done)
{
    const auto take = [this, done = std::move(done)](QList<store::RecipeOffer> offers) {
        const bool isNew = m_all.isEmpty();
        std::map<profile::ProgramKind, profile::Machine> machines;
        QMap<QString, QString> refused;
        int count = 0;
        std::ranges::sort(offers, {}, &store::RecipeOffer::path);
        for (const store::RecipeOffer& offer : std::as_const(offers)) {
            const QString file = QFileInfo(offer.path).fileName();
            if (!offer.recipe) {
                refused.insert(file, store::FileErrorText::describe(offer.recipe.error()));
                continue;
            }
            const RecipeFiles::Effect effect = consequence(offer);
            if (effect.isRefused)
                refused.insert(file, effect.text);
            if (effect.isRefused || effect.isKnown)
                continue;
            Recipe recipe = onThisMachine(*offer.recipe);
            if (isNew)
                recipe.machine = machines.try_emplace(recipe.kind(), offer.recipe->machine).first->second;
            const bool isFirst = isNew && count == 0;
            ++count;
            keep(
                recipe, Origin::Library,
                [this, isFirst](const RecipeVersion& kept) {
                    if (isFirst)
                        m_editor.open(kept.recipe);
                },
                offer.signature ? offer.signature->signer : QString());
        }
        done(count, refused);
    };
    m_records.store().run(
        this,
        [folder, keyFolder](store::Database&) {
            return store::offeredRecipes({store::Place{.path = folder, .name = folder}}, keyFolder);
        },
        take);
}

} // namespace campanel::panel
