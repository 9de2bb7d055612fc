// SPDX-License-Identifier: Apache-2.0
// Requests are struck as they come, answers when the controller gives them.
#include "faulty_line.h"

#include <algorithm>
#include <utility>

namespace campanel::controller {
namespace {

constexpr std::size_t openExchanges = 32;
constexpr std::uint32_t busyCode = 6;
// Idle: so much later than the end of an answer, in frame gaps.
constexpr int idleGaps = 3;
// What a second master is answered takes about so many characters.
constexpr std::size_t foreignAnswerCharacters = 100;

std::int64_t wireCharacterNs(LineSettings settings)
{
    settings.paced = true;
    return characterNs(settings);
}

bool strikesRequest(const FaultRule& rule)
{
    return rule.part != FaultPart::Answer;
}

bool strikesAnswer(const FaultRule& rule)
{
    return rule.part != FaultPart::Request;
}

std::int64_t scaled(std::int64_t timeNs, double factor)
{
    return static_cast<std::int64_t>(static_cast<double>(timeNs) * factor);
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
}

// Bytes take no time on a line that is not paced.
std::int64_t FaultyLine::lengthNs(std::size_t characters) const
{
    return m_settings.paced ? m_characterNs * static_cast<std::int64_t>(characters) : 0;
}

bool FaultyLine::strikes(const FaultRule& rule, std::size_t index, std::int64_t nowNs)
{
    // Drawn in any case, so that a rule does not depend on how far another one has come.
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
    case FaultKind::DuplicateRequest: {
        toController(request, exchange.frame, nowNs);
        const std::int64_t againNs = m_toControllerEndNs + 2 * m_gapNs;
        toController(request, exchange.frame, againNs);
        break;
    }
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
        m_muteUntilNs = nowNs + rule.timeNs;
        m_requestPasses = false;
        break;
    case FaultKind::Restart:
        m_muteUntilNs = nowNs + rule.timeNs;
        m_requestPasses = false;
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
    if (rule.kind == FaultKind::Unplug && rule.when == FaultMoment::Request) {
        request.resize(request.size() / 2);
        unplug(rule, nowNs + lengthNs(request.size()));
    } else if (strikesRequest(rule)) {
        switch (rule.kind) {
        case FaultKind::Late:
            startNs += scaled(m_script.timeoutNs, rule.times);
            break;
        case FaultKind::Truncate:
            request = truncated(request, m_random);
            m_requestPasses = false;
            break;
        case FaultKind::Corrupt:
            request = corrupted(request, rule.bits, m_random);
            break;
        case FaultKind::Trailing: {
            const FrameBytes garbage = randomBytes(m_random, rule.bytes);
            request.insert(request.end(), garbage.begin(), garbage.end());
            break;
        }
        case FaultKind::Noise:
            toController(randomBytes(m_random, rule.bytes), 0, nowNs);
            break;
        case FaultKind::Gap: {
            const std::size_t cut = 1 + pickBelow(m_random, request.size() - 1);
            toController({request.begin(), request.begin() + static_cast<std::ptrdiff_t>(cut)},
                         exchange.frame, nowNs);
            request.erase(request.begin(), request.begin() + static_cast<std::ptrdiff_t>(cut));
            startNs = m_toControllerEndNs + scaled(m_characterNs, rule.characters);
            break;
        }
        default:
            break;
        }
    }
    toController(std::move(request), exchange.frame, startNs);
}

void FaultyLine::fromController(std::span<const std::uint8_t> bytes, std::uint64_t frame, std::int64_t nowNs)
{
    putOnLine(nowNs);
    if (nowNs < m_muteUntilNs)
        return;
    FrameBytes answer(bytes.begin(), bytes.end());
    const auto exchange = std::ranges::find(m_open, frame, &Exchange::frame);
    if (nowNs < m_garbleUntilNs && m_garbledPart != FaultPart::Request)
        toPanel(garbled(answer, m_random), nowNs);
    else if (exchange == m_open.end() || !exchange->fault)
        toPanel(std::move(answer), nowNs);
    else
        putAnswer(*exchange->fault, *exchange, std::move(answer), nowNs);
    putOnLine(nowNs);
}

void FaultyLine::putAnswer(const FaultRule& rule, const Exchange& exchange, FrameBytes answer,
                           std::int64_t nowNs)
{
    const std::int64_t endNs = nowNs + lengthNs(answer.size());
    const bool struck = strikesAnswer(rule);
    switch (rule.kind) {
    case FaultKind::LostAnswer:
        return;
    case FaultKind::Late:
        toPanel(std::move(answer), nowNs + (struck ? scaled(m_script.timeoutNs, rule.times) : 0));
        return;
    case FaultKind::DuplicateAnswer:
        toPanel(answer, endNs + m_gapNs);
        break;
    case FaultKind::Truncate:
        answer = struck ? truncated(answer, m_random) : answer;
        break;
    case FaultKind::Corrupt:
        answer = struck ? corrupted(answer, rule.bits, m_random) : answer;
        break;
    case FaultKind::Trailing:
        if (struck) {
            const FrameBytes garbage = randomBytes(m_random, rule.bytes);
            answer.insert(answer.end(), garbage.begin(), garbage.end());
        }
        break;
    case FaultKind::Gap:
        if (struck) {
            const std::size_t cut = 1 + pickBelow(m_random, answer.size() - 1);
            toPanel({answer.begin() + static_cast<std::ptrdiff_t>(cut), answer.end()},
                    nowNs + lengthNs(cut) + scaled(m_characterNs, rule.characters));
            answer.resize(cut);
        }
        break;
    case FaultKind::Noise:
        if (struck)
            toPanel(randomBytes(m_random, rule.bytes), endNs + m_gapNs + rule.afterNs);
        break;
    case FaultKind::WrongUnit:
        answer = withWrongUnit(answer, m_random);
        break;
    case FaultKind::WrongFunction:
        answer = withWrongFunction(answer, m_random);
        break;
    case FaultKind::WrongCount:
        answer = withWrongCount(answer, m_random);
        break;
    case FaultKind::Exception:
        answer = exceptionTo(exchange.request, rule.code);
        break;
    case FaultKind::MapVersion:
    case FaultKind::DeviceType:
        answer = withIdentity(exchange.request, answer, rule);
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
        break;
    }
    toPanel(std::move(answer), nowNs);
}

// The panel hears its request and, as nobody tells them apart, the answer; the panel's own next request
// waits.
void FaultyLine::secondMaster(const Exchange& exchange, std::int64_t startNs)
{
    FrameBytes request = secondMasterRequest(exchange.request, m_random);
    toPanel(request, startNs);
    toController(std::move(request), 0, startNs);
    m_toControllerEndNs += lengthNs(foreignAnswerCharacters) + 3 * m_gapNs;
}

// The byte that is under way at that time is the last.
void FaultyLine::unplug(const FaultRule& rule, std::int64_t atNs)
{
    atNs += m_characterNs / 2;
    m_events.insert({atNs, {LineEvent::Kind::Unplug, {}}});
    m_events.insert({atNs + rule.timeNs, {LineEvent::Kind::Plug, rule.port}});
}

void FaultyLine::toController(FrameBytes bytes, std::uint64_t frame, std::int64_t startNs)
{
    startNs = std::max(startNs, m_toControllerEndNs);
    m_toControllerEndNs = startNs + lengthNs(bytes.size());
    // Byte by byte where a piece must not look like silence: its end is all that the controller sees.
    const std::size_t most = m_settings.paced ? 1 : bytes.size();
    if (bytes.size() <= most || m_toController.empty()) {
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
    // What is on a line that is cut, or at a controller without power, is gone.
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
