// SPDX-License-Identifier: Apache-2.0
// Finds the answer to a question among the bytes of the line: takes off the echo of the question, and skips
// bytes that belong to no frame, before and between the answers. Knows no port and no time. Internal to
// modbus/.
#pragma once

#include "modbus/line/frame_log.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace campanel::modbus {

// The form of the answer to a question.
struct AnswerForm {
    int unit = 1;
    std::uint8_t function = 0;
    std::size_t bytes = 0; // of the whole frame
};

class AnswerReader {
public:
    using Bytes = std::span<const std::uint8_t>;
    // Returns true when the data of an answer (after the function) belongs to its question.
    using Proof = std::function<bool(Bytes)>;

    // A part of what was received. Its bytes are valid until the next call of the reader.
    struct Piece {
        FrameVerdict verdict = FrameVerdict::Silence;
        Bytes strays; // in front of the frame
        Bytes frame;
    };

    // `sent` is the whole frame of the question; both must live as long as the reader.
    AnswerReader(Bytes sent, const AnswerForm& form, const Proof& isMine)
        : m_sent(sent)
        , m_form(form)
        , m_isMine(isMine)
    {
    }

    // Returns the place of the next bytes; empty when more was received than any answer can have.
    [[nodiscard]] std::span<std::uint8_t> space() { return std::span(m_data).subspan(m_count); }
    // Takes so many bytes that were written to space().
    void take(std::size_t count) { m_count += count; }

    // Returns the next frame and goes behind it: Answer, Exception, Foreign or BadChecksum. Empty while the
    // answer may still come.
    [[nodiscard]] std::optional<Piece> next();
    // Returns the same when nothing more will come, or what the rest is: Foreign, BadChecksum, Incomplete,
    // Malformed or Silence.
    [[nodiscard]] Piece rest();
    // Returns the bytes behind the last piece.
    [[nodiscard]] Bytes unread() const { return Bytes(m_data).first(m_count).subspan(m_begin); }
    // Returns true when the question itself came back and was dropped.
    [[nodiscard]] bool isEchoing() const { return m_isEchoing; }

private:
    // The prospect of the bytes that are no frame yet.
    struct Prospect {
        bool isGrowing = false;  // a frame of this unit is incomplete
        bool isExpected = false; // and it may be the answer, or the echo of the question
        bool isDamaged = false;  // a whole answer has a wrong CRC-16
    };

    [[nodiscard]] std::optional<Piece> find(bool isEnd, Prospect& prospect);
    [[nodiscard]] std::optional<Piece> frameAt(std::size_t at, bool isEnd, Prospect& prospect);
    [[nodiscard]] Piece pieceAt(std::size_t at, std::size_t length, FrameVerdict verdict);
    [[nodiscard]] FrameVerdict judge(Bytes frame) const;
    [[nodiscard]] bool beginsAsked(Bytes bytes) const;
    [[nodiscard]] bool mayBeEcho(Bytes bytes) const;
    void dropEcho();

    Bytes m_sent;
    AnswerForm m_form;
    const Proof& m_isMine;
    std::array<std::uint8_t, 4 * FrameRecord::maxBytes> m_data{};
    std::size_t m_count = 0;
    std::size_t m_begin = 0; // of what is unread
    bool m_isEchoing = false;
};

// The first answers with bytes behind them are dropped: an answer that lost or gained a byte looks the same,
// and its CRC-16 is then right once in 65536. Only a line shows this again and again.
inline constexpr std::uint64_t followedAnswersDropped = 3;

// Returns the registers after the byte count of a reading answer; empty when the count does not match.
[[nodiscard]] std::vector<std::uint16_t> answeredRegisters(std::span<const std::uint8_t> data);

} // namespace campanel::modbus
