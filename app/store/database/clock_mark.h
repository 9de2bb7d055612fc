// SPDX-License-Identifier: Apache-2.0
// The mark of records that were written while the clock of the computer was not set. Times are milliseconds
// since 1970 UTC.
#pragma once

#include "app/store/database/database.h"

namespace campanel::store {

// The start of 2026: no panel recorded anything before.
inline constexpr qint64 earliestRecordMs = 1'767'225'600'000;
// A clock that a time server sets back by less is set.
inline constexpr qint64 maxSetBackMs = 60'000;

// Returns true when a clock at `timeMs` cannot be right: it is before `earliestRecordMs`, or behind the
// newest record.
[[nodiscard]] constexpr bool isTimeDoubtful(qint64 timeMs, qint64 newestMs)
{
    return timeMs < earliestRecordMs || timeMs < newestMs - maxSetBackMs;
}

// Returns the latest time of all alarms and audit rows; 0: there is none.
[[nodiscard]] tl::expected<qint64, StoreError> newestRecordMs(Database& database);

} // namespace campanel::store
