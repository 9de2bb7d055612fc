// SPDX-License-Identifier: Apache-2.0
#include "app/store/files/private_files.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace campanel::store {

namespace {

constexpr mode_t ownerOnlyFile = 0600;
constexpr mode_t ownerOnlyFolder = 0700;

} // namespace

bool makePrivateFolder(const QString& folder)
{
    const QFileInfo info(QDir::cleanPath(folder));
    if (info.isDir())
        return true;
    if (!info.isRoot() && !makePrivateFolder(info.path()))
        return false;
    return ::mkdir(QFile::encodeName(info.filePath()).constData(), ownerOnlyFolder) == 0 ||
           QFileInfo(info.filePath()).isDir(); // created by another process in the meantime
}

bool makePrivateFile(const QString& path)
{
    // O_NONBLOCK: opening a pipe would wait for its reader.
    const int file = ::open(QFile::encodeName(path).constData(), O_WRONLY | O_CREAT | O_NONBLOCK | O_CLOEXEC,
                            ownerOnlyFile);
    if (file < 0)
        return false;
    ::close(file);
    makePrivate(path);
    return true;
}

void makePrivate(const QString& path)
{
    const QByteArray name = QFile::encodeName(path);
    struct stat found {};
    if (::stat(name.constData(), &found) == 0 && (found.st_mode & 077U) != 0)
        (void)::chmod(name.constData(), found.st_mode & 0700U);
}

bool syncFile(const QString& path)
{
    const int file = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const bool isSynced = file >= 0 && ::fsync(file) == 0;
    const int reason = errno;
    if (file >= 0)
        ::close(file);
    errno = reason;
    return isSynced;
}

} // namespace campanel::store
