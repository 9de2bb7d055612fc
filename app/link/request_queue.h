// SPDX-License-Identifier: Apache-2.0
// Requests that wait for the line, in the order of their priority: stop > motion commands > writes. Polls and
// transfers have no entry here: they fill the time that is left.
#pragma once

#include "app/link/link_values.h"

#include <deque>
#include <optional>
#include <variant>

namespace campanel::link {

enum class Priority { Stop, Motion, Write };

using Request = std::variant<CommandRequest, ParameterRequest>;

[[nodiscard]] Priority priorityOf(modbus::Command command);
[[nodiscard]] Priority priorityOf(const Request& request);

class RequestQueue {
public:
    void push(Request request);
    // The oldest of the highest priority.
    [[nodiscard]] std::optional<Request> take();
    [[nodiscard]] bool isStopNext() const;
    [[nodiscard]] bool isEmpty() const { return m_requests.empty(); }
    // All that wait, leaving the queue empty.
    [[nodiscard]] std::deque<Request> takeAll();

private:
    std::deque<Request> m_requests; // ordered
};

} // namespace campanel::link
