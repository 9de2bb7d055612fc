// SPDX-License-Identifier: Apache-2.0
// Files through QSaveFile, which writes beside, syncs and renames.
#include "app/store/recipe_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

namespace campanel::store {
namespace {

// A recipe has 1.5 KB; a file that is thousands of times longer is something else.
constexpr qint64 largestFileBytes = 1'000'000;

tl::expected<QByteArray, FileError> readBytes(const QString& path)
{
    QFile file(path);
    if (!file.exists())
        return tl::unexpected(FileError{FileError::Kind::NotFound, path, {}, {}, {}, 0});
    if (QFileInfo(path).isDir() || !file.open(QIODevice::ReadOnly))
        return tl::unexpected(FileError{FileError::Kind::NotReadable, path, {}, file.errorString(), {}, 0});
    return file.read(largestFileBytes);
}

tl::expected<void, FileError> replace(const QString& path, const QByteArray& bytes)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
        return tl::unexpected(FileError{FileError::Kind::NotWritable, path, {}, file.errorString(), {}, 0});
    return {};
}

} // namespace

QString backupPath(const QString& path)
{
    return path + QStringLiteral(".bak");
}

tl::expected<program::Recipe, FileError> readRecipe(const QString& path)
{
    return readBytes(path).and_then([&path](const QByteArray& bytes) { return fromJson(bytes, path); });
}

tl::expected<void, FileError> writeRecipe(const program::Recipe& recipe, const QString& path)
{
    QDir().mkpath(QFileInfo(path).absolutePath());
    // A damaged file must not push out the last good copy.
    if (const auto before = readBytes(path); before && fromJson(*before, path)) {
        if (const auto kept = replace(backupPath(path), *before); !kept)
            return kept;
    }
    return replace(path, toJson(recipe));
}

} // namespace campanel::store
