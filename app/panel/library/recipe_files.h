// SPDX-License-Identifier: Apache-2.0
// Recipe files on a stick, in the panel's own folder or offered by the plant's network, each with the
// consequence of importing it. An offer stays in memory until a person imports it.
#pragma once

#include "app/panel/kit/file_exchange.h"
#include "app/plant/local_messages.h"
#include "app/store/recipes/recipe_file.h"

#include <QTimer>

namespace campanel::panel {

class RecipeFiles : public campanel::panel::FileExchange {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Recipe files belong to the Recipes")
    Q_PROPERTY(campanel::panel::RowModelBase* files READ files CONSTANT FINAL)
    // "Offered: Biscuit 250, version 8": the recipes from the plant's network that can be imported and are
    // not in the library yet; empty: none.
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged FINAL)
    // The number of files whose import would change the library.
    Q_PROPERTY(int news READ news NOTIFY newsChanged FINAL)

public:
    // Searches for files; called in another thread.
    using Scanner = std::function<QList<store::RecipeOffer>(const QString& ownFolder)>;
    // The consequence of importing a recipe, whole sentences; or why it is refused.
    struct Effect {
        QString text;
        QString summary{}; // "new", "becomes version 3", ...; empty when it is refused
        bool isRefused = false;
        bool isKnown = false; // importing it changes nothing
    };
    using Consequence = std::function<Effect(const store::RecipeOffer& offer)>;

    RecipeFiles(const QString& ownFolder, Consequence consequence, QObject* parent);

    // Replaces the search of this computer's disks, for tests and captures.
    void setScanner(Scanner scanner) { m_scanner = std::move(scanner); }
    // Sets the function that returns true for a letter that the fonts of the screen have; all by default.
    void setGlyphs(std::function<bool(char32_t letter)> hasGlyph) { m_hasGlyph = std::move(hasGlyph); }
    // Checks signatures with the keys in this folder.
    void setKeyFolder(const QString& folder);
    // Adds, replaces or withdraws an offer of the plant's network.
    void takeOffer(const plant::OfferMessage& offer);
    // Shows the consequences again after the library has changed.
    void updateRows();

    [[nodiscard]] OfferModel* files() { return &m_files; }
    [[nodiscard]] QString notice() const { return m_notice; }

    [[nodiscard]] int news() const { return static_cast<int>(m_news.size()); }

    // Imports the recipe of a usable file, or of each one that changes the library.
    Q_INVOKABLE void take(int file);
    Q_INVOKABLE void takeAll();

signals:
    void taken(const QList<campanel::store::RecipeOffer>& offers);
    void noticeChanged();
    void newsChanged();

private:
    [[nodiscard]] std::function<Apply()> searcher() override;
    [[nodiscard]] OfferRow row(const store::RecipeOffer& offer, const Effect& effect) const;
    [[nodiscard]] static OfferRow refusedRow(const store::RecipeOffer& offer);
    // Returns how many letters of the name would be boxes on the screen, as a sentence; empty: none.
    [[nodiscard]] QString hiddenLetters(const std::string& name) const;
    [[nodiscard]] static QString offeredText(const program::Recipe& recipe);
    [[nodiscard]] static QString nameAndVersion(const program::Recipe& recipe);

    Consequence m_consequence;
    Scanner m_scanner;
    std::function<bool(char32_t letter)> m_hasGlyph = [](char32_t) { return true; };
    QString m_keyFolder;
    QMap<QString, store::ReceivedFile> m_received;
    QTimer m_offerTimer; // runs out when the offers that come together have come
    QString m_notice;
    OfferModel m_files{this};
    QList<store::RecipeOffer> m_found;
    QList<store::RecipeOffer> m_news;
};

} // namespace campanel::panel
