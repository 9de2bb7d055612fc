// SPDX-License-Identifier: Apache-2.0
// Selects the file, its last good copy or the default recipe.
#include "app/store/recipes/last_recipe.h"

#include "app/store/files/files.h"
#include "app/store/files/store_logging.h"

#include <QDir>
#include <QStandardPaths>

namespace campanel::store {

LastRecipe::LastRecipe(QString path)
    : m_path(std::move(path))
{
}

QString LastRecipe::pathFor(const QString& fileName)
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath(fileName);
}

LastRecipe::Loaded LastRecipe::load() const
{
    const auto saved = readRecipe(m_path);
    if (saved)
        return {*saved, {}};
    const auto copy = readRecipe(backupPath(m_path));
    const bool neverSaved = saved.error().kind == FileError::Kind::NotFound;
    if (!copy && neverSaved && copy.error().kind == FileError::Kind::NotFound)
        return {program::Recipe{}, {}, Source::Default};
    const QString complaint = FileErrorText::describe(saved.error());
    const QString notice = copy ? tr("%1 The last good copy is used.").arg(complaint)
                                : tr("%1 There is no good copy; the default recipe is used.").arg(complaint);
    qCWarning(storeLog).noquote() << oneLine(notice, maxLineLength);
    return {copy.value_or(program::Recipe{}), notice, copy ? Source::Copy : Source::Default};
}

tl::expected<void, FileError> LastRecipe::save(const program::Recipe& recipe) const
{
    return writeRecipe(recipe, m_path);
}

} // namespace campanel::store
