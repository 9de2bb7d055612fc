// SPDX-License-Identifier: Apache-2.0
#include "app/panel/library/recipe_files.h"

#include "app/panel/kit/format.h"
#include "app/panel/recipe/recipe_comparison.h"

#include <QFileInfo>

namespace campanel::panel {

RecipeFiles::RecipeFiles(const QString& ownFolder, Consequence consequence, QObject* parent)
    : FileExchange(ownFolder, parent)
    , m_consequence(std::move(consequence))
    , m_scanner([](const QString& folder) { return store::offeredRecipes(store::exchangePlaces(folder)); })
{
}

std::function<FileExchange::Apply()> RecipeFiles::searcher()
{
    return [this, scan = m_scanner, folder = ownFolder()]() -> Apply {
        return [this, found = scan(folder)] {
            m_found = found;
            QList<OfferRow> rows;
            for (const store::RecipeOffer& offer : m_found)
                rows << row(offer);
            m_files.setRows(rows);
        };
    };
}

OfferRow RecipeFiles::row(const store::RecipeOffer& offer) const
{
    const QString date = Format::minute(offer.changed);
    OfferRow row;
    row.title = QFileInfo(offer.path).fileName();
    row.usable = offer.recipe.has_value();
    if (row.usable) {
        row.note = tr("%1 · %2 · %3", "what it is, date, place")
                       .arg(RecipeComparison::summary(*offer.recipe), date, offer.placeName);
        row.detail = m_consequence(*offer.recipe);
    } else {
        row.note = tr("cannot be used · %1 · %2", "date, place").arg(date, offer.placeName);
        row.detail = tr("%1 Correct the file; the panel reads it again automatically.", "%1: whole sentence")
                         .arg(store::FileErrorText::describe(offer.recipe.error()));
    }
    return row;
}

void RecipeFiles::take(int file)
{
    if (file >= 0 && file < m_found.size() && m_found[file].recipe)
        emit taken(*m_found[file].recipe, QFileInfo(m_found[file].path).fileName());
}

} // namespace campanel::panel
