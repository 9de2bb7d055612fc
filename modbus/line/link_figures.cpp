// SPDX-License-Identifier: Apache-2.0
// Counts, and exports the figures as CSV.
#include "modbus/line/link_figures.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

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

// Returns "2026-01-31T12:34Z".
std::string minuteText(std::int64_t minute)
{
    const std::time_t seconds = minute * 60;
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%MZ", &parts);
    return text;
}

std::string fixed(double value, int digits)
{
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string msText(std::int64_t us)
{
    return fixed(static_cast<double>(us) / 1000.0, 3);
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

std::string figuresCsv(const LinkFigures& figures)
{
    std::string text = "figure,value\n";
    const auto line = [&text](std::string_view key, const std::string& value) {
        text.append(key).append(",").append(value).append("\n");
    };
    line("requests", std::to_string(figures.requests()));
    line("answers", std::to_string(figures.answers()));
    for (std::size_t i = 0; i < countedErrors.size(); ++i)
        line(errorId(countedErrors[i]), std::to_string(figures.errors()[i]));
    line("retries", std::to_string(figures.retries()));
    line("drains", std::to_string(figures.drains()));
    line("sent_bytes", std::to_string(figures.sentBytes()));
    line("received_bytes", std::to_string(figures.receivedBytes()));
    line("dropped_bytes", std::to_string(figures.droppedBytes()));
    line("stray_bytes", std::to_string(figures.strayBytes()));
    const LatencyHistogram& latency = figures.latency();
    const bool isMeasured = latency.count() > 0;
    const auto percentile = [&](double share) {
        return isMeasured ? msText(latency.percentile(share).count()) : std::string();
    };
    line("latency_p50_ms", percentile(0.50));
    line("latency_p95_ms", percentile(0.95));
    line("latency_p99_ms", percentile(0.99));
    line("latency_max_ms", isMeasured ? msText(latency.maximum().count()) : std::string());
    line("wire_share", figures.wireShare() ? fixed(*figures.wireShare(), 4) : std::string());
    if (const auto& controller = figures.controller()) {
        line("controller_requests", std::to_string(controller->requests));
        line("controller_crc_errors", std::to_string(controller->crcErrors));
        line("controller_frame_errors", std::to_string(controller->frameErrors));
        line("controller_exceptions", std::to_string(controller->exceptions));
    }
    return text;
}

std::string stripCsv(const LinkFigures& figures)
{
    std::string text = "minute,answers";
    for (const LinkErrorKind kind : countedErrors)
        text.append(",").append(errorId(kind));
    text += ",latency_p99_ms,latency_max_ms\n";
    for (const MinuteFigures& minute : figures.strip()) {
        text.append(minuteText(minute.minute)).append(",").append(std::to_string(minute.answers));
        for (const std::uint32_t count : minute.errors)
            text.append(",").append(std::to_string(count));
        const bool isMeasured = minute.answers > 0;
        text.append(",").append(isMeasured ? msText(minute.latencyP99Us) : std::string());
        text.append(",").append(isMeasured ? msText(minute.latencyMaxUs) : std::string()).append("\n");
    }
    return text;
}

} // namespace campanel::modbus
