// SPDX-License-Identifier: Apache-2.0
// Files and folders that the panel's own user alone may read: they hold recipes and the hashes of PINs.
#pragma once

#include <QString>

namespace campanel::store {

// Makes the folder and its parents; mode 0700 for those that are new. False: it cannot be made.
[[nodiscard]] bool makePrivateFolder(const QString& folder);
// Makes an empty file of mode 0600. A file that exists keeps its content and gets that mode. False: it cannot
// be made.
[[nodiscard]] bool makePrivateFile(const QString& path);
// Takes what others may do from a file or folder that exists.
void makePrivate(const QString& path);

// Brings the file's content onto its medium. False: it could not be.
[[nodiscard]] bool syncFile(const QString& path);

} // namespace campanel::store
