// SPDX-License-Identifier: Apache-2.0
// The serial line between pseudo-terminal and controller: bytes take as long as on the wire, each way on its
// own. Knows times and bytes only; whoever owns the descriptors asks it when to do what. Times in ns,
// monotonic.
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

// One character: start bit, 8 data bits, parity, stop bits.
[[nodiscard]] std::int64_t characterNs(const LineSettings& settings);
// Silence that ends a frame: 3.5 characters, 1.75 ms above 19200 baud.
[[nodiscard]] std::int64_t frameGapNs(const LineSettings& settings);

class Line {
public:
    struct Arrival {
        std::vector<std::uint8_t> bytes;
        std::int64_t endNs = 0; // when the last of them is in
    };

    explicit Line(const LineSettings& settings);

    // The panel has put bytes on the line.
    void fromPanel(std::span<const std::uint8_t> bytes, std::int64_t nowNs);
    // The oldest piece that has arrived whole.
    [[nodiscard]] std::optional<Arrival> takeArrival(std::int64_t nowNs);

    // The controller answers; the bytes leave one after another.
    void fromController(std::span<const std::uint8_t> bytes, std::int64_t nowNs);
    // Bytes that the panel has received by now and that were not taken yet.
    [[nodiscard]] std::vector<std::uint8_t> takeForPanel(std::int64_t nowNs);

    // When to look again.
    [[nodiscard]] std::optional<std::int64_t> nextEventNs() const;

private:
    std::int64_t m_characterNs = 0;
    std::size_t m_pieceBytes = 1; // bytes handed to the panel at once
    std::deque<Arrival> m_toController;
    std::int64_t m_toControllerEndNs = 0;
    std::deque<Arrival> m_toPanel;
    std::int64_t m_toPanelEndNs = 0;
};

} // namespace campanel::controller
