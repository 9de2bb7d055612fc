// SPDX-License-Identifier: Apache-2.0
// Estimates the gain of the mark correction from the marks themselves. The film slips from bag to bag, which
// accumulates; the sensor scatters, which does not. The variation of the distances between marks separates
// the two.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace campanel::panel {

// The controller's data of the last mark, see the group `packer`.
struct MarkSample {
    std::uint32_t marks = 0;   // followed up to now
    std::uint32_t missing = 0; // up to now
    double errorMm = 0.0;      // measured minus expected position
    double pitchMm = 0.0;      // expected distance to the next mark
};

struct GainSuggestion {
    double phaseGain = 0.0;
    double margin = 0.0; // standard deviation of the phase gain
    double lengthGain = 0.0;
    double slipMm = 0.0;   // standard deviation of the film per bag
    double sensorMm = 0.0; // standard deviation of the sensor per mark
};

class GainEstimate {
public:
    // From here on the gain scatters by less than a technician would notice; fewer do when its margin is a
    // tenth of it.
    static constexpr int minBags = 150;
    static constexpr int maxBags = 400;

    // Adds a mark; call it for every mark. Distances next to a missing mark are ignored. `phaseGain`: the
    // gain in the controller.
    void take(const MarkSample& mark, double phaseGain);
    void clear() { *this = {}; }
    // Returns the number of distances that count.
    [[nodiscard]] int bags() const;
    // Returns nothing while too few bags count, or when the marks do not scatter.
    [[nodiscard]] std::optional<GainSuggestion> suggestion() const;

private:
    // Consecutive distances between marks in mm, oldest first.
    using Run = std::vector<double>;

    std::optional<MarkSample> m_before;
    std::deque<Run> m_runs;
};

} // namespace campanel::panel
