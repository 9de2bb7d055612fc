// SPDX-License-Identifier: Apache-2.0
// The instructions of a Cortex-M0+ and their cycles; see cortex_m0plus.h.
#include "cortex_m0plus.h"

#include <bit>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace campanel::board {
namespace {

constexpr std::uint32_t memoryStart = 0x20000000;
constexpr std::uint32_t memoryBytes = 264 * 1024;
constexpr std::uint32_t devices = 0x40000000; // target_m0plus.c
constexpr std::uint32_t deviceConsole = devices;
constexpr std::uint32_t deviceCycles = devices + 4;
constexpr std::uint32_t deviceNumber = devices + 8;
constexpr std::uint32_t deviceEnd = devices + 12;
constexpr int stackPointer = 13;
constexpr int link = 14;
constexpr int programCounter = 15;

constexpr std::uint32_t bits(std::uint32_t op, int from, int count)
{
    return op >> from & ((1U << count) - 1);
}

constexpr std::uint32_t extended(std::uint32_t value, int width)
{
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(value << (32 - width)) >> (32 - width));
}

} // namespace

CortexM0plus::CortexM0plus(const std::vector<std::uint8_t>& image, std::uint32_t number)
    : m_memory(memoryBytes)
    , m_number(number)
{
    if (image.size() < 8 || image.size() > m_memory.size())
        throw std::runtime_error("the program does not fit into the memory");
    std::memcpy(m_memory.data(), image.data(), image.size());
    m_r[stackPointer] = load(memoryStart, 4);
    m_at = load(memoryStart + 4, 4) & ~1U;
}

int CortexM0plus::run()
{
    while (m_isRunning)
        step();
    return m_exitCode;
}

void CortexM0plus::fail(const char* what) const
{
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%s at 0x%08X", what, m_at);
    throw std::runtime_error(text.data());
}

std::uint8_t* CortexM0plus::place(std::uint32_t address, std::uint32_t bytes)
{
    const std::uint32_t offset = address - memoryStart;
    if (offset > memoryBytes - bytes || (address & (bytes - 1)) != 0)
        fail("no such address, or not aligned,");
    return &m_memory[offset];
}

std::uint32_t CortexM0plus::load(std::uint32_t address, std::uint32_t bytes)
{
    if (address == deviceCycles)
        return static_cast<std::uint32_t>(m_cycles);
    if (address == deviceNumber)
        return m_number;
    std::uint32_t value = 0; // the host is little-endian, too
    static_assert(std::endian::native == std::endian::little);
    std::memcpy(&value, place(address, bytes), bytes);
    return value;
}

void CortexM0plus::store(std::uint32_t address, std::uint32_t bytes, std::uint32_t value)
{
    if (address == deviceConsole) {
        m_line += static_cast<char>(value);
        if (m_line.back() == '\n') {
            std::fputs(m_line.c_str(), stdout);
            m_line.clear();
        }
    } else if (address == deviceEnd) {
        m_isRunning = false;
        m_exitCode = static_cast<int>(value);
    } else {
        std::memcpy(place(address, bytes), &value, bytes);
    }
}

void CortexM0plus::step()
{
    const std::uint32_t op = load(m_at, 2);
    m_r[programCounter] = m_at + 4; // as the instruction reads it
    m_cycles += 1;                  // of most instructions; the others add theirs
    m_at += 2;
    switch (op >> 12) {
    case 0x0:
    case 0x1:
        shiftOrAdd(op);
        break;
    case 0x2:
    case 0x3:
        immediate(op);
        break;
    case 0x4:
        registersOrConstant(op);
        break;
    case 0x5:
        loadOrStoreByRegister(op);
        break;
    case 0x6:
    case 0x7:
    case 0x8:
    case 0x9:
        loadOrStoreByNumber(op);
        break;
    case 0xA: // an address beside the program or in the stack
        m_r[bits(op, 8, 3)] =
            (bits(op, 11, 1) != 0 ? m_r[stackPointer] : m_r[programCounter] & ~3U) + 4 * bits(op, 0, 8);
        break;
    case 0xB:
        miscellaneous(op);
        break;
    case 0xC:
        multiple(op);
        break;
    case 0xD:
        branch(op);
        break;
    case 0xE:
        if (bits(op, 11, 1) != 0)
            fail("unknown instruction");
        jump(m_r[programCounter] + 2 * extended(op, 11), 1);
        break;
    default:
        branchFar(op);
        break;
    }
}

void CortexM0plus::registersOrConstant(std::uint32_t op)
{
    if (bits(op, 11, 1) != 0) { // a constant beside the program
        m_r[bits(op, 8, 3)] = load((m_r[programCounter] & ~3U) + 4 * bits(op, 0, 8), 4);
        m_cycles += 1;
    } else if (bits(op, 10, 1) != 0) {
        highRegisters(op);
    } else {
        dataProcessing(op);
    }
}

std::uint32_t CortexM0plus::result(std::uint32_t value)
{
    m_n = value >> 31 != 0;
    m_z = value == 0;
    return value;
}

std::uint32_t CortexM0plus::add(std::uint32_t a, std::uint32_t b, bool carry)
{
    const std::uint64_t wide = std::uint64_t{a} + b + (carry ? 1 : 0);
    const auto sum = static_cast<std::uint32_t>(wide);
    m_c = wide >> 32 != 0;
    m_v = (~(a ^ b) & (a ^ sum)) >> 31 != 0;
    return result(sum);
}

// Shifts and sets the flags: left (0), right (1), right with the sign (2), around (3).
std::uint32_t CortexM0plus::shifted(std::uint32_t kind, std::uint32_t value, std::uint32_t by)
{
    if (by == 0)
        return result(value);
    if (kind == 0) {
        m_c = by <= 32 && (value >> (32 - by) & 1) != 0;
        return result(by < 32 ? value << by : 0);
    }
    if (kind == 3) {
        const std::uint32_t turned = std::rotr(value, static_cast<int>(by & 31));
        m_c = turned >> 31 != 0;
        return result(turned);
    }
    if (kind == 2) {
        const auto sign = static_cast<std::int32_t>(value);
        const int places = by < 32 ? static_cast<int>(by) : 32;
        m_c = (sign >> (places - 1) & 1) != 0;
        return result(static_cast<std::uint32_t>(places < 32 ? sign >> places : sign >> 31));
    }
    m_c = by <= 32 && (value >> (by - 1) & 1) != 0;
    return result(by < 32 ? value >> by : 0);
}

void CortexM0plus::jump(std::uint32_t to, std::uint64_t cycles)
{
    m_at = to & ~1U;
    m_cycles += cycles;
}

void CortexM0plus::shiftOrAdd(std::uint32_t op)
{
    std::uint32_t& target = m_r[bits(op, 0, 3)];
    const std::uint32_t source = m_r[bits(op, 3, 3)];
    const std::uint32_t kind = bits(op, 11, 2);
    if (kind != 3) {
        const std::uint32_t places = bits(op, 6, 5);
        target = shifted(kind, source, places == 0 && kind != 0 ? 32 : places);
        return;
    }
    const std::uint32_t second = bits(op, 10, 1) != 0 ? bits(op, 6, 3) : m_r[bits(op, 6, 3)];
    target = bits(op, 9, 1) != 0 ? add(source, ~second, true) : add(source, second, false);
}

void CortexM0plus::immediate(std::uint32_t op)
{
    std::uint32_t& target = m_r[bits(op, 8, 3)];
    const std::uint32_t number = bits(op, 0, 8);
    switch (bits(op, 11, 2)) {
    case 0:
        target = result(number);
        break;
    case 1:
        (void)add(target, ~number, true);
        break;
    case 2:
        target = add(target, number, false);
        break;
    default:
        target = add(target, ~number, true);
        break;
    }
}

void CortexM0plus::dataProcessing(std::uint32_t op)
{
    std::uint32_t& target = m_r[bits(op, 0, 3)];
    const std::uint32_t source = m_r[bits(op, 3, 3)];
    switch (bits(op, 6, 4)) {
    case 0x0:
        target = result(target & source);
        break;
    case 0x1:
        target = result(target ^ source);
        break;
    case 0x2:
    case 0x3:
    case 0x4:
        target = shifted(bits(op, 6, 4) - 2, target, source & 0xFF);
        break;
    case 0x5:
        target = add(target, source, m_c);
        break;
    case 0x6:
        target = add(target, ~source, m_c);
        break;
    case 0x7:
        target = shifted(3, target, source & 0xFF);
        break;
    case 0x8:
        (void)result(target & source);
        break;
    case 0x9:
        target = add(0, ~source, true);
        break;
    case 0xA:
    case 0xB:
        (void)add(target, bits(op, 6, 1) != 0 ? source : ~source, bits(op, 6, 1) == 0);
        break;
    case 0xC:
        target = result(target | source);
        break;
    case 0xD:
        target = result(target * source);
        break;
    case 0xE:
        target = result(target & ~source);
        break;
    default:
        target = result(~source);
        break;
    }
}

void CortexM0plus::highRegisters(std::uint32_t op)
{
    const std::uint32_t target = bits(op, 0, 3) + 8 * bits(op, 7, 1);
    const std::uint32_t source = m_r[bits(op, 3, 4)];
    switch (bits(op, 8, 2)) {
    case 0:
        if (target == programCounter)
            jump(m_r[programCounter] + source, 1);
        else
            m_r[target] += source;
        break;
    case 1:
        (void)add(m_r[target], ~source, true);
        break;
    case 2:
        if (target == programCounter)
            jump(source, 1);
        else
            m_r[target] = source;
        break;
    default:
        if (bits(op, 7, 1) != 0)
            m_r[link] = m_at | 1;
        jump(source, 1);
        break;
    }
}

void CortexM0plus::loadOrStoreByRegister(std::uint32_t op)
{
    const std::uint32_t address = m_r[bits(op, 3, 3)] + m_r[bits(op, 6, 3)];
    std::uint32_t& data = m_r[bits(op, 0, 3)];
    constexpr std::array<std::uint32_t, 8> sizes{4, 2, 1, 1, 4, 2, 1, 2};
    const std::uint32_t kind = bits(op, 9, 3);
    const std::uint32_t bytes = sizes[kind];
    m_cycles += 1;
    if (kind < 3)
        store(address, bytes, data);
    else if (kind == 3 || kind == 7) // with the sign
        data = extended(load(address, bytes), static_cast<int>(8 * bytes));
    else
        data = load(address, bytes);
}

void CortexM0plus::loadOrStoreByNumber(std::uint32_t op)
{
    const bool isStack = op >> 12 == 0x9;
    const std::uint32_t bytes = op >> 12 == 0x7 ? 1 : op >> 12 == 0x8 ? 2 : 4;
    const std::uint32_t address =
        isStack ? m_r[stackPointer] + 4 * bits(op, 0, 8) : m_r[bits(op, 3, 3)] + bytes * bits(op, 6, 5);
    std::uint32_t& data = m_r[isStack ? bits(op, 8, 3) : bits(op, 0, 3)];
    m_cycles += 1;
    if (bits(op, 11, 1) != 0)
        data = load(address, bytes);
    else
        store(address, bytes, data);
}

void CortexM0plus::miscellaneous(std::uint32_t op)
{
    std::uint32_t& target = m_r[bits(op, 0, 3)];
    const std::uint32_t source = m_r[bits(op, 3, 3)];
    switch (bits(op, 8, 4)) {
    case 0x0:
        m_r[stackPointer] += (bits(op, 7, 1) != 0 ? ~0U : 1U) * 4 * bits(op, 0, 7);
        break;
    case 0x2: {
        const int width = bits(op, 6, 1) != 0 ? 8 : 16;
        target = bits(op, 7, 1) != 0 ? bits(source, 0, width) : extended(source, width);
        break;
    }
    case 0x4:
    case 0x5:
        push(bits(op, 0, 9));
        break;
    case 0xA:
        if (bits(op, 6, 2) == 0)
            target = __builtin_bswap32(source);
        else if (bits(op, 6, 2) == 1)
            target = std::rotr(__builtin_bswap32(source), 16);
        else
            target = extended(std::rotr(__builtin_bswap32(source), 16) & 0xFFFF, 16);
        break;
    case 0xC:
    case 0xD:
        pop(bits(op, 0, 9));
        break;
    case 0xF: // nop
        break;
    default:
        fail("unknown instruction");
    }
}

// Bit 8 of the list is the link register.
void CortexM0plus::push(std::uint32_t list)
{
    std::uint32_t at = m_r[stackPointer] - 4 * static_cast<std::uint32_t>(std::popcount(list));
    m_r[stackPointer] = at;
    for (std::uint32_t i = 0; i < 9; ++i) {
        if (bits(list, static_cast<int>(i), 1) != 0) {
            store(at, 4, m_r[i == 8 ? link : i]);
            at += 4;
            m_cycles += 1;
        }
    }
}

// Bit 8 of the list is the program counter.
void CortexM0plus::pop(std::uint32_t list)
{
    for (std::uint32_t i = 0; i < 8; ++i) {
        if (bits(list, static_cast<int>(i), 1) != 0) {
            m_r[i] = load(m_r[stackPointer], 4);
            m_r[stackPointer] += 4;
            m_cycles += 1;
        }
    }
    if (bits(list, 8, 1) != 0) {
        jump(load(m_r[stackPointer], 4), 3);
        m_r[stackPointer] += 4;
    }
}

void CortexM0plus::multiple(std::uint32_t op)
{
    const std::uint32_t base = bits(op, 8, 3);
    std::uint32_t at = m_r[base];
    const bool isLoad = bits(op, 11, 1) != 0;
    for (std::uint32_t i = 0; i < 8; ++i) {
        if (bits(op, static_cast<int>(i), 1) == 0)
            continue;
        if (isLoad)
            m_r[i] = load(at, 4);
        else
            store(at, 4, m_r[i]);
        at += 4;
        m_cycles += 1;
    }
    if (!isLoad || bits(op, static_cast<int>(base), 1) == 0)
        m_r[base] = at;
}

bool CortexM0plus::holds(std::uint32_t condition) const
{
    bool value = false;
    switch (condition >> 1) {
    case 0:
        value = m_z;
        break;
    case 1:
        value = m_c;
        break;
    case 2:
        value = m_n;
        break;
    case 3:
        value = m_v;
        break;
    case 4:
        value = m_c && !m_z;
        break;
    case 5:
        value = m_n == m_v;
        break;
    case 6:
        value = !m_z && m_n == m_v;
        break;
    default:
        fail("unknown instruction");
    }
    return value != ((condition & 1) != 0);
}

void CortexM0plus::branch(std::uint32_t op)
{
    if (holds(bits(op, 8, 4)))
        jump(m_r[programCounter] + 2 * extended(op, 8), 1);
}

// BL; the other instructions of 32 bits are barriers and special registers, which the core does not use.
void CortexM0plus::branchFar(std::uint32_t op)
{
    const std::uint32_t second = load(m_at, 2);
    if (bits(op, 11, 5) != 0x1E || bits(second, 14, 2) != 3 || bits(second, 12, 1) != 1)
        fail("unknown instruction");
    const std::uint32_t sign = bits(op, 10, 1);
    const std::uint32_t first = ~(bits(second, 13, 1) ^ sign) & 1;
    const std::uint32_t next = ~(bits(second, 11, 1) ^ sign) & 1;
    const std::uint32_t offset =
        sign << 24 | first << 23 | next << 22 | bits(op, 0, 10) << 12 | bits(second, 0, 11) << 1;
    m_r[link] = (m_at + 2) | 1;
    jump(m_r[programCounter] + extended(offset, 25), 2);
}

} // namespace campanel::board
