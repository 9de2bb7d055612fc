// SPDX-License-Identifier: Apache-2.0
#include "modbus/line/link_figures.h"

#include <algorithm>

namespace campanel::modbus {
namespace {

using std::chrono::nanoseconds;

std::size_t indexOf(LinkErrorKind kind)
{
    return static_cast<std::size_t>(std::ranges::find(countedErrors, kind) - countedErrors.begin());
}

std::uint32_t grownBy(std::uint16_t before, std::uint16_t now)
{
    return static_cast<std::uint16_t>(now - before);
}

} // namespace

MinuteFigures& LinkFigures::minuteAt(WallTime at)
{
    const std::int64_t now =
        std::max<std::int64_t>(0, std::chrono::floor<std::chrono::minutes>(at.time_since_epoch()).count());
    MinuteFigures& slot = m_strip[static_cast<std::size_t>(now % stripMinutes)];
    if (slot.minute != now) {
        slot = {};
        slot.minute = now;
        m_latencyOfMinute = {};
    }
    // A clock that was set back leaves minutes of the future behind: they are not returned.
    m_minute = now;
    return slot;
}

void LinkFigures::noteRequest(int bytes, bool isRetry)
{
    ++m_requests;
    m_sentBytes += static_cast<std::uint64_t>(bytes);
    m_retries += isRetry ? 1 : 0;
}

void LinkFigures::noteAnswer(nanoseconds latency, nanoseconds wire, nanoseconds spent, WallTime at)
{
    ++m_answers;
    m_latency.note(latency);
    m_wireTime += wire;
    m_spentTime += spent;
    MinuteFigures& minute = minuteAt(at);
    ++minute.answers;
    m_latencyOfMinute.note(latency);
    minute.latencyP99Us = static_cast<std::uint32_t>(m_latencyOfMinute.percentile(0.99).count());
    minute.latencyMaxUs = static_cast<std::uint32_t>(m_latencyOfMinute.maximum().count());
}

void LinkFigures::noteError(LinkErrorKind kind, nanoseconds spent, WallTime at)
{
    const std::size_t index = indexOf(kind);
    if (index >= m_errors.size())
        return;
    m_spentTime += spent;
    ++m_errors[index];
    ++minuteAt(at).errors[index];
}

void LinkFigures::noteDrain(int droppedBytes)
{
    ++m_drains;
    m_droppedBytes += static_cast<std::uint64_t>(droppedBytes);
    m_receivedBytes += static_cast<std::uint64_t>(droppedBytes);
}

void LinkFigures::noteStrays(std::size_t bytes)
{
    m_strayBytes += bytes;
    m_receivedBytes += bytes;
}

void LinkFigures::noteFollowedAnswer(std::size_t strayBytes)
{
    ++m_followedAnswers;
    noteStrays(strayBytes);
}

void LinkFigures::noteController(const StatusBlock& status)
{
    const Raw raw{status.linkCrcErrors, status.linkFrameErrors, status.linkExceptions, status.linkRequests,
                  status.uptimeS};
    if (!m_controller)
        m_controller.emplace();
    else if (m_lastRaw) {
        // The counters begin at zero after a restart.
        const Raw before = raw.uptimeS < m_lastRaw->uptimeS ? Raw{} : *m_lastRaw;
        m_controller->crcErrors += grownBy(before.crcErrors, raw.crcErrors);
        m_controller->frameErrors += grownBy(before.frameErrors, raw.frameErrors);
        m_controller->exceptions += grownBy(before.exceptions, raw.exceptions);
        m_controller->requests += grownBy(before.requests, raw.requests);
    }
    m_lastRaw = raw;
}

std::uint32_t LinkFigures::errors(LinkErrorKind kind) const
{
    const std::size_t index = indexOf(kind);
    return index < m_errors.size() ? m_errors[index] : 0;
}

std::optional<double> LinkFigures::wireShare() const
{
    if (m_spentTime <= nanoseconds{0})
        return std::nullopt;
    return static_cast<double>(m_wireTime.count()) / static_cast<double>(m_spentTime.count());
}

std::vector<MinuteFigures> LinkFigures::strip() const
{
    std::vector<MinuteFigures> result;
    if (m_minute < 0)
        return result;
    result.reserve(stripMinutes);
    for (std::int64_t minute = m_minute - stripMinutes + 1; minute <= m_minute; ++minute) {
        // A computer whose clock is not set has minutes before its first one.
        const MinuteFigures* slot =
            minute < 0 ? nullptr : &m_strip[static_cast<std::size_t>(minute % stripMinutes)];
        if (slot != nullptr && slot->minute == minute) {
            result.push_back(*slot);
        } else {
            result.emplace_back();
            result.back().minute = minute;
        }
    }
    return result;
}

} // namespace campanel::modbus
