// SPDX-License-Identifier: Apache-2.0
#include "app/link/held_jog.h"

using namespace std::chrono_literals;

namespace campanel::link {

namespace {

// The poll period: well below the 200 ms after which the controller ends a jog, and shorter than the time of
// a lost answer.
constexpr auto longestPollPeriod = 40ms;

} // namespace

void HeldJog::hold(const JogRequest& request)
{
    if (request.direction == JogDirection::None)
        m_isBlocked = false;
    else if (m_held.direction != JogDirection::None && request.until - jogCounts > m_held.until)
        m_isBlocked = true; // update too late, without an exchange in between
    m_held = request;
}

void HeldJog::end()
{
    m_isBlocked = m_isBlocked || m_held.direction != JogDirection::None;
}

JogDirection HeldJog::directionAt(SteadyTime now) const
{
    return m_isBlocked || now >= m_held.until ? JogDirection::None : m_held.direction;
}

std::uint16_t HeldJog::bits(SteadyTime now)
{
    m_sent = directionAt(now);
    if (m_sent == JogDirection::None)
        end(); // expired
    const auto bit = m_sent == JogDirection::Forward ? modbus::JogBit::Forward : modbus::JogBit::Reverse;
    return m_sent == JogDirection::None ? std::uint16_t{0}
                                        : static_cast<std::uint16_t>(1U << static_cast<unsigned>(bit));
}

bool HeldJog::isPollDue(SteadyTime now, SteadyTime lastPollAt) const
{
    const JogDirection direction = directionAt(now);
    return direction != m_heard || (direction != JogDirection::None && now - lastPollAt >= longestPollPeriod);
}

} // namespace campanel::link
