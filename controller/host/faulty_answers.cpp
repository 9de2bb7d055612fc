// SPDX-License-Identifier: Apache-2.0
// The faults of the controller's answers, and the second master.
#include "faulty_line.h"

#include <algorithm>
#include <utility>

namespace campanel::controller {
namespace {

// The delay of Idle after the end of an answer, in frame gaps.
constexpr int idleGaps = 3;
// The approximate length of the answer to a second master.
constexpr std::size_t foreignAnswerCharacters = 100;

} // namespace

void FaultyLine::fromController(std::span<const std::uint8_t> bytes, std::uint64_t frame, std::int64_t nowNs)
{
    putOnLine(nowNs);
    if (nowNs < m_muteUntilNs)
        return;
    FrameBytes answer(bytes.begin(), bytes.end());
    const auto exchange = std::ranges::find(m_open, frame, &Exchange::frame);
    if (nowNs < m_garbleUntilNs && m_garbledPart != FaultPart::Request)
        toPanel(garbled(answer, m_random), nowNs);
    else if (exchange == m_open.end() || !exchange->fault || exchange->fault->part == FaultPart::Request)
        toPanel(std::move(answer), nowNs);
    else
        putAnswer(*exchange->fault, *exchange, std::move(answer), nowNs);
    putOnLine(nowNs);
}

// Returns the changed bytes of a request or an answer.
FrameBytes FaultyLine::damaged(const FaultRule& rule, const Exchange& exchange, FrameBytes frame)
{
    switch (rule.kind) {
    case FaultKind::Truncate:
        return truncated(frame, m_random);
    case FaultKind::Corrupt:
        return corrupted(frame, rule.bits, m_random);
    case FaultKind::Trailing: {
        const FrameBytes garbage = randomBytes(m_random, rule.bytes);
        frame.insert(frame.end(), garbage.begin(), garbage.end());
        return frame;
    }
    case FaultKind::WrongUnit:
        return withWrongUnit(frame, m_random);
    case FaultKind::WrongFunction:
        return withWrongFunction(frame, m_random);
    case FaultKind::WrongCount:
        return withWrongCount(frame, m_random);
    case FaultKind::Exception:
        return exceptionTo(exchange.request, rule.code);
    case FaultKind::MapVersion:
    case FaultKind::DeviceType:
        return withIdentity(exchange.request, frame, rule);
    default:
        return frame;
    }
}

void FaultyLine::putAnswer(const FaultRule& rule, const Exchange& exchange, FrameBytes answer,
                           std::int64_t nowNs)
{
    const std::int64_t endNs = nowNs + lengthNs(answer.size());
    switch (rule.kind) {
    case FaultKind::LostAnswer:
        return;
    case FaultKind::Late:
        toPanel(std::move(answer), nowNs + scaled(m_script.timeoutNs, rule.times));
        return;
    case FaultKind::DuplicateAnswer:
        toPanel(answer, endNs + m_gapNs);
        break;
    case FaultKind::Gap: {
        const std::size_t cut = 1 + pickBelow(m_random, answer.size() - 1);
        toPanel({answer.begin() + static_cast<std::ptrdiff_t>(cut), answer.end()},
                nowNs + lengthNs(cut) + scaled(m_characterNs, rule.characters));
        answer.resize(cut);
        break;
    }
    case FaultKind::Noise:
        toPanel(randomBytes(m_random, rule.bytes), endNs + m_gapNs + rule.afterNs);
        break;
    case FaultKind::SecondMaster:
        if (rule.when == FaultMoment::After)
            secondMaster(exchange, endNs + m_gapNs);
        break;
    case FaultKind::Unplug:
        if (rule.when == FaultMoment::Answer)
            answer.resize(answer.size() / 2);
        unplug(rule,
               nowNs + lengthNs(answer.size()) + (rule.when == FaultMoment::Idle ? idleGaps * m_gapNs : 0));
        break;
    default:
        answer = damaged(rule, exchange, std::move(answer));
        break;
    }
    toPanel(std::move(answer), nowNs);
}

// The panel receives the foreign request and the answer to it, because nothing tells them apart; its own next
// request waits.
void FaultyLine::secondMaster(const Exchange& exchange, std::int64_t startNs)
{
    FrameBytes request = secondMasterRequest(exchange.request, m_random);
    toPanel(request, startNs);
    toController(std::move(request), 0, startNs);
    m_toControllerEndNs += lengthNs(foreignAnswerCharacters) + 3 * m_gapNs;
}

// The byte being sent at that time is the last.
void FaultyLine::unplug(const FaultRule& rule, std::int64_t atNs)
{
    atNs += m_characterNs / 2;
    m_events.insert({atNs, {LineEvent::Kind::Unplug, {}}});
    m_events.insert({atNs + rule.timeNs, {LineEvent::Kind::Plug, rule.port}});
}

} // namespace campanel::controller
