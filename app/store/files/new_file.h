// SPDX-License-Identifier: Apache-2.0
// Writes a new file to an exchange place: no file is ever replaced.
#pragma once

#include "app/store/files/exchange_places.h"

#include <QByteArray>

#include <functional>

namespace campanel::store {

// Writes the file and waits for the disk: afterwards a stick can be removed. Returns the path, as from
// freePath(), or a sentence in the language of the program as error.
[[nodiscard]] tl::expected<QString, QString> writeNewFile(const Place& place, const QString& name,
                                                          const QString& suffix, const QByteArray& bytes);

// Writes a file by its own writer, completely or not at all; the error is the system's reason.
using FileWriter = std::function<tl::expected<void, QString>(const QString& path)>;
[[nodiscard]] tl::expected<QString, QString> writeNewFile(const Place& place, const QString& name,
                                                          const QString& suffix, const FileWriter& write);

} // namespace campanel::store
