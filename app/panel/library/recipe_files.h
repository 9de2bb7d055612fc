// SPDX-License-Identifier: Apache-2.0
// Recipe files on a stick or in the panel's own folder, each with the consequence of importing it. A stick
// may be slow or broken: everything that accesses a disk runs in a thread of its own.
#pragma once

#include "app/panel/kit/offer_model.h"
#include "app/store/recipes/recipe_file.h"

#include <QObject>
#include <QThreadPool>
#include <QtQml/qqmlregistration.h>

#include <functional>

namespace campanel::panel {

class RecipeFiles : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Recipe files belong to the Recipes")
    Q_PROPERTY(campanel::panel::RowModelBase* files READ files CONSTANT FINAL)
    // The folder of this panel, which is always available.
    Q_PROPERTY(QString ownFolder READ ownFolder CONSTANT FINAL)
    Q_PROPERTY(bool busy READ busy NOTIFY changed FINAL)

public:
    // Searches for files; called in another thread.
    using Looker = std::function<QList<store::RecipeOffer>(const QString& ownFolder)>;
    // Returns the consequence of importing the recipe, a whole sentence.
    using Consequence = std::function<QString(const program::Recipe& recipe)>;

    RecipeFiles(const QString& ownFolder, Consequence consequence, QObject* parent);
    ~RecipeFiles() override;

    // Replaces the search of this computer's disks, for tests and captures.
    void setLooker(Looker looker) { m_looker = std::move(looker); }

    [[nodiscard]] OfferModel* files() { return &m_files; }
    [[nodiscard]] QString ownFolder() const { return m_ownFolder; }
    [[nodiscard]] bool busy() const { return m_jobs > 0; }

    Q_INVOKABLE void look();
    // Searches again without clearing the message, for a page that waits for a stick.
    Q_INVOKABLE void refresh();
    // Imports the recipe of a usable file.
    Q_INVOKABLE void take(int file);

signals:
    void changed();
    void taken(const campanel::program::Recipe& recipe, const QString& fileName);

private:
    void search(std::function<void()> done);
    [[nodiscard]] OfferRow row(const store::RecipeOffer& offer) const;

    QString m_ownFolder;
    Consequence m_consequence;
    Looker m_looker;
    OfferModel m_files{this};
    QList<store::RecipeOffer> m_found;
    int m_jobs = 0;
    bool m_isRefreshing = false;
    QThreadPool m_pool; // one thread; the destructor waits for it
};

} // namespace campanel::panel
