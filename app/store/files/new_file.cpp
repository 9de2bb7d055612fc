// SPDX-License-Identifier: Apache-2.0
// Writes below another name and renames: the file is whole or not there. No link is followed, because neither
// step takes a name that is used.
#include "app/store/files/new_file.h"

#include "app/store/files/file_error.h"
#include "app/store/files/files.h"
#include "app/store/files/private_files.h"

#include <QDir>
#include <QFile>
#include <QRandomGenerator>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr int maxTries = 100; // names that something else has taken meanwhile

// Creates an empty file with a name of its own. The error is the system's reason.
tl::expected<QString, QString> createTemporary(const QString& folder)
{
    for (int i = 0; i < maxTries; ++i) {
        const QString path = QDir(folder).filePath(
            u".campanel-%1"_s.arg(QRandomGenerator::global()->generate(), 8, 16, QLatin1Char('0')));
        const int file = ::open(QFile::encodeName(path).constData(),
                                O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (file >= 0) {
            ::close(file);
            return path;
        }
        if (errno != EEXIST)
            break;
    }
    return tl::unexpected(qt_error_string());
}

// Gives the file a name that nothing has, not even a link that leads nowhere. Returns 0 or the error.
int renameNew(const QString& from, const QString& to)
{
    const QByteArray present = QFile::encodeName(from);
    const QByteArray wanted = QFile::encodeName(to);
    if (::renameat2(AT_FDCWD, present.constData(), AT_FDCWD, wanted.constData(), RENAME_NOREPLACE) == 0)
        return 0;
    if (errno != EINVAL && errno != ENOSYS)
        return errno;
    struct stat found = {}; // a file system without that step, such as NFS
    if (::lstat(wanted.constData(), &found) == 0)
        return EEXIST;
    return ::rename(present.constData(), wanted.constData()) == 0 ? 0 : errno;
}

tl::expected<void, QString> writeWhole(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.flush())
        return tl::unexpected(file.errorString());
    return {};
}

tl::expected<QString, QString> writeAndRename(const Place& place, const QString& name, const QString& suffix,
                                              const QString& temporary, const FileWriter& write)
{
    if (const auto written = write(temporary); !written)
        return tl::unexpected(written.error());
    if (!syncFile(temporary))
        return tl::unexpected(qt_error_string());
    QString path;
    int error = EEXIST;
    for (int i = 0; i < maxTries && error == EEXIST; ++i) {
        path = freePath(place, name, suffix);
        error = renameNew(temporary, path);
    }
    if (error != 0)
        return tl::unexpected(qt_error_string(error));
    if (const auto settled = settle(path); !settled) {
        QFile::remove(path); // it did not exist before
        return tl::unexpected(settled.error().found);
    }
    return path;
}

} // namespace

tl::expected<QString, QString> writeNewFile(const Place& place, const QString& name, const QString& suffix,
                                            const QByteArray& bytes)
{
    return writeNewFile(place, name, suffix,
                        [&bytes](const QString& path) { return writeWhole(path, bytes); });
}

tl::expected<QString, QString> writeNewFile(const Place& place, const QString& name, const QString& suffix,
                                            const FileWriter& write)
{
    return createTemporary(place.path)
        .and_then([&](const QString& temporary) {
            auto path = writeAndRename(place, name, suffix, temporary, write);
            if (!path)
                QFile::remove(temporary);
            return path;
        })
        .map_error([&](const QString& reason) {
            const QString path = QDir(place.path).filePath(portableName(name) + u'.' + suffix);
            return FileErrorText::tr("%1 Free some space, unlock the stick or choose another location.",
                                     "%1: whole sentence")
                .arg(FileErrorText::tr("The file %1 cannot be written: %2.")
                         .arg(QDir::toNativeSeparators(path), reason));
        });
}

} // namespace campanel::store
