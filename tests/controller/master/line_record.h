// SPDX-License-Identifier: Apache-2.0
// The record of a line and the machine that follows it, from what the controller gave to its ports: the ticks
// of the main axis' pulses, and the film's positions slice by slice. Beside them the true position of the
// line.
#pragma once

#include "rig.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace campanel::test {

class LineRecord {
public:
    static constexpr double clockHz = 8e6;
    static constexpr double sliceS = 250e-6;

    // Records the rig from now on; only one at a time.
    explicit LineRecord(Rig& rig)
        : m_rig(rig)
    {
        s_film = &m_film;
        rig.controller().onPulses = [this](const ctl_train& train) { take(train); };
        rig.core().board.port.feed = [](void* context, ctl_axis axis, std::int64_t from, std::int64_t to) {
            if (axis == CTL_AXIS_FILM) {
                s_film->isBroken = s_film->isBroken || from != s_film->at || to < from - 1;
                s_film->at = to;
            }
            static_cast<controller::SimulatedController*>(context)->machine().commandFeed(axis, from, to);
        };
        m_film.at = rig.core().packer.film_at;
        m_pulses = rig.core().motion.commanded;
    }
    LineRecord(const LineRecord&) = delete;
    LineRecord& operator=(const LineRecord&) = delete;
    ~LineRecord() { m_rig.controller().onPulses = nullptr; }

    // Advances the rig by a slice.
    void step()
    {
        const std::uint64_t begin = m_begin;
        m_rig.controller().step();
        m_begin = begin + m_rig.core().board.slice_ticks;
        auto& shaft = m_rig.controller().machine().shaft();
        lineMm.push_back(shaft.positionMm());
        lineMmPerS.push_back(shaft.speedMmPerS());
        filmPulses.push_back(static_cast<double>(m_film.at) / 256.0);
        axisAtEnd.push_back(m_pulses);
        endTicks.push_back(m_begin);
        clutch.push_back(m_rig.core().master.clutch.state);
    }
    void run(double timeS)
    {
        for (int i = 0; i < std::lround(timeS / sliceS); ++i)
            step();
    }

    // Returns where the main axis was at the end of each slice: pulses are evenly apart between two of them.
    [[nodiscard]] std::vector<double> axis() const
    {
        std::vector<double> positions;
        std::size_t next = 0;
        for (std::size_t i = 0; i < endTicks.size(); ++i) {
            while (next < m_ticks.size() && m_ticks[next] <= endTicks[i])
                ++next;
            double at = static_cast<double>(axisAtEnd[i]);
            if (next > 0 && next < m_ticks.size() && m_directions[next] == m_directions[next - 1] &&
                m_ticks[next] - m_ticks[next - 1] < longestGap)
                at += m_directions[next] * static_cast<double>(endTicks[i] - m_ticks[next - 1]) /
                      static_cast<double>(m_ticks[next] - m_ticks[next - 1]);
            positions.push_back(at);
        }
        return positions;
    }
    // Returns true when the pulses come in the order of time, each in its slice, and the film goes on from
    // where it was, never back by more than the rounding of a 256th of a pulse.
    [[nodiscard]] bool isInOrder() const { return m_isInOrder && !m_film.isBroken; }

    // At the end of each slice.
    std::vector<double> lineMm;
    std::vector<double> lineMmPerS;
    std::vector<double> filmPulses;
    std::vector<std::int64_t> axisAtEnd;
    std::vector<std::uint64_t> endTicks;
    std::vector<ctl_clutch_state> clutch;

private:
    static constexpr std::uint64_t longestGap = 80'000; // ticks; beyond it the axis stands

    struct Film {
        std::int64_t at = 0; // 1/256 pulse
        bool isBroken = false;
    };

    void take(ctl_train train)
    {
        while (train.count != 0) {
            const std::uint32_t inSlice = ctl_train_next(&train) - m_rig.core().board.tick; // modulo 2^32
            const std::uint64_t tick = m_begin + inSlice;
            m_isInOrder = m_isInOrder && inSlice <= m_rig.core().board.slice_ticks &&
                          (m_ticks.empty() || tick >= m_ticks.back());
            m_ticks.push_back(tick);
            m_directions.push_back(train.direction);
            m_pulses += train.direction;
        }
    }

    static inline Film* s_film = nullptr;
    Rig& m_rig;
    Film m_film;
    std::uint64_t m_begin = 0; // of the slice, ticks since the record began
    std::int64_t m_pulses = 0;
    bool m_isInOrder = true;
    std::vector<std::uint64_t> m_ticks;
    std::vector<int> m_directions;
};

} // namespace campanel::test
