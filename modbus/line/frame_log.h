// SPDX-License-Identifier: Apache-2.0
// Every frame that went out and every byte that came in, as it was, in a ring of fixed size: what was dropped
// and what was no frame at all included. Adding one copies at most 256 bytes and allocates nothing.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace campanel::modbus {

enum class FrameVerdict : std::uint8_t {
    Sent,
    Answer,      // believed
    Exception,   // a refusal by the device
    Foreign,     // a whole frame, but the answer to another question: dropped
    BadChecksum, // a frame's length, but its CRC-16 is wrong
    Malformed,   // begins like no answer that a device may give
    Incomplete,  // no more came in the time allowed
    Silence,     // nothing came in the time allowed: no bytes
    Drained,     // came when nobody had asked, or after a doubt: dropped unread
    PortGone,    // the port hung up: bytes before that, if any
};

struct FrameRecord {
    // Longest frame on a serial line (Modbus over serial line, 2.5.1.1).
    static constexpr std::size_t mostBytes = 256;

    std::uint64_t number = 0;                 // 1 for the first one, counted without gaps
    std::chrono::steady_clock::time_point at; // sent, or complete
    FrameVerdict verdict = FrameVerdict::Sent;
    // Of the question that this answers, so that a frame can be read by itself; 0 registers when it read
    // none.
    std::uint16_t readAddress = 0;
    std::uint16_t readCount = 0;
    std::uint16_t length = 0;
    std::array<std::uint8_t, mostBytes> data{};

    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return std::span(data).first(length); }
    [[nodiscard]] bool isSent() const { return verdict == FrameVerdict::Sent; }
};

class FrameLog {
public:
    // 2048 frames are 0.6 MB, and 12 s of status exchanges at 115200 baud.
    explicit FrameLog(std::size_t capacity = 2048)
        : m_ring(capacity)
    {
    }

    // Takes number and time from itself; bytes beyond mostBytes become further records.
    void add(FrameVerdict verdict, std::span<const std::uint8_t> bytes, std::uint16_t readAddress = 0,
             std::uint16_t readCount = 0);

    [[nodiscard]] std::uint64_t lastNumber() const { return m_lastNumber; }
    [[nodiscard]] std::size_t capacity() const { return m_ring.size(); }
    // Those with a number above `number` that are still there, oldest first.
    [[nodiscard]] std::vector<FrameRecord> since(std::uint64_t number) const;

private:
    std::vector<FrameRecord> m_ring; // by number
    std::uint64_t m_lastNumber = 0;
};

} // namespace campanel::modbus
