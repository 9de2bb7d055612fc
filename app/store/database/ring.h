// SPDX-License-Identifier: Apache-2.0
// A table that keeps its newest rows: what is beyond a number of rows goes, lowest key first. The clock may
// be set at will: only rows count.
#pragma once

#include "app/store/database/database.h"

namespace campanel::store {

// Says that `added` rows have come into the table `name` (see the table ring) and deletes those that are too
// many, by the column `key`. To be called in the transaction that added them.
[[nodiscard]] tl::expected<void, StoreError> noteRows(Database& database, const QString& name,
                                                      const QString& key, qint64 added, qint64 kept);
// How many there are.
[[nodiscard]] tl::expected<qint64, StoreError> rowsOf(Database& database, const QString& name);

} // namespace campanel::store
