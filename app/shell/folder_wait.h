// SPDX-License-Identifier: Apache-2.0
// Keeps a data folder for one panel: a second one shows that it waits, and starts when the first one ends.
#pragma once

#include "app/store/files/folder_lock.h"

#include <QString>

#include <memory>

namespace campanel::shell {

// Returns the lock of the folder. While another panel holds it, shows a window in that language. Returns null
// when the window is closed. A kiosk waits without a person, so a panel that ends late delays the next one
// only.
[[nodiscard]] std::unique_ptr<store::FolderLock> waitForFolder(const QString& folder,
                                                               const QString& language);

} // namespace campanel::shell
