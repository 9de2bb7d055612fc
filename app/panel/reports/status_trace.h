// SPDX-License-Identifier: Apache-2.0
// The last ten seconds of what the controller said, sample by sample, and those before its last fault: what
// a manufacturer wants to see who was not there.
#pragma once

#include "app/link/link_values.h"

#include <QByteArray>
#include <QDateTime>

#include <chrono>
#include <deque>

namespace campanel::machine {

class StatusTrace {
public:
    static constexpr std::chrono::seconds length{10};

    void add(const link::StatusSample& sample);

    [[nodiscard]] const std::deque<link::StatusSample>& latest() const { return m_latest; }
    // Ends with the sample that first told of the fault; empty: there was none.
    [[nodiscard]] const std::deque<link::StatusSample>& beforeFault() const { return m_beforeFault; }

    // A line for each sample; times as UTC, at `moment` of the link's clock it was `timeOfDay`. What is not
    // known is empty.
    [[nodiscard]] static QByteArray csv(const std::deque<link::StatusSample>& samples,
                                        link::SteadyTime moment, const QDateTime& timeOfDay);

private:
    std::deque<link::StatusSample> m_latest;
    std::deque<link::StatusSample> m_beforeFault;
};

} // namespace campanel::machine
