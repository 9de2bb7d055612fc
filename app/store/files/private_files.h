// SPDX-License-Identifier: Apache-2.0
// Files and folders that only the panel's own user may read: they contain recipes and the hashes of PINs.
#pragma once

#include <QString>

namespace campanel::store {

// Creates the folder and its parents; new ones get mode 0700. Returns false on failure.
[[nodiscard]] bool makePrivateFolder(const QString& folder);
// Creates an empty file of mode 0600. An existing file keeps its content and gets that mode. Returns false on
// failure.
[[nodiscard]] bool makePrivateFile(const QString& path);
// Removes the permissions of other users from an existing file or folder.
void makePrivate(const QString& path);

// Flushes the file's content to its medium. Returns false on failure.
[[nodiscard]] bool syncFile(const QString& path);

} // namespace campanel::store
