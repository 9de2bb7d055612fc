// SPDX-License-Identifier: Apache-2.0
// The mark of records that were written while the clock of the computer was not set, or ran ahead. Times are
// milliseconds since 1970 UTC.
#pragma once

#include "app/store/database/database.h"

namespace campanel::store {

// The start of 2026: no panel recorded anything before.
inline constexpr qint64 earliestRecordMs = 1'767'225'600'000;
// A clock that a time server sets back by less is set.
inline constexpr qint64 maxSetBackMs = 60'000;

// NotSet: it counts from the last shutdown or from nothing. Unproven: by a hardware clock, say. Proven: a
// time server or a person set it since the panel's start.
enum class ClockState { NotSet, Unproven, Proven };

// Returns true when a clock at `timeMs` cannot be right: it is not set, before `earliestRecordMs`, or behind
// the newest record without a proof.
[[nodiscard]] constexpr bool isTimeDoubtful(qint64 timeMs, qint64 newestMs,
                                            ClockState clock = ClockState::Unproven)
{
    return clock == ClockState::NotSet || timeMs < earliestRecordMs ||
           (clock == ClockState::Unproven && timeMs < newestMs - maxSetBackMs);
}

// Returns the latest time of all alarms and audit rows that are not marked and that no proof has made untrue;
// 0: there is none.
[[nodiscard]] tl::expected<qint64, StoreError> newestRecordMs(Database& database);

// Keeps that the clock is right at `nowMs`: what is later was recorded by a clock that ran ahead. Alarms,
// states, orders and versions of recipes are marked. Rows of the audit trail are never changed;
// newestRecordMs() leaves those out.
[[nodiscard]] tl::expected<void, StoreError> noteClockProven(Database& database, qint64 nowMs);

} // namespace campanel::store
