// SPDX-License-Identifier: Apache-2.0
// A table that keeps its newest rows: rows beyond a number are deleted, lowest key first. Only rows count,
// because the clock may be set at will.
#pragma once

#include "app/store/database/database.h"

namespace campanel::store {

// Records `added` new rows of the table `name` (see the table ring) and deletes excess rows by the column
// `key`. Call it in the transaction that added them.
[[nodiscard]] tl::expected<void, StoreError> noteRows(Database& database, const QString& name,
                                                      const QString& key, qint64 added, qint64 kept);
// Returns the number of rows.
[[nodiscard]] tl::expected<qint64, StoreError> rowsOf(Database& database, const QString& name);

} // namespace campanel::store
