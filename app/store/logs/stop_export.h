// SPDX-License-Identifier: Apache-2.0
// States and stops as CSV, times in UTC and in the panel's time zone.
#pragma once

#include "app/store/files/csv.h"
#include "app/store/logs/stop_log.h"

#include <QByteArray>

namespace campanel::store {

// Returns the stable word of a state: "running", "suspended" ...
[[nodiscard]] QString nameOf(StateInterval::State state);
// Returns one line for each interval.
[[nodiscard]] QByteArray statesCsv(const StopLog::Span& span, const CsvDialect& dialect = {});
// Returns one line for each stop: its begin and duration within the span, its state at the begin, its
// reason.
[[nodiscard]] QByteArray stopsCsv(const StopLog::Span& span, const CsvDialect& dialect = {});

} // namespace campanel::store
