// SPDX-License-Identifier: Apache-2.0
// The time of frames on the line, in closed form: for the timeouts of the client and the limit in the
// benchmarks. A character is start bit, 8 data bits, parity bit if any, stop bits.
#pragma once

#include "modbus/map/register_map.h"

#include <array>
#include <chrono>
#include <cstdint>

namespace campanel::modbus {

enum class Parity : char { None = 'N', Even = 'E', Odd = 'O' };

struct LineSettings {
    std::uint32_t baud = 115200;
    Parity parity = Parity::None;
    std::uint8_t stopBits = 1;
};

// The baud rates of the contract; libmodbus silently uses 9600 for an unknown rate.
inline constexpr std::array<std::uint32_t, 5> supportedBauds{9600, 19200, 38400, 57600, 115200};

// The last unit number; the first is 1, and 0 is broadcast.
inline constexpr int lastUnit = 247;

// The sizes of a request and its answer in bytes, including address and CRC-16.
struct FramePair {
    int requestBytes = 0;
    int answerBytes = 0;
};

[[nodiscard]] constexpr std::chrono::nanoseconds charactersTime(const LineSettings& line, int characters)
{
    if (line.baud == 0) // no port has it: opening refuses it
        return std::chrono::nanoseconds{0};
    const int bits = 9 + (line.parity == Parity::None ? 0 : 1) + line.stopBits;
    return std::chrono::nanoseconds{1'000'000'000LL * bits * characters / line.baud};
}

// Returns the silence that ends a frame: 3.5 characters, 1.75 ms above 19200 baud (Modbus over serial line,
// 2.5.1.1).
[[nodiscard]] constexpr std::chrono::nanoseconds frameSilence(const LineSettings& line)
{
    return line.baud > 19200 ? std::chrono::nanoseconds{1'750'000} : charactersTime(line, 7) / 2;
}

// Returns the frames of function 3.
[[nodiscard]] constexpr FramePair readFrames(int registers)
{
    return {8, 5 + 2 * registers};
}

// Returns the frames of function 16.
[[nodiscard]] constexpr FramePair writeFrames(int registers)
{
    return {9 + 2 * registers, 8};
}

// Returns the frames of function 23.
[[nodiscard]] constexpr FramePair writeReadFrames(int written, int read)
{
    return {13 + 2 * written, 5 + 2 * read};
}

inline constexpr int statusRegisters = 40;
// With the permit; a controller before map 1.5 gets one register less.
inline constexpr FramePair statusFrames = writeReadFrames(4, statusRegisters);
inline constexpr FramePair commandFrames = writeReadFrames(6, 4);

// Returns the frames of a write of `data` payload registers into the transfer window, answered by the
// transfer result.
[[nodiscard]] constexpr FramePair transferFrames(int data)
{
    return writeReadFrames(4 + data, 8);
}

// Returns the minimum time from the first byte of a request to the start of the next one. It includes both
// frames, the silence by which the controller detects the end of the request, and the silence before the next
// request.
[[nodiscard]] constexpr std::chrono::nanoseconds pairTime(const LineSettings& line, const FramePair& pair)
{
    return charactersTime(line, pair.requestBytes + pair.answerBytes) + 2 * frameSilence(line);
}

// Returns the minimum time of a whole download of `registers` registers: begin, blocks, seal and apply.
[[nodiscard]] constexpr std::chrono::nanoseconds downloadTime(const LineSettings& line, int registers)
{
    std::chrono::nanoseconds total =
        pairTime(line, transferFrames(3)) + pairTime(line, transferFrames(0)) + pairTime(line, commandFrames);
    for (int left = registers; left > 0; left -= blockRegisters)
        total += pairTime(line, transferFrames(left < blockRegisters ? left : blockRegisters));
    return total;
}

} // namespace campanel::modbus
