// SPDX-License-Identifier: Apache-2.0
#include "app/store/database/clock_mark.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

tl::expected<qint64, StoreError> newestRecordMs(Database& database)
{
    auto found = database.execute(u"SELECT max(coalesce((SELECT max(raised_ms) FROM alarm), 0), "
                                  "coalesce((SELECT max(time_ms) FROM audit), 0))"_s);
    if (!found)
        return tl::unexpected(found.error());
    return found->next() ? found->value(0).toLongLong() : 0;
}

} // namespace campanel::store
