// SPDX-License-Identifier: Apache-2.0
// A panel's database as the argument of a command: the file itself, or a backup with it.
#pragma once

#include "app/cli/failure.h"
#include "app/store/database/database.h"

#include <QTemporaryDir>

#include <memory>

namespace campanel::cli {

// Opens the database without writing to it. `unpacked` takes what is in a backup, and must outlive it.
[[nodiscard]] tl::expected<std::unique_ptr<store::Database>, Failure>
openDatabaseFile(const QString& path, const QTemporaryDir& unpacked);

} // namespace campanel::cli
