// SPDX-License-Identifier: Apache-2.0
// The serial line between pseudo-terminal and controller: bytes take as long as on the wire, separately in
// each direction. Works on times and bytes only; the owner of the descriptors asks it what to do when. Times
// are in ns and monotonic.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace campanel::controller {

inline constexpr std::int64_t nsPerS = 1'000'000'000;

struct LineSettings {
    std::uint32_t baud = 115200;
    char parity = 'N'; // N, E or O
    std::uint32_t stopBits = 1;
    bool paced = true; // false: bytes take no time
};

// Returns the time of one character: start bit, 8 data bits, parity, stop bits.
[[nodiscard]] std::int64_t characterNs(const LineSettings& settings);
// Returns the silence that ends a frame: 3.5 characters, 1.75 ms above 19200 baud.
[[nodiscard]] std::int64_t frameGapNs(const LineSettings& settings);

class Line {
public:
    struct Arrival {
        std::vector<std::uint8_t> bytes;
        std::int64_t endNs = 0; // arrival of the last byte
    };

    explicit Line(const LineSettings& settings);

    void fromPanel(std::span<const std::uint8_t> bytes, std::int64_t nowNs);
    // Returns the oldest complete piece.
    [[nodiscard]] std::optional<Arrival> takeArrival(std::int64_t nowNs);

    // Puts the controller's answer on the line, byte after byte.
    void fromController(std::span<const std::uint8_t> bytes, std::int64_t nowNs);
    // Returns the bytes that the panel has received by now, except those already returned.
    [[nodiscard]] std::vector<std::uint8_t> takeForPanel(std::int64_t nowNs);

    [[nodiscard]] std::optional<std::int64_t> nextEventNs() const;

private:
    std::int64_t m_characterNs = 0;
    std::size_t m_pieceBytes = 1; // bytes delivered to the panel at once
    std::deque<Arrival> m_toController;
    std::int64_t m_toControllerEndNs = 0;
    std::deque<Arrival> m_toPanel;
    std::int64_t m_toPanelEndNs = 0;
};

} // namespace campanel::controller
