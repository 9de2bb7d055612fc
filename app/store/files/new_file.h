// SPDX-License-Identifier: Apache-2.0
// A file that is made anew at a place of exchange: no file is ever replaced.
#pragma once

#include "app/store/files/exchange_places.h"

#include <QByteArray>

#include <functional>

namespace campanel::store {

// Waits for the disk: afterwards a stick can be taken out. The path, made as by freePath(), or a sentence in
// the language of the program.
[[nodiscard]] tl::expected<QString, QString> writeNewFile(const Place& place, const QString& name,
                                                          const QString& suffix, const QByteArray& bytes);

// The same of one that writes itself, whole or not at all; the system's reason on failure.
using FileWriter = std::function<tl::expected<void, QString>(const QString& path)>;
[[nodiscard]] tl::expected<QString, QString> writeNewFile(const Place& place, const QString& name,
                                                          const QString& suffix, const FileWriter& write);

} // namespace campanel::store
