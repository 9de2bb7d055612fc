// SPDX-License-Identifier: Apache-2.0
// A file that is made anew at a place of exchange: no file is ever replaced.
#pragma once

#include "app/store/exchange_places.h"

#include <QByteArray>

namespace campanel::store {

// Waits for the disk. The path, made as by freePath(), or a sentence in the language of the program.
[[nodiscard]] tl::expected<QString, QString> writeNewFile(const Place& place, const QString& name,
                                                          const QString& suffix, const QByteArray& bytes);

} // namespace campanel::store
