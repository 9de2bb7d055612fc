// SPDX-License-Identifier: Apache-2.0
#include "app/panel/library/recipe_files.h"

#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/recipe/recipe_comparison.h"
#include "app/store/files/files.h"

#include <QFileInfo>

#include <algorithm>
#include <chrono>

namespace campanel::panel {

namespace {

// An offer that is replaced is withdrawn for a moment.
constexpr std::chrono::milliseconds offerPause{300};

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
    m_offerTimer.setSingleShot(true);
    m_offerTimer.setInterval(offerPause);
    connect(&m_offerTimer, &QTimer::timeout, this, &RecipeFiles::search);
    LanguageNotifier::follow(this, &RecipeFiles::updateRows);
}

void RecipeFiles::setKeyFolder(const QString& folder)
{
    m_keyFolder = folder;
    m_scanner = [folder](const QString& ownFolder) {
        return store::offeredRecipes(store::exchangePlaces(ownFolder), folder);
    };
}

void RecipeFiles::takeOffer(const plant::OfferMessage& offer)
{
    if (offer.name.isEmpty())
        m_received.clear();
    else if (offer.file.isEmpty())
        m_received.remove(offer.name);
    else if (m_received.contains(offer.name) || m_received.size() < plant::maxOffers)
        m_received.insert(offer.name, {offer.file, QDateTime::currentDateTime()});
    if (!m_offerTimer.isActive()) // many offers must not delay it for ever
        m_offerTimer.start();
}

std::function<FileExchange::Apply()> RecipeFiles::searcher()
{
    return
        [this, scan = m_scanner, folder = ownFolder(), received = m_received, keys = m_keyFolder]() -> Apply {
            return [this, found = store::receivedRecipes(received, keys) + scan(folder)] {
                m_found = found;
                updateRows();
            };
        };
}

void RecipeFiles::updateRows()
{
    QList<OfferRow> rows;
    QStringList offered;
    for (const store::RecipeOffer& offer : m_found) {
        if (!offer.recipe) {
            rows << refusedRow(offer);
            continue;
        }
        const Effect effect = m_consequence(offer);
        rows << row(offer, effect);
        if (offer.isFromPlant && !effect.isRefused && !effect.isKnown)
            offered << offeredText(offer);
    }
    m_files.setRows(rows);
    const QString notice = offered.join(QStringLiteral(" · "));
    if (std::exchange(m_notice, notice) != notice)
        emit noticeChanged();
}

QString RecipeFiles::offeredText(const store::RecipeOffer& offer)
{
    return tr("Offered: %1, version %2", "recipe, number")
        .arg(QString::fromStdString(offer.recipe->name), QString::number(offer.recipe->version));
}

OfferRow RecipeFiles::row(const store::RecipeOffer& offer, const Effect& effect) const
{
    const QString date = Format::minute(offer.changed);
    const QString summary = RecipeComparison::summary(*offer.recipe);
    OfferRow row;
    row.title = offer.isFromPlant ? offeredText(offer) : QFileInfo(offer.path).fileName();
    row.usable = !effect.isRefused;
    const QString hidden = hiddenLetters(offer.recipe->name);
    row.detail = hidden.isEmpty() ? effect.text : tr("%1 %2", "whole sentences").arg(effect.text, hidden);
    row.note = offer.signature
                   ? tr("%1 · signed by %2 · %3 · %4", "what it is, person, date, place")
                         .arg(summary, offer.signature->signer, date, offer.placeName)
                   : tr("%1 · %2 · %3", "what it is, date, place").arg(summary, date, offer.placeName);
    return row;
}

QString RecipeFiles::hiddenLetters(const std::string& name) const
{
    const auto letters = QString::fromStdString(name).toUcs4();
    const auto shown = std::ranges::count_if(letters, m_hasGlyph);
    return shown == letters.size() ? QString()
                                   : tr("This panel cannot show all letters of the name; missing: %1. Rename "
                                        "the recipe after importing.")
                                         .arg(letters.size() - shown);
}

OfferRow RecipeFiles::refusedRow(const store::RecipeOffer& offer)
{
    const store::FileError& error = offer.recipe.error();
    if (error.kind == store::FileError::Kind::NotShown)
        return noticeRow(offer.placeName, error.found);
    OfferRow row;
    row.title = offer.isFromPlant ? store::oneLine(offer.path) : QFileInfo(offer.path).fileName();
    row.usable = false;
    row.note =
        tr("cannot be used · %1 · %2", "date, place").arg(Format::minute(offer.changed), offer.placeName);
    row.detail = store::FileErrorText::describe(error);
    if (!isOfSignature(error) && !offer.isFromPlant)
        row.detail = tr("%1 Correct the file; the panel reads it again automatically.", "%1: whole sentence")
                         .arg(row.detail);
    return row;
}

void RecipeFiles::take(int file)
{
    if (isAllowed(Level::Operator) && file >= 0 && file < m_found.size() && m_files.rows()[file].usable)
        emit taken(m_found[file]);
}

} // namespace campanel::panel
