// SPDX-License-Identifier: Apache-2.0
// Reads one answer off the line: finds its length in its first bytes, takes off the echo of the question,
// and says if the frame is one of the expected form. Knows no port and no time. Internal to modbus/.
#pragma once

#include "modbus/line/frame_log.h"

#include <array>
#include <cstddef>
#include <cstdint>
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
    // `sent` is the whole frame of the question and must live as long as the reader.
    explicit AnswerReader(std::span<const std::uint8_t> sent)
        : m_sent(sent)
    {
    }

    // Returns the place of the next bytes; empty when the answer has ended. Later bytes do not belong to it.
    [[nodiscard]] std::span<std::uint8_t> space();
    // Takes so many bytes that were written to space().
    void take(std::size_t count);

    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return std::span(m_data).first(m_count); }
    // Returns true when the question itself came back first and was dropped.
    [[nodiscard]] bool isEchoing() const { return m_isEchoing; }
    // Judges the answer that has ended: Malformed, BadChecksum, Foreign, Exception or Answer.
    [[nodiscard]] FrameVerdict verdict(const AnswerForm& form) const;

private:
    // The shortest answer, an exception; its first bytes give the full length.
    static constexpr std::size_t shortest = 5;

    std::span<const std::uint8_t> m_sent;
    std::array<std::uint8_t, FrameRecord::maxBytes> m_data{};
    std::size_t m_count = 0;
    std::size_t m_wanted = shortest; // 0: no answer begins so
    bool m_isEchoing = false;
};

// Returns the registers after the byte count of a reading answer; empty when the count does not match.
[[nodiscard]] std::vector<std::uint16_t> answeredRegisters(std::span<const std::uint8_t> data);

} // namespace campanel::modbus
