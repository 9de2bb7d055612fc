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
    case modbus::Command::TryOutput:
    case modbus::Command::JogBag:
    case modbus::Command::SingleCut:
    case modbus::Command::Measure:
        return Priority::Motion;
    case modbus::Command::None:
    case modbus::Command::ApplyStaged:
    case modbus::Command::DiscardStaged:
    case modbus::Command::SaveToFlash:
    case modbus::Command::SetClock:
    case modbus::Command::TeachMarks:
    case modbus::Command::OrderStart:
    case modbus::Command::OrderEnd:
    case modbus::Command::Acknowledge:
    case modbus::Command::TakeBag:
        return Priority::Write;
    }
    return Priority::Write;
}

Priority priorityOf(const Request& request)
{
    const auto* command = std::get_if<CommandRequest>(&request);
    return command ? priorityOf(command->command) : Priority::Write;
}

void RequestQueue::push(Request request)
{
    const auto isLessUrgent = [&](const Request& waiting) {
        return priorityOf(waiting) > priorityOf(request);
    };
    const auto place = std::ranges::find_if(m_requests, isLessUrgent);
    m_requests.insert(place, std::move(request));
}

std::optional<Request> RequestQueue::take()
{
    if (m_requests.empty())
        return std::nullopt;
    Request request = std::move(m_requests.front());
    m_requests.pop_front();
    return request;
}

bool RequestQueue::isStopNext() const
{
    return !m_requests.empty() && priorityOf(m_requests.front()) == Priority::Stop;
}

std::deque<Request> RequestQueue::takeAll()
{
    return std::exchange(m_requests, {});
}

} // namespace campanel::link
