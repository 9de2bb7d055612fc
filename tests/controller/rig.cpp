// SPDX-License-Identifier: Apache-2.0
#include "rig.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace campanel::test {
namespace {

constexpr std::uint8_t unit = 1;

void append16(Bytes& bytes, std::uint16_t value)
{
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFFu));
}

void appendValues(Bytes& bytes, const Registers& values)
{
    append16(bytes, static_cast<std::uint16_t>(values.size()));
    bytes.push_back(static_cast<std::uint8_t>(2 * values.size()));
    for (const std::uint16_t value : values)
        append16(bytes, value);
}

Registers valuesOf(const Bytes& answer)
{
    Registers values;
    if (answer.size() < 5 || (answer[1] & 0x80u) != 0)
        return values;
    for (std::size_t i = 3; i + 3 < answer.size(); i += 2)
        values.push_back(static_cast<std::uint16_t>(answer[i] << 8 | answer[i + 1]));
    return values;
}

} // namespace

bool MemoryFlash::read(std::uint32_t slot, std::uint32_t offset, std::span<std::uint8_t> bytes)
{
    const Bytes& source = contents.at(slot);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = offset + i < source.size() ? source[offset + i] : 0xFF;
    return true;
}

bool MemoryFlash::erase(std::uint32_t slot)
{
    if (bytesUntilPowerCut && (*bytesUntilPowerCut)-- == 0)
        return false;
    ++written;
    contents.at(slot).clear();
    return true;
}

bool MemoryFlash::keep(std::uint32_t record, std::span<const std::uint8_t> bytes)
{
    records.at(record).assign(bytes.begin(), bytes.end());
    return true;
}

std::size_t MemoryFlash::kept(std::uint32_t record, std::span<std::uint8_t> bytes)
{
    const Bytes& kept = records.at(record);
    std::copy_n(kept.begin(), std::min(kept.size(), bytes.size()), bytes.begin());
    return kept.size();
}

bool MemoryFlash::write(std::uint32_t slot, std::uint32_t offset, std::span<const std::uint8_t> bytes)
{
    Bytes& target = contents.at(slot);
    for (const std::uint8_t byte : bytes) {
        if (bytesUntilPowerCut && (*bytesUntilPowerCut)-- == 0) {
            bytesUntilPowerCut = 0;
            return false;
        }
        target.resize(std::max<std::size_t>(target.size(), offset + 1), 0xFF);
        target[offset++] = byte;
        ++written;
    }
    return true;
}

ctl_config benchConfig()
{
    ctl_config config{};
    config.unit = unit;
    config.frame_gap_us = 1750;
    config.firmware[0] = 9;
    config.firmware[1] = 8;
    config.firmware[2] = 7;
    config.unique_id = 0x0123456789ABCDEFu;
    config.timer_clock_hz = 8'000'000;
    config.timer_bits = 16;
    config.max_pulse_hz = 200'000;
    return config;
}

Bytes frame(Bytes content)
{
    std::uint16_t crc = 0xFFFF;
    for (const std::uint8_t byte : content) {
        crc = static_cast<std::uint16_t>(crc ^ byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = static_cast<std::uint16_t>((crc & 1u) != 0 ? (crc >> 1) ^ 0xA001u : crc >> 1);
    }
    content.push_back(static_cast<std::uint8_t>(crc & 0xFFu));
    content.push_back(static_cast<std::uint8_t>(crc >> 8));
    return content;
}

std::uint32_t crc32(const Registers& registers)
{
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const std::uint16_t value : registers) {
        for (const int shift : {8, 0}) {
            crc ^= static_cast<std::uint32_t>(value >> shift) & 0xFFu;
            for (int bit = 0; bit < 8; ++bit)
                crc = (crc & 1u) != 0 ? (crc >> 1) ^ 0xEDB88320u : crc >> 1;
        }
    }
    return ~crc;
}

Rig::Rig(const controller::MachineOptions& options, MemoryFlash* flash)
    : m_controller(benchConfig(), options, flash != nullptr ? *flash : m_ownFlash)
{
}

Bytes Rig::exchange(const Bytes& raw)
{
    ctl_receive(&core(), raw.data(), raw.size(), m_controller.nowUs());
    run(2000);
    Bytes answer(CTL_FRAME_BYTES);
    answer.resize(ctl_take_answer(&core(), answer.data()));
    return answer;
}

Registers Rig::read(std::uint16_t address, std::uint16_t count)
{
    Bytes request{unit, 3};
    append16(request, address);
    append16(request, count);
    return valuesOf(exchange(frame(request)));
}

int Rig::write(std::uint16_t address, const Registers& values)
{
    Bytes request{unit, 16};
    append16(request, address);
    appendValues(request, values);
    const Bytes answer = exchange(frame(request));
    if (answer.size() < 5)
        throw std::runtime_error("no answer to a write");
    return (answer[1] & 0x80u) != 0 ? answer[2] : 0;
}

Registers Rig::readWrite(std::uint16_t readAddress, std::uint16_t readCount, std::uint16_t writeAddress,
                         const Registers& values)
{
    Bytes request{unit, 23};
    append16(request, readAddress);
    append16(request, readCount);
    append16(request, writeAddress);
    appendValues(request, values);
    return valuesOf(exchange(frame(request)));
}

std::uint32_t Rig::statusWide(std::uint16_t address)
{
    const Registers words = read(address, 2);
    return static_cast<std::uint32_t>(words.at(0)) << 16 | words.at(1);
}

std::uint16_t Rig::command(std::uint16_t code, std::uint16_t argument0, std::uint16_t argument1,
                           std::uint32_t argument2)
{
    ++m_counter;
    Registers result =
        readWrite(CTL_REG_RESULT_COUNTER, 4, CTL_REG_COMMAND_COUNTER,
                  {m_counter, code, argument0, argument1, static_cast<std::uint16_t>(argument2 >> 16),
                   static_cast<std::uint16_t>(argument2 & 0xFFFFu)});
    while (result.size() == 4 && result[2] == CTL_COMMAND_STATUS_BUSY)
        result = read(CTL_REG_RESULT_COUNTER, 4);
    if (result.size() != 4 || result[0] != m_counter || result[1] != code)
        throw std::runtime_error("the command was not echoed");
    if ((result[2] == CTL_COMMAND_STATUS_DONE) != (result[3] == CTL_REFUSAL_NONE))
        throw std::runtime_error("status and reason contradict each other");
    return result[3];
}

Registers Rig::transfer(std::uint16_t session, std::uint16_t operation, std::uint16_t block,
                        const Registers& data)
{
    Registers values{session, operation, block, static_cast<std::uint16_t>(data.size())};
    values.insert(values.end(), data.begin(), data.end());
    return readWrite(CTL_REG_TRANSFER_RESULT_SESSION, 8, CTL_REG_TRANSFER_SESSION, values);
}

std::uint16_t Rig::download(const Registers& image, std::uint16_t session, std::optional<std::uint16_t> kind)
{
    const auto size = static_cast<std::uint16_t>(image.size());
    transfer(session, CTL_TRANSFER_OPERATION_BEGIN, 0,
             {kind.value_or(image.at(CTL_OFFSET_BANK_KIND)), size, CTL_MAP_MAJOR});
    for (std::size_t first = 0; first < image.size(); first += CTL_BLOCK_REGISTERS) {
        const std::size_t last = std::min<std::size_t>(image.size(), first + CTL_BLOCK_REGISTERS);
        transfer(session, CTL_TRANSFER_OPERATION_BLOCK,
                 static_cast<std::uint16_t>(first / CTL_BLOCK_REGISTERS),
                 Registers(image.begin() + static_cast<std::ptrdiff_t>(first),
                           image.begin() + static_cast<std::ptrdiff_t>(last)));
    }
    std::uint16_t result = CTL_TRANSFER_RESULT_BUSY;
    while (result == CTL_TRANSFER_RESULT_BUSY)
        result = transfer(session, CTL_TRANSFER_OPERATION_SEAL, 0, {}).at(3);
    return result;
}

std::uint16_t Rig::apply(const Registers& image, std::uint16_t mode, std::uint16_t session)
{
    return command(CTL_COMMAND_APPLY_STAGED, mode, session, crc32(image));
}

void Rig::install(const Registers& image, std::uint16_t session)
{
    if (download(image, session) != CTL_TRANSFER_RESULT_ACCEPTED ||
        apply(image, CTL_APPLY_MODE_WHEN_STOPPED, session) != CTL_REFUSAL_NONE)
        throw std::runtime_error("the program was refused");
}

void Rig::start()
{
    if (command(CTL_COMMAND_START) != CTL_REFUSAL_NONE || !runUntilState(CTL_STATE_RUNNING))
        throw std::runtime_error("the program does not run");
}

void Rig::heartbeat(std::uint16_t jog, std::optional<std::uint16_t> permit)
{
    ++m_heartbeat;
    Registers written{m_heartbeat, m_heartbeat, jog};
    if (permit)
        written.push_back(*permit);
    write(CTL_REG_EXCHANGE_TAG, written);
}

void Rig::setParameter(std::uint16_t address, std::uint16_t value)
{
    if (write(address, {value}) != 0)
        throw std::runtime_error("the parameter was refused");
}

void Rig::run(std::uint64_t timeUs)
{
    m_controller.runTo(m_controller.nowUs() + timeUs);
}

bool Rig::runUntilState(std::uint16_t state, std::uint64_t timeoutUs)
{
    const std::uint64_t endUs = m_controller.nowUs() + timeoutUs;
    while (core().motion.state != state && m_controller.nowUs() < endUs)
        m_controller.step();
    return core().motion.state == state;
}

std::int64_t Rig::maxJolt(std::uint64_t timeUs)
{
    std::int64_t position = core().motion.commanded;
    std::optional<std::int64_t> speed;
    std::int64_t largest = 0;
    for (const std::uint64_t endUs = m_controller.nowUs() + timeUs; m_controller.nowUs() < endUs;) {
        m_controller.step();
        const std::int64_t moved = core().motion.commanded - position;
        position = core().motion.commanded;
        largest = std::max(largest, std::abs(moved - speed.value_or(moved)));
        speed = moved;
    }
    return largest;
}

} // namespace campanel::test
