// SPDX-License-Identifier: Apache-2.0
// The file of an open recipe that a person saved, as a panel in use has it. A new panel has none.
#pragma once

#include "app/store/recipes/recipe_file.h"

#include <QDir>
#include <QFileInfo>

namespace campanel::test {

// Saves the default recipe, Biscuit 250, as the open one unless the folder has one. Returns the folder.
inline QString withStoredRecipe(const QString& folder)
{
    const QString path = QDir(folder).filePath(QStringLiteral("recipe.json"));
    if (!QFileInfo::exists(path) && !store::writeRecipe(program::Recipe{}, path))
        qFatal("the recipe cannot be written");
    return folder;
}

} // namespace campanel::test
