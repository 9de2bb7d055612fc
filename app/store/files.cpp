// SPDX-License-Identifier: Apache-2.0
// Files through QSaveFile, which writes beside, syncs and renames.
#include "app/store/files.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <fcntl.h>
#include <unistd.h>

namespace campanel::store {

tl::expected<QByteArray, FileError> readBytes(const QString& path)
{
    constexpr qint64 largestFileBytes = 1'000'000;
    QFile file(path);
    if (!file.exists())
        return tl::unexpected(FileError{FileError::Kind::NotFound, path, {}, {}, {}, 0});
    if (QFileInfo(path).isDir() || !file.open(QIODevice::ReadOnly))
        return tl::unexpected(FileError{FileError::Kind::NotReadable, path, {}, file.errorString(), {}, 0});
    return file.read(largestFileBytes);
}

tl::expected<void, FileError> replaceBytes(const QString& path, const QByteArray& bytes)
{
    QSaveFile file(path);
    // Flushed here: commit() does not notice that the last bytes found no room.
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.flush() ||
        !file.commit())
        return tl::unexpected(FileError{FileError::Kind::NotWritable, path, {}, file.errorString(), {}, 0});
    return {};
}

tl::expected<void, FileError> settle(const QString& path)
{
    const int file = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC);
    const bool isSettled = file >= 0 && ::syncfs(file) == 0;
    const QString reason = isSettled ? QString() : qt_error_string();
    if (file >= 0)
        ::close(file);
    if (!isSettled)
        return tl::unexpected(FileError{FileError::Kind::NotWritable, path, {}, reason, {}, 0});
    return {};
}

} // namespace campanel::store
