// SPDX-License-Identifier: Apache-2.0
#include "app/panel/library/recipe_files.h"

#include "app/panel/kit/format.h"
#include "app/panel/recipe/recipe_comparison.h"

#include <QFileInfo>

namespace campanel::panel {

namespace {

bool isOfSignature(const store::FileError& error)
{
    using Kind = store::FileError::Kind;
    return error.kind == Kind::UnknownSigner || error.kind == Kind::WithdrawnSigner ||
           error.kind == Kind::WrongSignature;
}

} // namespace

RecipeFiles::RecipeFiles(const QString& ownFolder, Consequence consequence, QObject* parent)
    : FileExchange(ownFolder, parent)
    , m_consequence(std::move(consequence))
{
    setKeyFolder({});
}

void RecipeFiles::setKeyFolder(const QString& folder)
{
    m_scanner = [folder](const QString& ownFolder) {
        return store::offeredRecipes(store::exchangePlaces(ownFolder), folder);
    };
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
    if (offer.recipe) {
        const Effect effect = m_consequence(offer);
        const QString summary = RecipeComparison::summary(*offer.recipe);
        row.usable = !effect.isRefused;
        row.detail = effect.text;
        row.note = offer.signature
                       ? tr("%1 · signed by %2 · %3 · %4", "what it is, person, date, place")
                             .arg(summary, offer.signature->signer, date, offer.placeName)
                       : tr("%1 · %2 · %3", "what it is, date, place").arg(summary, date, offer.placeName);
    } else {
        row.usable = false;
        row.note = tr("cannot be used · %1 · %2", "date, place").arg(date, offer.placeName);
        const store::FileError& error = offer.recipe.error();
        row.detail = store::FileErrorText::describe(error);
        if (!isOfSignature(error))
            row.detail =
                tr("%1 Correct the file; the panel reads it again automatically.", "%1: whole sentence")
                    .arg(row.detail);
    }
    return row;
}

void RecipeFiles::take(int file)
{
    if (file >= 0 && file < m_found.size() && m_files.rows()[file].usable)
        emit taken(m_found[file]);
}

} // namespace campanel::panel
