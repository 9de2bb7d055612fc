// SPDX-License-Identifier: Apache-2.0
// Overall equipment effectiveness by its usual definitions: availability x performance x quality.
#pragma once

#include <cstdint>
#include <limits>

namespace campanel::panel {

// The times and counts of a shift.
struct Production {
    std::int64_t plannedMs = 0; // known time without planned stops
    std::int64_t runMs = 0;
    std::int64_t pieces = 0; // with the skipped cuts, each of which took a cycle
    std::int64_t outOfTolerance = 0;
    std::int64_t startUpScrap = 0;
    std::int64_t skipped = 0;
    double idealMs = 0; // sum of pieces x ideal cycle; NaN: an ideal rate is unknown

    [[nodiscard]] std::int64_t rejects() const;
};

// Shares, 0..1; NaN while unknown.
struct Oee {
    double availability = std::numeric_limits<double>::quiet_NaN(); // run time / planned time
    double performance = std::numeric_limits<double>::quiet_NaN();  // ideal time / run time, at most 1
    double rawPerformance = std::numeric_limits<double>::quiet_NaN();
    double quality = std::numeric_limits<double>::quiet_NaN(); // good pieces / pieces
    double oee = std::numeric_limits<double>::quiet_NaN();     // product of the three
};

// Without run time the product is 0, whatever is unknown; without planned time everything is unknown.
[[nodiscard]] Oee oeeOf(const Production& production);

} // namespace campanel::panel
