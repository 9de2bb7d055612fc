// SPDX-License-Identifier: Apache-2.0
// The script, the faults of requests, and the queues of both directions.
#include "faulty_line.h"

#include <algorithm>
#include <utility>

namespace campanel::controller {
namespace {

constexpr std::size_t openExchanges = 32;
constexpr std::uint32_t busyCode = 6;

std::int64_t wireCharacterNs(LineSettings settings)
{
    settings.paced = true;
    return characterNs(settings);
}

bool strikesRequest(const FaultRule& rule)
{
    return rule.part != FaultPart::Answer;
}

} // namespace

FaultyLine::FaultyLine(const LineSettings& settings, FaultScript script, std::int64_t nowNs)
    : m_settings(settings)
    , m_line(settings)
    , m_characterNs(wireCharacterNs(settings))
    , m_gapNs(frameGapNs(settings))
{
    setScript(std::move(script), nowNs);
}

void FaultyLine::setScript(FaultScript script, std::int64_t nowNs)
{
    m_script = std::move(script);
    m_random.seed(m_script.seed);
    m_loadedNs = nowNs;
    m_exchanges = 0;
    m_applied = 0;
    m_busyLeft = 0;
    m_appliedByRule.assign(m_script.rules.size(), 0);
    m_muteUntilNs = INT64_MIN;
    m_garbleUntilNs = INT64_MIN;
    for (const auto& [timeNs, event] : std::exchange(m_events, {})) {
        if (event.kind != LineEvent::Kind::Unplug)
            m_events.insert({nowNs, event});
    }
}

std::int64_t FaultyLine::scaled(std::int64_t timeNs, double factor)
{
    return static_cast<std::int64_t>(static_cast<double>(timeNs) * factor);
}

// Returns the time on the line; 0 if it is not paced.
std::int64_t FaultyLine::lengthNs(std::size_t characters) const
{
    return m_settings.paced ? m_characterNs * static_cast<std::int64_t>(characters) : 0;
}

bool FaultyLine::strikes(const FaultRule& rule, std::size_t index, std::int64_t nowNs)
{
    // Always drawn, so that a rule does not depend on the progress of another one.
    const bool byChance = rule.every == 0 && pickChance(m_random) < rule.probability;
    const bool inTurn = rule.every != 0 && m_exchanges % rule.every == 0;
    const std::int64_t ageNs = nowNs - m_loadedNs;
    return (byChance || inTurn) && m_appliedByRule[index] < rule.limit && ageNs >= rule.fromNs &&
           ageNs < rule.untilNs;
}

std::optional<FaultRule> FaultyLine::strike(std::int64_t nowNs)
{
    ++m_exchanges;
    std::optional<std::size_t> first;
    for (std::size_t index = 0; index < m_script.rules.size(); ++index) {
        if (strikes(m_script.rules[index], index, nowNs) && !first)
            first = index;
    }
    if (!first)
        return std::nullopt;
    ++m_appliedByRule[*first];
    ++m_applied;
    return m_script.rules[*first];
}

void FaultyLine::fromPanel(std::span<const std::uint8_t> bytes, std::int64_t nowNs)
{
    putOnLine(nowNs);
    const bool isNew = m_requestEndNs == INT64_MIN || nowNs >= m_requestEndNs + m_gapNs;
    m_requestEndNs = std::max(nowNs, m_requestEndNs) + lengthNs(bytes.size());
    if (nowNs < m_muteUntilNs)
        m_requestPasses = false;
    else if (isNew)
        beginExchange(bytes, nowNs);
    else if (m_requestPasses)
        toController({bytes.begin(), bytes.end()}, m_lastFrame, nowNs);
    putOnLine(nowNs);
}

void FaultyLine::beginExchange(std::span<const std::uint8_t> bytes, std::int64_t nowNs)
{
    m_open.push_back({++m_lastFrame, {bytes.begin(), bytes.end()}, std::nullopt});
    if (m_open.size() > openExchanges)
        m_open.pop_front();
    Exchange& exchange = m_open.back();
    m_requestPasses = true;
    if (m_busyLeft > 0) {
        --m_busyLeft;
        m_requestPasses = false;
        toPanel(exceptionTo(bytes, busyCode), m_requestEndNs + m_gapNs);
        return;
    }
    exchange.fault = strike(nowNs);
    if (exchange.fault) {
        putRequest(*exchange.fault, exchange, nowNs);
        return;
    }
    const bool isGarbled = nowNs < m_garbleUntilNs && m_garbledPart != FaultPart::Answer;
    toController(isGarbled ? garbled(bytes, m_random) : exchange.request, exchange.frame, nowNs);
}

void FaultyLine::putRequest(const FaultRule& rule, const Exchange& exchange, std::int64_t nowNs)
{
    const FrameBytes& request = exchange.request;
    switch (rule.kind) {
    case FaultKind::LostRequest:
        m_requestPasses = false;
        break;
    case FaultKind::DuplicateRequest:
        toController(request, exchange.frame, nowNs);
        toController(request, exchange.frame, m_toControllerEndNs + 2 * m_gapNs);
        break;
    case FaultKind::Echo:
        toPanel(request, nowNs);
        toController(request, exchange.frame, nowNs);
        break;
    case FaultKind::Busy:
        m_busyLeft = rule.answers - 1;
        m_requestPasses = false;
        toPanel(exceptionTo(request, busyCode), m_requestEndNs + m_gapNs);
        break;
    case FaultKind::Silence:
    case FaultKind::Restart:
        m_muteUntilNs = nowNs + rule.timeNs;
        m_requestPasses = false;
        if (rule.kind == FaultKind::Restart)
            m_events.insert({m_muteUntilNs, {LineEvent::Kind::Restart, {}}});
        break;
    case FaultKind::WrongBaud:
        m_garbleUntilNs = nowNs + rule.timeNs;
        m_garbledPart = rule.part;
        toController(strikesRequest(rule) ? garbled(request, m_random) : request, exchange.frame, nowNs);
        break;
    case FaultKind::SecondMaster:
        if (rule.when == FaultMoment::Before)
            secondMaster(exchange, nowNs);
        toController(request, exchange.frame, nowNs);
        break;
    default:
        putDamagedRequest(rule, exchange, nowNs);
        break;
    }
}

void FaultyLine::putDamagedRequest(const FaultRule& rule, const Exchange& exchange, std::int64_t nowNs)
{
    FrameBytes request = exchange.request;
    std::int64_t startNs = nowNs;
    const auto cutOff = [&request](std::size_t count) {
        FrameBytes rest(request.begin() + static_cast<std::ptrdiff_t>(count), request.end());
        request.resize(count);
        return rest;
    };
    if (rule.kind == FaultKind::Unplug && rule.when == FaultMoment::Request) {
        static_cast<void>(cutOff(request.size() / 2));
        unplug(rule, nowNs + lengthNs(request.size()));
    } else if (!strikesRequest(rule)) {
        // The fault affects the answer.
    } else if (rule.kind == FaultKind::Late) {
        startNs += scaled(m_script.timeoutNs, rule.times);
    } else if (rule.kind == FaultKind::Noise) {
        toController(randomBytes(m_random, rule.bytes), 0, nowNs);
    } else if (rule.kind == FaultKind::Gap) {
        FrameBytes rest = cutOff(1 + pickBelow(m_random, request.size() - 1));
        toController(std::exchange(request, std::move(rest)), exchange.frame, nowNs);
        startNs = m_toControllerEndNs + scaled(m_characterNs, rule.characters);
    } else {
        m_requestPasses = rule.kind != FaultKind::Truncate;
        request = damaged(rule, exchange, std::move(request));
    }
    toController(std::move(request), exchange.frame, startNs);
}

void FaultyLine::toController(FrameBytes bytes, std::uint64_t frame, std::int64_t startNs)
{
    // The silence before is too short to end a frame: these bytes continue that frame.
    const bool goesOn = startNs < m_toControllerEndNs + m_gapNs;
    startNs = std::max(startNs, m_toControllerEndNs);
    m_toControllerEndNs = startNs + lengthNs(bytes.size());
    // Byte by byte where a piece must not look like silence: the controller sees only its end.
    if (!m_settings.paced || !goesOn) {
        m_toController.push_back({std::move(bytes), frame, startNs});
        return;
    }
    for (const std::uint8_t byte : bytes) {
        m_toController.push_back({{byte}, frame, startNs});
        startNs += m_characterNs;
    }
}

void FaultyLine::toPanel(FrameBytes bytes, std::int64_t startNs)
{
    m_toPanel.insert({startNs, std::move(bytes)});
}

void FaultyLine::putOnLine(std::int64_t nowNs)
{
    for (; !m_toController.empty() && m_toController.front().startNs <= nowNs; m_toController.pop_front()) {
        const Waiting& piece = m_toController.front();
        m_line.fromPanel(piece.bytes, piece.startNs);
        m_frames.push_back(piece.frame);
    }
    for (; !m_toPanel.empty() && m_toPanel.begin()->first <= nowNs; m_toPanel.erase(m_toPanel.begin()))
        m_line.fromController(m_toPanel.begin()->second, m_toPanel.begin()->first);
}

std::optional<FaultyLine::Arrival> FaultyLine::takeArrival(std::int64_t nowNs)
{
    putOnLine(nowNs);
    auto arrival = m_line.takeArrival(nowNs);
    if (!arrival)
        return std::nullopt;
    const std::uint64_t frame = m_frames.front();
    m_frames.pop_front();
    return Arrival{std::move(arrival->bytes), arrival->endNs, frame};
}

FrameBytes FaultyLine::takeForPanel(std::int64_t nowNs)
{
    putOnLine(nowNs);
    return m_line.takeForPanel(nowNs);
}

std::optional<LineEvent> FaultyLine::takeEvent(std::int64_t nowNs)
{
    if (m_events.empty() || m_events.begin()->first > nowNs)
        return std::nullopt;
    LineEvent event = std::move(m_events.begin()->second);
    m_events.erase(m_events.begin());
    // Bytes on a cut line, or at a controller without power, are lost.
    m_line = Line(m_settings);
    m_toController.clear();
    m_frames.clear();
    m_toPanel.clear();
    m_toControllerEndNs = INT64_MIN;
    return event;
}

std::optional<std::int64_t> FaultyLine::nextEventNs() const
{
    std::optional<std::int64_t> next = m_line.nextEventNs();
    const auto also = [&next](std::int64_t timeNs) { next = std::min(next.value_or(timeNs), timeNs); };
    if (!m_toController.empty())
        also(m_toController.front().startNs);
    if (!m_toPanel.empty())
        also(m_toPanel.begin()->first);
    if (!m_events.empty())
        also(m_events.begin()->first);
    return next;
}

} // namespace campanel::controller
