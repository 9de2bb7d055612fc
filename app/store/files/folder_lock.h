// SPDX-License-Identifier: Apache-2.0
// Locks a data folder against a second panel. The process owns the lock: it ends with the process in any case
// and leaves no file behind.
#pragma once

#include <QString>

namespace campanel::store {

class FolderLock {
public:
    // Creates the folder when it does not exist.
    explicit FolderLock(const QString& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    // Returns true while another process holds the folder. A folder that cannot be locked is accepted:
    // opening its database reports the error.
    [[nodiscard]] bool isHeldByAnother() const { return m_isHeldByAnother; }

private:
    int m_folder = -1; // descriptor
    bool m_isHeldByAnother = false;
};

} // namespace campanel::store
