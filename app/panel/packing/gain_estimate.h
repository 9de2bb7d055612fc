// SPDX-License-Identifier: Apache-2.0
// How much of a mark's error to believe, from the marks themselves. The film slips a little from bag to bag,
// which adds up, and the sensor scatters, which does not; how the distances between the marks vary tells one
// from the other.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace campanel::machine {

// What the controller tells of the last mark, see the group `packer`.
struct MarkSample {
    std::uint32_t marks = 0;   // followed so far
    std::uint32_t missing = 0; // so far
    double errorMm = 0.0;      // where it came minus where it was expected
    double pitchMm = 0.0;      // distance expected to the next one
};

struct GainSuggestion {
    double phaseGain = 0.0;
    double lengthGain = 0.0;
    double slipMm = 0.0;   // standard deviations: of the film per bag
    double sensorMm = 0.0; // of the sensor per mark
};

class GainEstimate {
public:
    static constexpr int fewestBags = 50;
    static constexpr int mostBags = 400;

    // To be told every mark; distances next to one that was not told, or was missing, are left out.
    // `phaseGain`: what the controller works with.
    void take(const MarkSample& mark, double phaseGain);
    void clear() { *this = {}; }
    // Distances that count.
    [[nodiscard]] int bags() const;
    // Empty before there are fewestBags, and where the marks do not scatter.
    [[nodiscard]] std::optional<GainSuggestion> suggestion() const;

private:
    // Distances between marks in mm without a gap among them, oldest first.
    using Run = std::vector<double>;

    std::optional<MarkSample> m_before;
    std::deque<Run> m_runs;
};

} // namespace campanel::machine
