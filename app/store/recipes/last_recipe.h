// SPDX-License-Identifier: Apache-2.0
// A recipe that survives a restart, stored in one file of the application's data folder. Loading always
// returns a recipe, and a sentence when it is not the one saved last.
#pragma once

#include "app/store/recipes/recipe_file.h"

#include <QCoreApplication>

namespace campanel::store {

class LastRecipe {
    Q_DECLARE_TR_FUNCTIONS(LastRecipe)

public:
    enum class Source { Saved, Copy, Default };
    struct Loaded {
        program::Recipe recipe;
        QString notice; // empty without an error
        Source source = Source::Saved;
    };

    explicit LastRecipe(QString path);

    // Returns `fileName` in QStandardPaths::AppDataLocation.
    [[nodiscard]] static QString pathFor(const QString& fileName);

    // Returns the saved recipe; else the last good copy; else the default one.
    [[nodiscard]] Loaded load() const;
    [[nodiscard]] tl::expected<void, FileError> save(const program::Recipe& recipe) const;

    [[nodiscard]] const QString& path() const { return m_path; }

private:
    QString m_path;
};

} // namespace campanel::store
