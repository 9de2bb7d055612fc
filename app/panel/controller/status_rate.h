// SPDX-License-Identifier: Apache-2.0
// The quality of the line: status blocks per second and the share of failed exchanges over the last seconds.
#pragma once

#include "app/link/link_values.h"

#include <deque>

namespace campanel::panel {

class StatusRate {
public:
    void note(const link::StatusBatch& batch, link::SteadyTime now);
    void clear() { m_batches.clear(); }

    // Returns NaN in the first second.
    [[nodiscard]] double perSecond(link::SteadyTime now) const;
    // Returns 4: no failure in the window, 3: below 1 %, 2: below 5 %, 1: more, 0: no status.
    [[nodiscard]] int quality(link::SteadyTime now) const;

private:
    struct Batch {
        link::SteadyTime at;
        int good = 0;
        int failed = 0;
    };

    std::deque<Batch> m_batches; // in the window, oldest first
};

} // namespace campanel::panel
