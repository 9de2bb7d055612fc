// SPDX-License-Identifier: Apache-2.0
// Reads that wait for the line, in the order in which they were asked; a doubtful answer is asked for again,
// as reading does no harm, but not without end.
#pragma once

#include "app/link/link_values.h"

#include <deque>
#include <optional>

namespace campanel::link {

class RegisterReads {
public:
    static constexpr std::size_t mostWaiting = 32;
    static constexpr int attempts = 3;

    // False: too many wait already.
    [[nodiscard]] bool push(const ReadRequest& request);
    [[nodiscard]] bool isEmpty() const { return m_requests.empty(); }
    // One exchange. The outcome when there is one; empty when the question is to be repeated.
    [[nodiscard]] std::optional<ReadOutcome> advance(modbus::RtuClient& client);
    // All that wait, leaving none.
    [[nodiscard]] std::deque<ReadRequest> takeAll();

private:
    std::deque<ReadRequest> m_requests;
    int m_failures = 0; // of the first one
};

} // namespace campanel::link
