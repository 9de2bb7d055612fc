// SPDX-License-Identifier: Apache-2.0
// Measures the dead time of the product eye by a part that comes to the same place of the infeed again and
// again, at two speeds: a late eye sees each edge farther behind, by dead time x speed. Both edges are
// measured, each alone.
#pragma once

#include "modbus/map/mark_edges.h"

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace campanel::program {

struct EyeDelay {
    double ms = 0.0;
    double marginMs = 0.0; // standard deviation
};

class EyeDeadTime {
public:
    // Above this margin nothing is offered: usual products lie with too much scatter.
    static constexpr double maxMarginMs = 0.2;

    enum Edge { Begin, End };

    // Adds an edge; call it for every edge in turn.
    void take(const modbus::EyeEdge& edge);
    // Returns the number of the newest edge.
    [[nodiscard]] std::uint32_t last() const { return m_last ? m_last->number : 0; }
    // Returns nothing before one part was seen often enough at two speeds.
    [[nodiscard]] std::optional<EyeDelay> measured(Edge edge) const;
    // Returns offeredMs(); nothing while the margin is too large.
    [[nodiscard]] std::optional<double> offered(Edge edge, double presentMs) const;

private:
    struct Seen {
        std::uint32_t number = 0;
        std::uint16_t place = 0; // 1/65536 pitch
        double speed = 0.0;      // pitches per second
    };
    // The newest edges at one speed.
    using Speed = std::deque<Seen>;
    using Speeds = std::vector<Speed>;

    void add(Speeds& speeds, const Seen& seen);

    std::array<Speeds, 2> m_speeds; // by Edge
    std::optional<modbus::EyeEdge> m_last;
};

} // namespace campanel::program
