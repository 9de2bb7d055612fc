// SPDX-License-Identifier: Apache-2.0
#include "modbus/line/answer_reader.h"

#include "modbus/line/crc16.h"
#include "modbus/map/function_codes.h"

#include <algorithm>
#include <cstddef>

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

} // namespace

std::optional<AnswerReader::Piece> AnswerReader::next()
{
    Prospect prospect;
    if (auto piece = find(false, prospect))
        return piece;
    if (!prospect.isDamaged || prospect.isExpected)
        return std::nullopt;
    return pieceAt(m_begin, m_count - m_begin, FrameVerdict::BadChecksum);
}

AnswerReader::Piece AnswerReader::rest()
{
    Prospect prospect;
    if (const auto piece = find(true, prospect))
        return *piece;
    FrameVerdict verdict = FrameVerdict::Malformed;
    const std::size_t length = answerLength(unread());
    if (unread().empty())
        verdict = FrameVerdict::Silence;
    else if (prospect.isDamaged)
        verdict = FrameVerdict::BadChecksum;
    else if (length == unread().size() && endsWithCrc16(unread()))
        verdict = FrameVerdict::Foreign; // of another unit
    else if (prospect.isExpected)
        verdict = FrameVerdict::Incomplete;
    return pieceAt(m_begin, m_count - m_begin, verdict);
}

std::optional<AnswerReader::Piece> AnswerReader::find(bool isEnd, Prospect& prospect)
{
    dropEcho();
    for (std::size_t at = m_begin; at < m_count; ++at) {
        if (auto piece = frameAt(at, isEnd, prospect))
            return piece;
    }
    return std::nullopt;
}

// The answer counts wherever it stands. An exception or another's frame is short, or of any length: bytes of
// an answer that is still incomplete could look like one, so it counts only when nothing before it may grow.
std::optional<AnswerReader::Piece> AnswerReader::frameAt(std::size_t at, bool isEnd, Prospect& prospect)
{
    const Bytes bytes = Bytes(m_data).first(m_count).subspan(at);
    if (bytes[0] != m_form.unit)
        return std::nullopt;
    const std::size_t length = answerLength(bytes);
    const bool isWhole = length != 0 && bytes.size() >= length;
    if (isWhole && endsWithCrc16(bytes.first(length))) {
        const FrameVerdict verdict = judge(bytes.first(length));
        if (verdict == FrameVerdict::Answer || isEnd || !prospect.isGrowing)
            return pieceAt(at, length, verdict);
        return std::nullopt;
    }
    const bool isEcho = mayBeEcho(bytes);
    const bool isAnswer = beginsAsked(bytes);
    prospect.isDamaged = prospect.isDamaged || (isWhole && isAnswer && !isEcho);
    prospect.isExpected = prospect.isExpected || isEcho || (isAnswer && !isWhole);
    prospect.isGrowing = prospect.isGrowing || isEcho || (length != 0 && !isWhole);
    return std::nullopt;
}

AnswerReader::Piece AnswerReader::pieceAt(std::size_t at, std::size_t length, FrameVerdict verdict)
{
    const Bytes bytes(m_data);
    const Piece piece{verdict, bytes.subspan(m_begin, at - m_begin), bytes.subspan(at, length)};
    m_begin = at + length;
    return piece;
}

// Judges a whole frame of this unit.
FrameVerdict AnswerReader::judge(Bytes frame) const
{
    if (frame[1] == (m_form.function | exceptionFlag))
        return FrameVerdict::Exception;
    const bool isAnswer = frame[1] == m_form.function && frame.size() == m_form.bytes &&
                          m_isMine(frame.subspan(2, frame.size() - 4));
    return isAnswer ? FrameVerdict::Answer : FrameVerdict::Foreign;
}

// Returns true when the answer, or an exception in its place, begins so.
bool AnswerReader::beginsAsked(Bytes bytes) const
{
    if (bytes.size() < 2)
        return true;
    const bool isException = bytes[1] == (m_form.function | exceptionFlag);
    return isException ||
           (bytes[1] == m_form.function && (bytes.size() < 3 || answerLength(bytes) == m_form.bytes));
}

// Returns true when the bytes are the beginning of the question.
bool AnswerReader::mayBeEcho(Bytes bytes) const
{
    return !m_isEchoing && bytes.size() < m_sent.size() &&
           std::ranges::equal(bytes, m_sent.first(bytes.size()));
}

void AnswerReader::dropEcho()
{
    if (m_isEchoing)
        return;
    const auto received = std::span(m_data).first(m_count).subspan(m_begin);
    const auto echo = std::search(received.begin(), received.end(), m_sent.begin(), m_sent.end());
    if (m_sent.empty() || echo == received.end())
        return;
    std::copy(echo + static_cast<std::ptrdiff_t>(m_sent.size()), received.end(), echo);
    m_count -= m_sent.size();
    m_isEchoing = true;
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
