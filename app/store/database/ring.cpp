// SPDX-License-Identifier: Apache-2.0
#include "app/store/database/ring.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::store {

tl::expected<qint64, StoreError> rowsOf(Database& database, const QString& name)
{
    auto asked = database.execute(u"SELECT held FROM ring WHERE name = ?"_s, {name});
    if (!asked)
        return tl::unexpected(asked.error());
    if (!asked->next())
        return tl::unexpected(StoreError{StoreError::Kind::Damaged, database.path(), name});
    return asked->value(0).toLongLong();
}

tl::expected<void, StoreError> noteRows(Database& database, const QString& name, const QString& key,
                                        qint64 added, qint64 kept)
{
    const auto before = rowsOf(database, name);
    if (!before)
        return tl::unexpected(before.error());
    const qint64 excess = std::max<qint64>(0, *before + added - kept);
    qint64 gone = 0;
    if (excess > 0) {
        const QString oldest =
            u"DELETE FROM %1 WHERE %2 IN (SELECT %2 FROM %1 ORDER BY %2 LIMIT ?)"_s.arg(name, key);
        const auto deleted = database.execute(oldest, {excess});
        if (!deleted)
            return tl::unexpected(deleted.error());
        gone = deleted->numRowsAffected();
    }
    const auto noted =
        database.execute(u"UPDATE ring SET held = ? WHERE name = ?"_s, {*before + added - gone, name});
    return noted ? tl::expected<void, StoreError>() : tl::unexpected(noted.error());
}

} // namespace campanel::store
