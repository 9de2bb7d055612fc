// SPDX-License-Identifier: Apache-2.0
#include "line.h"

#include <algorithm>

namespace campanel::controller {
namespace {

// The length of the pieces in which the panel receives an answer: short enough for a slow line, long enough
// for few wake-ups.
constexpr std::int64_t pieceNs = 1'000'000;
constexpr std::int64_t shortestGapNs = 1'750'000;
constexpr std::uint32_t shortestGapBaud = 19200;
constexpr std::int64_t unpacedGapNs = 100'000;

} // namespace

std::int64_t characterNs(const LineSettings& settings)
{
    if (!settings.paced)
        return 0;
    const std::uint32_t bits = 1 + 8 + (settings.parity == 'N' ? 0 : 1) + settings.stopBits;
    return bits * nsPerS / settings.baud;
}

std::int64_t frameGapNs(const LineSettings& settings)
{
    if (!settings.paced)
        return unpacedGapNs;
    return settings.baud > shortestGapBaud ? shortestGapNs : characterNs(settings) * 7 / 2;
}

Line::Line(const LineSettings& settings)
    : m_characterNs(characterNs(settings))
{
    m_pieceBytes = m_characterNs == 0
                       ? SIZE_MAX
                       : static_cast<std::size_t>(std::max<std::int64_t>(1, pieceNs / m_characterNs));
}

void Line::fromPanel(std::span<const std::uint8_t> bytes, std::int64_t nowNs)
{
    m_toControllerEndNs =
        std::max(nowNs, m_toControllerEndNs) + m_characterNs * static_cast<std::int64_t>(bytes.size());
    m_toController.push_back({{bytes.begin(), bytes.end()}, m_toControllerEndNs});
}

std::optional<Line::Arrival> Line::takeArrival(std::int64_t nowNs)
{
    if (m_toController.empty() || m_toController.front().endNs > nowNs)
        return std::nullopt;
    Arrival arrival = std::move(m_toController.front());
    m_toController.pop_front();
    return arrival;
}

void Line::fromController(std::span<const std::uint8_t> bytes, std::int64_t nowNs)
{
    m_toPanelEndNs = std::max(nowNs, m_toPanelEndNs);
    while (!bytes.empty()) {
        const auto piece = bytes.first(std::min(m_pieceBytes, bytes.size()));
        m_toPanelEndNs += m_characterNs * static_cast<std::int64_t>(piece.size());
        m_toPanel.push_back({{piece.begin(), piece.end()}, m_toPanelEndNs});
        bytes = bytes.subspan(piece.size());
    }
}

std::vector<std::uint8_t> Line::takeForPanel(std::int64_t nowNs)
{
    std::vector<std::uint8_t> bytes;
    while (!m_toPanel.empty() && m_toPanel.front().endNs <= nowNs) {
        bytes.insert(bytes.end(), m_toPanel.front().bytes.begin(), m_toPanel.front().bytes.end());
        m_toPanel.pop_front();
    }
    return bytes;
}

std::optional<std::int64_t> Line::nextEventNs() const
{
    std::optional<std::int64_t> next;
    if (!m_toController.empty())
        next = m_toController.front().endNs;
    if (!m_toPanel.empty())
        next = std::min(next.value_or(INT64_MAX), m_toPanel.front().endNs);
    return next;
}

} // namespace campanel::controller
