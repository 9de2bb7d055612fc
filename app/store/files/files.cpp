// SPDX-License-Identifier: Apache-2.0
// Writes files by QSaveFile: a temporary file, then a rename.
#include "app/store/files/files.h"

#include "app/store/files/hidden_character.h"

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

// Returns the UTF-16 units of the character at a place: 2 for a valid pair.
qsizetype lengthAt(const QString& text, qsizetype place)
{
    return text[place].isHighSurrogate() && place + 1 < text.size() && text[place + 1].isLowSurrogate() ? 2
                                                                                                        : 1;
}

bool isHidden(const QString& text, qsizetype place)
{
    return hasHiddenCategory(lengthAt(text, place) == 2 ? QChar::surrogateToUcs4(text[place], text[place + 1])
                                                        : char32_t{text[place].unicode()});
}

// Returns the units in the form of JSON.
QString escaped(QStringView units)
{
    QString shown;
    for (const QChar unit : units)
        shown += QStringLiteral("\\u%1").arg(uint{unit.unicode()}, 4, 16, QLatin1Char('0'));
    return shown;
}

} // namespace

tl::expected<std::unique_ptr<QFile>, FileError> openRegular(const QString& path, Links links)
{
    using Kind = FileError::Kind;
    // O_NONBLOCK: opening a pipe would wait for its writer.
    const int handle =
        ::open(QFile::encodeName(path).constData(),
               O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | (links == Links::Refuse ? O_NOFOLLOW : 0));
    if (handle < 0) {
        const int code = errno;
        const bool isMissing = code == ENOENT || code == ENOTDIR;
        return refused(isMissing ? Kind::NotFound : Kind::NotReadable, path,
                       code == ELOOP && links == Links::Refuse ? FileErrorText::notAFile()
                                                               : qt_error_string(code));
    }
    auto file = std::make_unique<QFile>();
    if (!file->open(handle, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle)) {
        ::close(handle);
        return refused(Kind::NotReadable, path, file->errorString());
    }
    struct stat status = {};
    if (::fstat(handle, &status) != 0)
        return refused(Kind::NotReadable, path, qt_error_string());
    if (!S_ISREG(status.st_mode))
        return refused(Kind::NotReadable, path, FileErrorText::notAFile());
    return file;
}

tl::expected<QByteArray, FileError> readBytes(const QString& path, Links links)
{
    using Kind = FileError::Kind;
    const auto file = openRegular(path, links);
    if (!file)
        return tl::unexpected(file.error());
    // The additional byte detects a file that has grown.
    const QByteArray bytes = (*file)->read(maxFileBytes + 1);
    if ((*file)->error() != QFileDevice::NoError)
        return refused(Kind::NotReadable, path, (*file)->errorString());
    if (bytes.size() > maxFileBytes)
        return refused(Kind::NotReadable, path, FileErrorText::tooLarge());
    return bytes;
}

bool isRegularOrMissing(const QString& path)
{
    struct stat status = {};
    return ::stat(QFile::encodeName(path).constData(), &status) != 0 || S_ISREG(status.st_mode);
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
    const int file = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
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
    for (qsizetype i = 0; i < text.size(); i += lengthAt(text, i)) {
        const QStringView character = QStringView(text).mid(i, lengthAt(text, i));
        shown += isHidden(text, i) && text[i] != u'\n' && text[i] != u'\t' ? escaped(character)
                                                                           : character.toString();
    }
    return shown;
}

QString oneLine(const QString& text, qsizetype maxLength)
{
    QString line;
    for (qsizetype i = 0; i < text.size(); i += lengthAt(text, i)) {
        const QStringView character = QStringView(text).mid(i, lengthAt(text, i));
        if (text[i].isSpace() && !isHidden(text, i) && (line.isEmpty() || line.back().isSpace()))
            continue;
        const QString shown = isHidden(text, i) ? escaped(character) : character.toString();
        if (line.size() + shown.size() > maxLength)
            return line + u'…';
        line += shown;
    }
    return line.trimmed();
}

QString backupPath(const QString& path)
{
    return path + QStringLiteral(".bak");
}

} // namespace campanel::store
