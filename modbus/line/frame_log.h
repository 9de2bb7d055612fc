// SPDX-License-Identifier: Apache-2.0
// Every frame sent and every byte received, unchanged, in a ring of fixed size, including dropped bytes and
// incomplete frames. Adding a record copies at most 256 bytes and allocates nothing.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace campanel::modbus {

enum class FrameVerdict : std::uint8_t {
    Sent,
    Answer,      // accepted
    Exception,   // an exception from the device
    Foreign,     // a complete frame, but the answer to another question: dropped
    BadChecksum, // the length of a frame, but a wrong CRC-16
    Malformed,   // not the start of a valid answer
    Incomplete,  // incomplete within the time allowed
    Silence,     // no bytes within the time allowed
    Stray,       // bytes before, between or behind answers that belong to no frame: skipped
    Drained,     // received without a question, or after a doubt: dropped unread
    PortGone,    // the port hung up: bytes before that, if any
};

struct FrameRecord {
    // The maximum length of a frame on a serial line (Modbus over serial line, 2.5.1.1).
    static constexpr std::size_t maxBytes = 256;

    std::uint64_t number = 0;                 // from 1, without gaps
    std::chrono::steady_clock::time_point at; // time when it was sent, or complete
    FrameVerdict verdict = FrameVerdict::Sent;
    // The range of the question that this frame answers, so that a frame can be decoded on its own; 0
    // registers when it read none.
    std::uint16_t readAddress = 0;
    std::uint16_t readCount = 0;
    std::uint16_t length = 0;
    std::array<std::uint8_t, maxBytes> data{};

    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return std::span(data).first(length); }
    [[nodiscard]] bool isSent() const { return verdict == FrameVerdict::Sent; }
};

class FrameLog {
public:
    // Creates a ring. 2048 frames are 0.6 MB, and 12 s of status exchanges at 115200 baud.
    explicit FrameLog(std::size_t capacity = 2048)
        : m_ring(capacity)
    {
    }

    // Adds a record with the next number and the present time; bytes beyond maxBytes become further records.
    void add(FrameVerdict verdict, std::span<const std::uint8_t> bytes, std::uint16_t readAddress = 0,
             std::uint16_t readCount = 0);

    [[nodiscard]] std::uint64_t lastNumber() const { return m_lastNumber; }
    [[nodiscard]] std::size_t capacity() const { return m_ring.size(); }
    // Returns the remaining records with a number above `number`, oldest first.
    [[nodiscard]] std::vector<FrameRecord> since(std::uint64_t number) const;

private:
    std::vector<FrameRecord> m_ring; // by number
    std::uint64_t m_lastNumber = 0;
};

} // namespace campanel::modbus
