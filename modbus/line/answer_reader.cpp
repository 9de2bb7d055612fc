// SPDX-License-Identifier: Apache-2.0
#include "modbus/line/answer_reader.h"

#include "modbus/line/crc16.h"
#include "modbus/map/function_codes.h"

#include <algorithm>

namespace campanel::modbus {
namespace {

// Returns the length of the answer that begins with these bytes; 0 when no answer begins so.
std::size_t answerLength(std::span<const std::uint8_t> begin)
{
    constexpr std::size_t exceptionBytes = 5;
    if (begin.size() < 2 || (begin[1] & exceptionFlag) != 0 || begin.size() < 3)
        return exceptionBytes;
    switch (begin[1]) {
    case 1:
    case 2:
    case 3:
    case 4:
    case 23: {
        const std::size_t length = 5u + begin[2];
        return length <= FrameRecord::maxBytes ? length : 0;
    }
    case 5:
    case 6:
    case 15:
    case 16:
        return 8;
    default:
        return 0;
    }
}

// Returns true when the bytes are the question itself or its beginning. An answer that begins like its
// question has its checksum at another place.
bool mayBeEcho(std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> sent)
{
    return bytes.size() <= sent.size() && std::ranges::equal(bytes, sent.first(bytes.size())) &&
           (bytes.size() == sent.size() || !endsWithCrc16(bytes));
}

} // namespace

std::span<std::uint8_t> AnswerReader::space()
{
    return m_count < m_wanted ? std::span(m_data).subspan(m_count, m_wanted - m_count)
                              : std::span<std::uint8_t>();
}

void AnswerReader::take(std::size_t count)
{
    m_count += count;
    m_wanted = answerLength(bytes());
    if (m_isEchoing || m_count < m_wanted || !mayBeEcho(bytes(), m_sent))
        return;
    m_isEchoing = m_count == m_sent.size();
    m_wanted = m_isEchoing ? shortest : m_sent.size();
    if (m_isEchoing)
        m_count = 0;
}

FrameVerdict AnswerReader::verdict(const AnswerForm& form) const
{
    if (m_wanted == 0)
        return FrameVerdict::Malformed;
    const auto frame = bytes();
    if (!endsWithCrc16(frame))
        return FrameVerdict::BadChecksum;
    if (frame[0] != form.unit || (frame[1] & ~exceptionFlag) != form.function)
        return FrameVerdict::Foreign;
    if ((frame[1] & exceptionFlag) != 0)
        return FrameVerdict::Exception;
    return frame.size() == form.bytes ? FrameVerdict::Answer : FrameVerdict::Foreign;
}

std::vector<std::uint16_t> answeredRegisters(std::span<const std::uint8_t> data)
{
    if (data.empty() || data[0] + 1u != data.size())
        return {};
    std::vector<std::uint16_t> registers(data[0] / 2u);
    for (std::size_t i = 0; i < registers.size(); ++i)
        registers[i] = static_cast<std::uint16_t>((data[1 + 2 * i] << 8) | data[2 + 2 * i]);
    return registers;
}

} // namespace campanel::modbus
