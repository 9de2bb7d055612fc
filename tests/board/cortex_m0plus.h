// SPDX-License-Identifier: Apache-2.0
// A Cortex-M0+ with its cycles, to run a bench of the core from memory: ARMv6-M as far as a compiler uses it,
// the cycles of ARM's technical reference manual (DDI 0484C, table 3-1) with the single-cycle multiplier that
// the RP2040 has, and memory without wait states. It has no interrupts.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace campanel::board {

class CortexM0plus {
public:
    // The image is loaded at the beginning of the memory and starts with the stack pointer and the entry.
    CortexM0plus(const std::vector<std::uint8_t>& image, std::uint32_t number);

    // Runs until the program ends itself, and prints what it prints. Returns its exit code; throws
    // std::runtime_error at an instruction or an address that does not exist.
    int run();

private:
    void step();
    void registersOrConstant(std::uint32_t op);
    void push(std::uint32_t list);
    void pop(std::uint32_t list);
    void shiftOrAdd(std::uint32_t op);
    void immediate(std::uint32_t op);
    void dataProcessing(std::uint32_t op);
    void highRegisters(std::uint32_t op);
    void loadOrStoreByRegister(std::uint32_t op);
    void loadOrStoreByNumber(std::uint32_t op);
    void miscellaneous(std::uint32_t op);
    void multiple(std::uint32_t op);
    void branch(std::uint32_t op);
    void branchFar(std::uint32_t op);
    [[noreturn]] void fail(const char* what) const;

    [[nodiscard]] bool holds(std::uint32_t condition) const;
    std::uint32_t add(std::uint32_t a, std::uint32_t b, bool carry); // sets the flags
    std::uint32_t result(std::uint32_t value);                       // sets N and Z
    std::uint32_t shifted(std::uint32_t kind, std::uint32_t value, std::uint32_t by);
    void jump(std::uint32_t to, std::uint64_t cycles);

    [[nodiscard]] std::uint32_t load(std::uint32_t address, std::uint32_t bytes);
    void store(std::uint32_t address, std::uint32_t bytes, std::uint32_t value);
    [[nodiscard]] std::uint8_t* place(std::uint32_t address, std::uint32_t bytes);

    std::vector<std::uint8_t> m_memory;
    std::array<std::uint32_t, 16> m_r{};
    std::uint32_t m_at = 0; // the next instruction
    std::uint32_t m_number;
    std::uint64_t m_cycles = 0;
    std::string m_line; // printed at its end
    bool m_n = false;
    bool m_z = false;
    bool m_c = false;
    bool m_v = false;
    bool m_isRunning = true;
    int m_exitCode = 0;
};

} // namespace campanel::board
