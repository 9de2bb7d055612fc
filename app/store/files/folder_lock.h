// SPDX-License-Identifier: Apache-2.0
// Keeps a second panel from a data folder. The lock belongs to the process: it ends with it, however that
// ends, and leaves no file behind.
#pragma once

#include <QString>

namespace campanel::store {

class FolderLock {
public:
    // Makes the folder when it does not exist.
    explicit FolderLock(const QString& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    // True while another process has the folder. A folder that cannot be locked is not refused: what is wrong
    // with it is said when its database is opened.
    [[nodiscard]] bool isHeldByAnother() const { return m_isHeldByAnother; }

private:
    int m_folder = -1; // descriptor
    bool m_isHeldByAnother = false;
};

} // namespace campanel::store
