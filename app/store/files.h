// SPDX-License-Identifier: Apache-2.0
// Reading and replacing small files as a whole. Internal to app/store.
#pragma once

#include "app/store/file_error.h"

#include <QByteArray>

#include <tl/expected.hpp>

namespace campanel::store {

// At most 1 MB: what is stored here has a few KB; a file that is thousands of times longer is something else.
[[nodiscard]] tl::expected<QByteArray, FileError> readBytes(const QString& path);
// The file is the old one or the new one, also after a power cut.
[[nodiscard]] tl::expected<void, FileError> replaceBytes(const QString& path, const QByteArray& bytes);
// Brings all that was written to the file system of `path` onto its medium, names too. The system's reason on
// failure.
[[nodiscard]] tl::expected<void, FileError> settle(const QString& path);

} // namespace campanel::store
