// SPDX-License-Identifier: Apache-2.0
// Requests that wait for the line, in the order of their priority: stop > motion commands > writes. Polls and
// transfers have no entry here: they fill the time that is left.
#pragma once

#include "app/link/link_values.h"

#include <deque>
#include <optional>

namespace campanel::link {

enum class Priority { Stop, Motion, Write };

[[nodiscard]] Priority priorityOf(modbus::Command command);

class RequestQueue {
public:
    void push(const CommandRequest& request);
    // The oldest of the highest priority.
    [[nodiscard]] std::optional<CommandRequest> take();
    [[nodiscard]] bool isEmpty() const { return m_requests.empty(); }
    // All that wait, leaving the queue empty.
    [[nodiscard]] std::deque<CommandRequest> takeAll();

private:
    std::deque<CommandRequest> m_requests; // ordered
};

} // namespace campanel::link
