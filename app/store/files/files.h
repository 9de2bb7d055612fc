// SPDX-License-Identifier: Apache-2.0
// Reading and replacing small files as a whole: the one way in which all programs do it.
#pragma once

#include "app/store/files/file_error.h"

#include <QByteArray>

#include <tl/expected.hpp>

namespace campanel::store {

// Reads a regular file of at most 1 MB: what is stored here has a few KB. Anything else, such as a pipe, a
// device or a longer file, is an error at once; nothing is waited for.
[[nodiscard]] tl::expected<QByteArray, FileError> readBytes(const QString& path);
// Replaces the file in one step after the new content has reached the medium. On an error the old file is
// whole, also after a power cut. What is there and is no regular file is left alone.
[[nodiscard]] tl::expected<void, FileError> replaceBytes(const QString& path, const QByteArray& bytes);
// Brings all that was written to the file system of `path` onto its medium, names too. The system's reason on
// failure.
[[nodiscard]] tl::expected<void, FileError> settle(const QString& path);

// Makes a text fit for a terminal or a log: control characters become visible, as "\u001b"; only line ends
// and tabulators stay. A JSON text still says the same.
[[nodiscard]] QString printable(const QString& text);

// Returns the name of the copy that is kept of the last good file.
[[nodiscard]] QString backupPath(const QString& path);

} // namespace campanel::store
