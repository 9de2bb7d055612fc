// SPDX-License-Identifier: Apache-2.0
// Writes files by QSaveFile: a temporary file, then a rename.
#include "app/store/files/files.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace campanel::store {
namespace {

tl::unexpected<FileError> refused(FileError::Kind kind, const QString& path, const QString& reason)
{
    return tl::unexpected(FileError{kind, path, {}, reason, {}, 0});
}

// Flushes the name of a new file to the medium. Not every file system supports it: then only the name may be
// lost.
void settleFolder(const QString& path)
{
    const int folder =
        ::open(QFile::encodeName(QFileInfo(path).absolutePath()).constData(), O_RDONLY | O_CLOEXEC);
    if (folder < 0)
        return;
    ::fsync(folder);
    ::close(folder);
}

} // namespace

tl::expected<QByteArray, FileError> readBytes(const QString& path)
{
    using Kind = FileError::Kind;
    // O_NONBLOCK: opening a pipe would wait for its writer.
    const int handle =
        ::open(QFile::encodeName(path).constData(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (handle < 0) {
        const int code = errno;
        const bool isMissing = code == ENOENT || code == ENOTDIR;
        return refused(isMissing ? Kind::NotFound : Kind::NotReadable, path, qt_error_string(code));
    }
    QFile file;
    if (!file.open(handle, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle)) {
        ::close(handle);
        return refused(Kind::NotReadable, path, file.errorString());
    }
    struct stat status = {};
    if (::fstat(handle, &status) != 0)
        return refused(Kind::NotReadable, path, qt_error_string());
    if (!S_ISREG(status.st_mode))
        return refused(Kind::NotReadable, path, FileErrorText::notAFile());
    // The additional byte detects a file that has grown.
    const QByteArray bytes = file.read(maxFileBytes + 1);
    if (file.error() != QFileDevice::NoError)
        return refused(Kind::NotReadable, path, file.errorString());
    if (bytes.size() > maxFileBytes)
        return refused(Kind::NotReadable, path, FileErrorText::tooLarge());
    return bytes;
}

tl::expected<void, FileError> replaceBytes(const QString& path, const QByteArray& bytes)
{
    using Kind = FileError::Kind;
    if (const QFileInfo present(path); present.exists() && !present.isFile())
        return refused(Kind::NotWritable, path, FileErrorText::notAFile());
    QSaveFile file(path);
    // Flushes and synchronizes here: commit() does not notice when the last bytes did not fit.
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.flush())
        return refused(Kind::NotWritable, path, file.errorString());
    if (::fsync(file.handle()) != 0)
        return refused(Kind::NotWritable, path, qt_error_string());
    if (!file.commit())
        return refused(Kind::NotWritable, path, file.errorString());
    settleFolder(path);
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
        return refused(FileError::Kind::NotWritable, path, reason);
    return {};
}

QString printable(const QString& text)
{
    QString shown;
    shown.reserve(text.size());
    for (const QChar character : text) {
        if (character.category() != QChar::Other_Control || character == u'\n' || character == u'\t')
            shown += character;
        else
            shown += QStringLiteral("\\u%1").arg(uint{character.unicode()}, 4, 16, QLatin1Char('0'));
    }
    return shown;
}

QString backupPath(const QString& path)
{
    return path + QStringLiteral(".bak");
}

} // namespace campanel::store
