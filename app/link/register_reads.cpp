// SPDX-License-Identifier: Apache-2.0
#include "app/link/register_reads.h"

#include <utility>

namespace campanel::link {

bool RegisterReads::push(const ReadRequest& request)
{
    if (m_requests.size() >= maxWaiting)
        return false;
    m_requests.push_back(request);
    return true;
}

std::optional<ReadOutcome> RegisterReads::advance(modbus::RtuClient& client)
{
    const ReadRequest request = m_requests.front();
    auto read = client.readProven(request.address, request.count);
    if (!read) {
        using Kind = modbus::LinkErrorKind;
        const Kind kind = read.error().kind;
        const bool isFinal = kind == Kind::RangeNotReadable || kind == Kind::ValueRefused ||
                             kind == Kind::Exception || modbus::portIsLost(read.error());
        if (!isFinal && ++m_failures < attempts)
            return std::nullopt;
    }
    m_requests.pop_front();
    m_failures = 0;
    ReadOutcome outcome{request};
    outcome.receivedAt = std::chrono::steady_clock::now();
    if (read) {
        outcome.registers = std::move(*read);
    } else {
        outcome.end = ReadEnd::Failed;
        outcome.error = read.error();
    }
    return outcome;
}

std::deque<ReadRequest> RegisterReads::takeAll()
{
    m_failures = 0;
    return std::exchange(m_requests, {});
}

} // namespace campanel::link
