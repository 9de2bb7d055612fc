// SPDX-License-Identifier: Apache-2.0
#include "modbus/line/frame_log.h"

#include <algorithm>

namespace campanel::modbus {

void FrameLog::add(FrameVerdict verdict, std::span<const std::uint8_t> bytes, std::uint16_t readAddress,
                   std::uint16_t readCount)
{
    const auto now = std::chrono::steady_clock::now();
    do {
        const auto piece = bytes.first(std::min(bytes.size(), FrameRecord::maxBytes));
        FrameRecord& record = m_ring[++m_lastNumber % m_ring.size()];
        record.number = m_lastNumber;
        record.at = now;
        record.verdict = verdict;
        record.readAddress = readAddress;
        record.readCount = readCount;
        record.length = static_cast<std::uint16_t>(piece.size());
        std::ranges::copy(piece, record.data.begin());
        bytes = bytes.subspan(piece.size());
    } while (!bytes.empty());
}

std::vector<FrameRecord> FrameLog::since(std::uint64_t number) const
{
    const std::uint64_t oldest = m_lastNumber > m_ring.size() ? m_lastNumber - m_ring.size() : 0;
    std::vector<FrameRecord> result;
    for (std::uint64_t i = std::max(number, oldest) + 1; i <= m_lastNumber; ++i)
        result.push_back(m_ring[i % m_ring.size()]);
    return result;
}

} // namespace campanel::modbus
