// SPDX-License-Identifier: Apache-2.0
// Opens, reads and replaces files, for all programs. Whoever reads a file that another program or person may
// have put there opens it by openRegular() or readBytes(): neither waits for a pipe.
#pragma once

#include "app/store/files/file_error.h"

#include <QByteArray>
#include <QFile>

#include <memory>

#include <tl/expected.hpp>

namespace campanel::store {

// The largest file that is read as a whole.
inline constexpr qsizetype maxFileBytes = 1'000'000;

// The meaning of a symbolic link at the end of a path. Refuse it where a stranger may have made it: on a
// stick, or where the reader has more rights than the owner of the folder.
enum class Links { Follow, Refuse };

// Opens a regular file for reading. A pipe, a device or a folder is an error at once, without waiting. The
// file may have any size: the caller limits what is read.
[[nodiscard]] tl::expected<std::unique_ptr<QFile>, FileError> openRegular(const QString& path,
                                                                          Links links = Links::Follow);
// Reads a whole file as openRegular() does, of at most 1 MB; stored files have a few KB.
[[nodiscard]] tl::expected<QByteArray, FileError> readBytes(const QString& path, Links links = Links::Follow);
// Returns false for a pipe, a device or a folder: a library that opens the path itself would wait for it.
[[nodiscard]] bool isRegularOrMissing(const QString& path);
// Replaces the file in one step after the new content has reached the medium. After an error or a power cut
// the old file is intact. Does not replace anything but a regular file.
[[nodiscard]] tl::expected<void, FileError> replaceBytes(const QString& path, const QByteArray& bytes);
// Flushes everything written to the file system of `path` to its medium, including names. The error is the
// system's reason.
[[nodiscard]] tl::expected<void, FileError> settle(const QString& path);

// Makes a whole text safe for a terminal: control characters and those that change the direction of writing
// become visible, as "\u001b"; only line ends and tabs stay. The meaning of a JSON text does not change.
[[nodiscard]] QString printable(const QString& text);
// The longest line of a log, and the longest cell of a table or name in a line.
inline constexpr qsizetype maxLineLength = 1000;
inline constexpr qsizetype maxCellLength = 80;
// Makes a text from elsewhere one short line, for a log or a cell of a table: line ends and tabs become
// visible too, several spaces become one, and a text that is cut ends with "…".
[[nodiscard]] QString oneLine(const QString& text, qsizetype maxLength = maxCellLength);

// Returns the name of the copy that is kept of the last good file.
[[nodiscard]] QString backupPath(const QString& path);

} // namespace campanel::store
