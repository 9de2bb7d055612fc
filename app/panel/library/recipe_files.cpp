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
    if (offer.kind != plant::OfferMessage::Kind::Recipe)
        return;
    plant::applyOffer(m_received, offer, store::ReceivedFile{offer.file, QDateTime::currentDateTime()});
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
    QList<store::RecipeOffer> news;
    for (const store::RecipeOffer& offer : m_found) {
        if (!offer.recipe) {
            rows << refusedRow(offer);
            continue;
        }
        const Effect effect = m_consequence(offer);
        rows << row(offer, effect);
        if (effect.isRefused || effect.isKnown)
            continue;
        news << offer;
        if (offer.isFromPlant)
            offered << offeredText(*offer.recipe);
    }
    m_files.setRows(rows);
    const QString notice = offered.join(QStringLiteral(" · "));
    if (std::exchange(m_notice, notice) != notice)
        emit noticeChanged();
    // The older version of a recipe is imported first.
    std::ranges::stable_sort(news, {}, [](const store::RecipeOffer& offer) { return offer.recipe->version; });
    m_news = news;
    emit newsChanged();
}

QString RecipeFiles::offeredText(const program::Recipe& recipe)
{
    return tr("Offered: %1", "recipe and version").arg(nameAndVersion(recipe));
}

QString RecipeFiles::nameAndVersion(const program::Recipe& recipe)
{
    return tr("%1, version %2", "recipe, number")
        .arg(QString::fromStdString(recipe.name), QString::number(recipe.version));
}

OfferRow RecipeFiles::row(const store::RecipeOffer& offer, const Effect& effect) const
{
    const QString date = Format::minute(offer.changed);
    QStringList parts{RecipeComparison::summary(*offer.recipe)};
    if (offer.signature)
        parts << tr("signed by %1", "person").arg(offer.signature->signer);
    if (!offer.isFromPlant)
        parts << QFileInfo(offer.path).fileName();
    parts << date << offer.placeName;
    if (!effect.summary.isEmpty())
        parts.prepend(effect.summary);
    OfferRow row;
    row.title = offer.isFromPlant ? offeredText(*offer.recipe) : nameAndVersion(*offer.recipe);
    row.usable = !effect.isRefused;
    const QString hidden = hiddenLetters(offer.recipe->name);
    row.detail = hidden.isEmpty() ? effect.text : tr("%1 %2", "whole sentences").arg(effect.text, hidden);
    row.note = parts.join(QStringLiteral(" · "));
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
        emit taken({m_found[file]});
}

void RecipeFiles::takeAll()
{
    if (isAllowed(Level::Operator) && !m_news.isEmpty())
        emit taken(m_news);
}

} // namespace campanel::panel
