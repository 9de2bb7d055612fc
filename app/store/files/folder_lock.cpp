// SPDX-License-Identifier: Apache-2.0
#include "app/store/files/folder_lock.h"

#include "app/store/files/private_files.h"

#include <QFile>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace campanel::store {

FolderLock::FolderLock(const QString& folder)
{
    if (!makePrivateFolder(folder))
        return;
    m_folder = ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    m_isHeldByAnother = m_folder >= 0 && ::flock(m_folder, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

FolderLock::~FolderLock()
{
    if (m_folder >= 0)
        ::close(m_folder);
}

} // namespace campanel::store
