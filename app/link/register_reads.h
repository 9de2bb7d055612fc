// SPDX-License-Identifier: Apache-2.0
// The queue of reads that wait for the line. A read with a doubtful answer is repeated a limited number of
// times.
#pragma once

#include "app/link/link_values.h"

#include <deque>
#include <optional>

namespace campanel::link {

class RegisterReads {
public:
    static constexpr std::size_t maxWaiting = 32;
    static constexpr int attempts = 3;

    // Returns false when too many reads are waiting.
    [[nodiscard]] bool push(const ReadRequest& request);
    [[nodiscard]] bool isEmpty() const { return m_requests.empty(); }
    // Performs one exchange. Returns the outcome, or nothing when the read must be repeated.
    [[nodiscard]] std::optional<ReadOutcome> advance(modbus::RtuClient& client);
    // Returns all waiting reads and clears the queue.
    [[nodiscard]] std::deque<ReadRequest> takeAll();

private:
    std::deque<ReadRequest> m_requests;
    int m_failures = 0; // failures of the first read
};

} // namespace campanel::link
