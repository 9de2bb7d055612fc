// SPDX-License-Identifier: Apache-2.0
// Recipe files on a stick or in the panel's own folder, each with the consequence of importing it.
#pragma once

#include "app/panel/kit/file_exchange.h"
#include "app/store/recipes/recipe_file.h"

namespace campanel::panel {

class RecipeFiles : public campanel::panel::FileExchange {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Recipe files belong to the Recipes")
    Q_PROPERTY(campanel::panel::RowModelBase* files READ files CONSTANT FINAL)

public:
    // Searches for files; called in another thread.
    using Scanner = std::function<QList<store::RecipeOffer>(const QString& ownFolder)>;
    // The consequence of importing a recipe, whole sentences; or why it is refused.
    struct Effect {
        QString text;
        bool isRefused = false;
    };
    using Consequence = std::function<Effect(const store::RecipeOffer& offer)>;

    RecipeFiles(const QString& ownFolder, Consequence consequence, QObject* parent);

    // Replaces the search of this computer's disks, for tests and captures.
    void setScanner(Scanner scanner) { m_scanner = std::move(scanner); }
    // Checks signatures with the keys in this folder.
    void setKeyFolder(const QString& folder);

    [[nodiscard]] OfferModel* files() { return &m_files; }

    // Imports the recipe of a usable file.
    Q_INVOKABLE void take(int file);

signals:
    void taken(const campanel::store::RecipeOffer& offer);

private:
    [[nodiscard]] std::function<Apply()> searcher() override;
    [[nodiscard]] OfferRow row(const store::RecipeOffer& offer) const;

    Consequence m_consequence;
    Scanner m_scanner;
    OfferModel m_files{this};
    QList<store::RecipeOffer> m_found;
};

} // namespace campanel::panel
