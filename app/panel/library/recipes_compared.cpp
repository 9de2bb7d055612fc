// SPDX-License-Identifier: Apache-2.0
// The comparison of recipes and versions, and import and export.
#include "app/panel/library/recipes.h"

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/recipe/recipe_comparison.h"
#include "app/panel/records/database_service.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/program/program_image.h"
#include "app/store/recipes/recipe_json.h"

#include <QFileInfo>

#include <algorithm>

namespace campanel::panel {

using program::Recipe;
using store::RecipeVersion;

void Recipes::clearComparison()
{
    m_differences.setRows({});
    m_beforeTitle.clear();
    m_afterTitle.clear();
    emit comparisonChanged();
}

void Recipes::compare(const Recipe& before, const Recipe& after)
{
    const auto title = [](const Recipe& recipe, bool isNamed) {
        return isNamed
                   ? tr("%1 · v%2").arg(QString::fromStdString(recipe.name), QString::number(recipe.version))
                   : tr("Version %1").arg(recipe.version);
    };
    const bool isNamed = before.name != after.name;
    m_beforeTitle = title(before, isNamed);
    m_afterTitle = title(after, isNamed);
    m_differences.setRows(RecipeComparison::rows(before, after));
    emit comparisonChanged();
}

void Recipes::listVersions()
{
    clearComparison();
    m_candidates.setRows({});
    m_compared.clear();
    if (!chosenRecipe())
        return;
    m_records.store().run(
        this,
        [id = m_chosenId](store::Database& database) { return store::RecipeLibrary(database).versions(id); },
        [this](const tl::expected<Versions, store::StoreError>& versions) {
            if (!versions) {
                m_records.reportError(versions.error());
                return;
            }
            m_compared = *versions;
            QList<OfferRow> rows;
            for (const RecipeVersion& each : m_compared)
                rows << OfferRow{tr("Version %1").arg(each.version), savedText(each), {}};
            m_candidates.setRows(rows);
        });
}

void Recipes::listOthers()
{
    clearComparison();
    m_compared.clear();
    QList<OfferRow> rows;
    for (const RecipeVersion& each : m_all) {
        if (each.recipeId == m_chosenId)
            continue;
        m_compared << each;
        rows << OfferRow{
            QString::fromStdString(each.recipe.name), RecipeComparison::summary(each.recipe), {}};
    }
    m_candidates.setRows(rows);
}

void Recipes::compareVersion(int row, bool withNewest)
{
    if (row < 0 || row >= m_compared.size())
        return;
    const bool isFirst = row + 1 == m_compared.size();
    if (withNewest && row > 0)
        compare(m_compared[row].recipe, m_compared.first().recipe);
    else if (!withNewest && !isFirst)
        compare(m_compared[row + 1].recipe, m_compared[row].recipe);
    else
        clearComparison();
}

void Recipes::compareOther(int row)
{
    if (const RecipeVersion* chosen = chosenRecipe(); chosen && row >= 0 && row < m_compared.size())
        compare(chosen->recipe, m_compared[row].recipe);
}

void Recipes::openVersion(int row)
{
    if (!m_controller.accessCheck().require(Level::Operator) || row < 0 || row >= m_compared.size())
        return;
    // The windows that are approved now hold for an earlier version too: it is no way around them.
    Recipe recipe = onThisMachine(m_compared[row].recipe);
    const RecipeVersion* newest = chosenRecipe();
    if (newest && newest->recipe.kind() == recipe.kind())
        recipe.windows = newest->recipe.windows;
    m_editor.open(recipe);
    dismissMessage();
}

void Recipes::offerExport(bool all)
{
    QList<ReportFile> files;
    for (const RecipeVersion& each : m_all) {
        if (all || each.recipeId == m_chosenId)
            files << ReportFile{QString::fromStdString(each.recipe.name), QStringLiteral("json"),
                                [recipe = onThisMachine(each.recipe)] { return store::toJson(recipe); }};
    }
    m_exports.offer(files);
}

// Imports files. A signature replaces the technician: an operator may accept what somebody has signed.
void Recipes::import(const QList<store::RecipeOffer>& offers)
{
    const bool isSigned = std::ranges::all_of(
        offers, [](const store::RecipeOffer& offer) { return offer.signature.has_value(); });
    if (!m_controller.accessCheck().require(isSigned ? Level::Operator : Level::Technician))
        return;
    const auto imported = std::make_shared<int>(0);
    for (const store::RecipeOffer& offer : offers) {
        if (const QString refusal = refusalOf(offer); !refusal.isEmpty()) { // by a version since the search
            say(refusal, Lasts::UntilAnswered);
            continue;
        }
        const QString fileName = offer.isFromPlant ? offer.path : QFileInfo(offer.path).fileName();
        keep(
            onThisMachine(*offer.recipe), Origin::Library,
            [this, imported, fileName](const RecipeVersion& kept) {
                m_chosenId = kept.recipeId;
                if (++*imported > 1)
                    return say(tr("%n recipes were imported.", "", *imported));
                say(tr("%1 was imported as %2, version %3.", "file, recipe")
                        .arg(fileName, QString::fromStdString(kept.recipe.name),
                             QString::number(kept.version)));
            },
            offer.signature ? offer.signature->signer : QString());
    }
}

RecipeFiles::Effect Recipes::consequence(const store::RecipeOffer& offer) const
{
    if (const QString refusal = refusalOf(offer); !refusal.isEmpty())
        return {.text = refusal, .isRefused = true};
    const Recipe& recipe = *offer.recipe;
    const QString name = QString::fromStdString(recipe.name);
    const RecipeVersion* known = named(name);
    if (!known)
        return {
            .text =
                tr("The file becomes the new recipe %1. The data of this machine stay unchanged.").arg(name),
            .summary = tr("new", "recipe")};
    const QList<DifferenceRow> rows = RecipeComparison::rows(known->recipe, recipe);
    if (rows.isEmpty())
        return {.text = tr("The file is identical to %1, version %2; nothing changes.")
                            .arg(name, QString::number(known->version)),
                .summary = tr("is here already", "recipe"),
                .isKnown = true};
    const QString version = QString::number(std::max(known->version + 1, recipe.version));
    const QString text =
        tr("The file becomes version %2 of %1; earlier versions are kept.").arg(name, version);
    return {.text = tr("%1 Changes: %2.", "whole sentence, list").arg(text, changes(rows)),
            .summary = tr("becomes version %1").arg(version)};
}

// Returns the first differences, "Bag length 250.0 mm to 260.0 mm".
QString Recipes::changes(const QList<DifferenceRow>& rows)
{
    constexpr qsizetype shown = 4;
    QStringList texts;
    for (const DifferenceRow& row : rows.first(std::min(rows.size(), shown)))
        texts
            << tr("%1 %2 to %3", "name, old value, new value").arg(row.name, row.activeText, row.editedText);
    const QString list = texts.join(tr("; ", "between changes"));
    return rows.size() > shown ? tr("%1 and %n more", "list", static_cast<int>(rows.size() - shown)).arg(list)
                               : list;
}

QString Recipes::refusalOf(const store::RecipeOffer& offer) const
{
    if (!offer.signature)
        return {};
    const Recipe& recipe = *offer.recipe;
    const QString name = QString::fromStdString(recipe.name);
    if (const RecipeVersion* known = named(name)) {
        if (known->recipe.kind() != recipe.kind())
            return tr("%1 is a %2 on this panel and a %3 in the file. Rename one of them.")
                .arg(name, RecipeWords::kindName(known->recipe.kind()), RecipeWords::kindName(recipe.kind()));
        if (recipe.version < known->version)
            return tr("The file has version %2 of %1; this panel has version %3. An older version is not "
                      "imported; open it from the versions of the recipe.")
                .arg(name, QString::number(recipe.version), QString::number(known->version));
    }
    const auto image = program::buildProgram(onThisMachine(recipe));
    return image ? QString()
                 : tr("This machine cannot run the recipe. %1", "whole sentences")
                       .arg(RefusalSentences::program(image.error()));
}

} // namespace campanel::panel
