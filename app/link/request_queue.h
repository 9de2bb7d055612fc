// SPDX-License-Identifier: Apache-2.0
// The queue of requests that wait for the line, by priority: stop > motion commands > writes. Polls and
// transfers are not in the queue: they use the remaining time.
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
    // Removes and returns the oldest request of the highest priority.
    [[nodiscard]] std::optional<Request> take();
    [[nodiscard]] bool isStopNext() const;
    [[nodiscard]] bool isEmpty() const { return m_requests.empty(); }
    // Removes and returns all requests.
    [[nodiscard]] std::deque<Request> takeAll();

private:
    std::deque<Request> m_requests; // sorted
};

} // namespace campanel::link
