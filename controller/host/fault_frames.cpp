// SPDX-License-Identifier: Apache-2.0
#include "fault_frames.h"

#include "base/ctl_crc.h"
#include "ctl_registers.h"

#include <algorithm>
#include <array>

namespace campanel::controller {
namespace {

enum : std::uint8_t { Read = 3, WriteOne = 6, Write = 16, ReadWrite = 23, ExceptionFlag = 0x80 };

// unit, function, byte count; then data, then CRC-16
constexpr std::size_t dataAt = 3;
constexpr std::size_t crcBytes = 2;
// The offsets in a request.
constexpr std::size_t addressAt = 2;
constexpr std::size_t countAt = 4;
constexpr std::size_t writtenAt = 11; // first register written by function 23

std::uint16_t wordAt(std::span<const std::uint8_t> frame, std::size_t offset)
{
    return offset + 1 < frame.size() ? static_cast<std::uint16_t>(frame[offset] << 8 | frame[offset + 1]) : 0;
}

void putWord(FrameBytes& frame, std::size_t offset, std::uint32_t value)
{
    frame.at(offset) = static_cast<std::uint8_t>(value >> 8 & 0xFFu);
    frame.at(offset + 1) = static_cast<std::uint8_t>(value & 0xFFu);
}

FrameBytes withCrc(FrameBytes bytes)
{
    const std::uint16_t crc = ctl_crc16(bytes.data(), bytes.size());
    bytes.push_back(static_cast<std::uint8_t>(crc & 0xFFu));
    bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
    return bytes;
}

FrameBytes withoutCrc(std::span<const std::uint8_t> frame)
{
    return {frame.begin(), frame.end() - static_cast<std::ptrdiff_t>(std::min(crcBytes, frame.size()))};
}

bool isReading(std::span<const std::uint8_t> frame)
{
    return frame.size() > dataAt + crcBytes && (frame[1] == Read || frame[1] == ReadWrite);
}

FrameBytes requestOf(std::uint8_t unit, std::uint8_t function, std::initializer_list<std::uint16_t> words)
{
    FrameBytes bytes{unit, function};
    for (const std::uint16_t word : words) {
        bytes.push_back(static_cast<std::uint8_t>(word >> 8));
        bytes.push_back(static_cast<std::uint8_t>(word & 0xFFu));
    }
    return bytes;
}

// Returns a function 23 request that writes the words to `written`.
FrameBytes exchangeOf(std::uint8_t unit, std::uint16_t read, std::uint16_t readCount, std::uint16_t written,
                      std::initializer_list<std::uint16_t> words)
{
    FrameBytes bytes =
        requestOf(unit, ReadWrite, {read, readCount, written, static_cast<std::uint16_t>(words.size())});
    bytes.push_back(static_cast<std::uint8_t>(2 * words.size()));
    const FrameBytes data = requestOf(0, 0, words);
    bytes.insert(bytes.end(), data.begin() + 2, data.end());
    return bytes;
}

} // namespace

std::size_t pickBelow(std::mt19937_64& random, std::size_t bound)
{
    return bound == 0 ? 0 : static_cast<std::size_t>(random() % bound);
}

double pickChance(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

FrameBytes randomBytes(std::mt19937_64& random, std::size_t count)
{
    FrameBytes bytes(count);
    std::ranges::generate(bytes, [&random] { return static_cast<std::uint8_t>(random() >> 56); });
    return bytes;
}

FrameBytes truncated(std::span<const std::uint8_t> frame, std::mt19937_64& random)
{
    if (frame.size() < 2)
        return {};
    const auto kept = frame.first(1 + pickBelow(random, frame.size() - 1));
    return {kept.begin(), kept.end()};
}

FrameBytes corrupted(std::span<const std::uint8_t> frame, std::uint32_t bits, std::mt19937_64& random)
{
    FrameBytes bytes(frame.begin(), frame.end());
    const std::size_t all = 8 * bytes.size();
    std::vector<std::size_t> flipped;
    while (flipped.size() < std::min<std::size_t>(bits, all)) {
        const std::size_t bit = pickBelow(random, all);
        if (std::ranges::find(flipped, bit) != flipped.end())
            continue;
        flipped.push_back(bit);
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
    }
    // Four bits and more may result in another valid frame, which would not be a line fault.
    if (!bytes.empty() && ctl_crc16(bytes.data(), bytes.size()) == 0)
        bytes.back() = static_cast<std::uint8_t>(bytes.back() ^ 1u);
    return bytes;
}

FrameBytes garbled(std::span<const std::uint8_t> frame, std::mt19937_64& random)
{
    return corrupted(randomBytes(random, 1 + frame.size() / 2 + pickBelow(random, frame.size() + 1)), 1,
                     random);
}

FrameBytes withWrongUnit(std::span<const std::uint8_t> answer, std::mt19937_64& random)
{
    FrameBytes bytes = withoutCrc(answer);
    constexpr std::size_t units = 247;
    if (!bytes.empty()) // any other unit
        bytes[0] = static_cast<std::uint8_t>((bytes[0] + pickBelow(random, units - 1)) % units + 1);
    return withCrc(std::move(bytes));
}

FrameBytes withWrongFunction(std::span<const std::uint8_t> answer, std::mt19937_64& random)
{
    constexpr std::array<std::uint8_t, 8> functions{1, 2, 3, 4, 5, 6, 16, 23};
    FrameBytes bytes = withoutCrc(answer);
    if (bytes.size() > 1) {
        const std::uint8_t before = bytes[1];
        while (bytes[1] == before)
            bytes[1] = functions[pickBelow(random, functions.size())];
    }
    return withCrc(std::move(bytes));
}

FrameBytes withWrongCount(std::span<const std::uint8_t> answer, std::mt19937_64& random)
{
    FrameBytes bytes = withoutCrc(answer);
    if (!isReading(answer)) {
        if (bytes.size() >= countAt + 2)
            putWord(bytes, countAt, wordAt(bytes, countAt) + 1u);
        return withCrc(std::move(bytes));
    }
    constexpr std::size_t maxData = 250;
    const bool longer =
        bytes.size() - dataAt < 4 || (bytes.size() - dataAt < maxData && pickBelow(random, 2) == 0);
    bytes.resize(longer ? bytes.size() + 2 : bytes.size() - 2, 0);
    bytes[2] = static_cast<std::uint8_t>(bytes.size() - dataAt);
    return withCrc(std::move(bytes));
}

FrameBytes exceptionTo(std::span<const std::uint8_t> request, std::uint32_t code)
{
    if (request.size() < 2)
        return {};
    return withCrc(
        {request[0], static_cast<std::uint8_t>(request[1] | ExceptionFlag), static_cast<std::uint8_t>(code)});
}

FrameBytes withIdentity(std::span<const std::uint8_t> request, std::span<const std::uint8_t> answer,
                        const FaultRule& rule)
{
    FrameBytes bytes = withoutCrc(answer);
    if (!isReading(answer))
        return {answer.begin(), answer.end()};
    std::size_t first = wordAt(request, addressAt);
    std::size_t offset = dataAt;
    if (first == CTL_REG_READBACK_RESULT_TAG) { // tag, address and count precede the registers
        first = wordAt(bytes, offset + 2);
        offset += 6;
    }
    const auto put = [&](std::size_t address, std::uint16_t value) {
        const std::size_t at = offset + 2 * (address - first);
        if (address >= first && at + 1 < bytes.size())
            putWord(bytes, at, value);
    };
    if (rule.kind == FaultKind::DeviceType) {
        put(CTL_REG_IDENTITY_DEVICE_TYPE, rule.type);
    } else {
        put(CTL_REG_IDENTITY_MAP_MAJOR, rule.major);
        put(CTL_REG_IDENTITY_MAP_MINOR, rule.minor);
    }
    return withCrc(std::move(bytes));
}

FrameBytes secondMasterRequest(std::span<const std::uint8_t> panelRequest, std::mt19937_64& random)
{
    const std::uint8_t unit = panelRequest.empty() ? std::uint8_t{1} : panelRequest[0];
    const std::uint8_t function = panelRequest.size() < 2 ? std::uint8_t{0} : panelRequest[1];
    const auto tag = static_cast<std::uint16_t>(random() >> 48);
    const std::uint16_t address = wordAt(panelRequest, addressAt);
    const std::uint16_t count = wordAt(panelRequest, countAt);
    if (function == Read) { // other registers, the same number
        const bool inBank = address >= CTL_REG_ACTIVE;
        const auto other = static_cast<std::uint16_t>(inBank ? CTL_REG_ACTIVE + tag % 1000u : CTL_REG_ACTIVE);
        return withCrc(requestOf(unit, Read, {other, count}));
    }
    if (function == ReadWrite && address == CTL_REG_READBACK_RESULT_TAG) {
        const std::uint16_t wanted = wordAt(panelRequest, writtenAt + 4);
        const auto other = static_cast<std::uint16_t>(CTL_REG_ACTIVE + tag % 1000u);
        return withCrc(exchangeOf(unit, address, count, CTL_REG_READBACK_TAG, {tag, other, wanted}));
    }
    if (function == ReadWrite && address == CTL_REG_STATUS_TAG)
        return withCrc(exchangeOf(unit, address, count, CTL_REG_EXCHANGE_TAG,
                                  {tag, static_cast<std::uint16_t>(random() >> 48), 0}));
    // For a command or a transfer only the result is read, with an answer as long as the panel's.
    return withCrc(requestOf(unit, Read,
                             {function == ReadWrite ? address : std::uint16_t{CTL_REG_STATUS_TAG},
                              function == ReadWrite ? count : std::uint16_t{CTL_GROUP_STATUS}}));
}

} // namespace campanel::controller
