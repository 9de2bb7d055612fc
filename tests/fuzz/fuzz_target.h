// SPDX-License-Identifier: Apache-2.0
// A target of the fuzzers: one function that takes any bytes, and the inputs that a run begins with, made
// from real data. A target ends the program when something that must hold does not. See README.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace campanel::fuzz {

using Bytes = std::vector<std::uint8_t>;

// Runs the target on one input.
void runTarget(std::span<const std::uint8_t> input);
// Returns the inputs that a run begins with, a few KB together.
[[nodiscard]] std::vector<Bytes> targetSeeds();

inline Bytes bytesOf(std::string_view text)
{
    return Bytes(text.begin(), text.end());
}

// Ends the program, with what should have been so, unless `holds`.
inline void require(bool holds, const char* what)
{
    if (holds)
        return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

// Takes numbers off an input; behind its end all of them are 0.
class InputReader {
public:
    explicit InputReader(std::span<const std::uint8_t> input)
        : m_rest(input)
    {
    }

    [[nodiscard]] bool isAtEnd() const { return m_rest.empty(); }
    std::uint8_t byte()
    {
        if (m_rest.empty())
            return 0;
        const std::uint8_t value = m_rest.front();
        m_rest = m_rest.subspan(1);
        return value;
    }
    std::uint16_t word()
    {
        const unsigned high = byte();
        return static_cast<std::uint16_t>(high << 8 | byte());
    }
    // Returns so many bytes, or what is left.
    std::span<const std::uint8_t> take(std::size_t count)
    {
        const auto taken = m_rest.first(count < m_rest.size() ? count : m_rest.size());
        m_rest = m_rest.subspan(taken.size());
        return taken;
    }
    std::span<const std::uint8_t> rest() { return take(m_rest.size()); }

private:
    std::span<const std::uint8_t> m_rest;
};

} // namespace campanel::fuzz
