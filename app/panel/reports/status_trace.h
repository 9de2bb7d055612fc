// SPDX-License-Identifier: Apache-2.0
// The controller's status of the last ten seconds, sample by sample, and of those before its last fault. It
// lets a manufacturer analyze a fault afterwards.
#pragma once

#include "app/link/link_values.h"

#include <QByteArray>
#include <QDateTime>

#include <chrono>
#include <deque>

namespace campanel::panel {

class StatusTrace {
public:
    static constexpr std::chrono::seconds length{10};

    // Returns true for the first sample with a fault.
    bool add(const link::StatusSample& sample);

    [[nodiscard]] const std::deque<link::StatusSample>& latest() const { return m_latest; }
    // Returns the samples up to the first one with the fault; empty: no fault.
    [[nodiscard]] const std::deque<link::StatusSample>& beforeFault() const { return m_beforeFault; }

    // Returns a line for each sample, with times in UTC. `timeOfDay` is the time of day at `moment` of the
    // link's clock. Unknown values are empty.
    [[nodiscard]] static QByteArray csv(const std::deque<link::StatusSample>& samples,
                                        link::SteadyTime moment, const QDateTime& timeOfDay);

private:
    std::deque<link::StatusSample> m_latest;
    std::deque<link::StatusSample> m_beforeFault;
};

} // namespace campanel::panel
