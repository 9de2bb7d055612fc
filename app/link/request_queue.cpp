// SPDX-License-Identifier: Apache-2.0
#include "app/link/request_queue.h"

#include <algorithm>
#include <utility>

namespace campanel::link {

Priority priorityOf(modbus::Command command)
{
    switch (command) {
    case modbus::Command::StopAtCycleEnd:
    case modbus::Command::StopNow:
        return Priority::Stop;
    case modbus::Command::Start:
    case modbus::Command::Home:
    case modbus::Command::ResetFault:
    case modbus::Command::CancelApply:
        return Priority::Motion;
    case modbus::Command::None:
    case modbus::Command::ApplyStaged:
    case modbus::Command::DiscardStaged:
    case modbus::Command::SaveToFlash:
    case modbus::Command::SetClock:
        return Priority::Write;
    }
    return Priority::Write;
}

void RequestQueue::push(const CommandRequest& request)
{
    const auto isLessUrgent = [&](const CommandRequest& waiting) {
        return priorityOf(waiting.command) > priorityOf(request.command);
    };
    m_requests.insert(std::ranges::find_if(m_requests, isLessUrgent), request);
}

std::optional<CommandRequest> RequestQueue::take()
{
    if (m_requests.empty())
        return std::nullopt;
    const CommandRequest request = m_requests.front();
    m_requests.pop_front();
    return request;
}

std::deque<CommandRequest> RequestQueue::takeAll()
{
    return std::exchange(m_requests, {});
}

} // namespace campanel::link
