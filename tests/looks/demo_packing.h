// SPDX-License-Identifier: Apache-2.0
// Example data of a packing machine's film, marks and bags, and of its
// knife's torque. Always the same. For the demonstration link.
#pragma once

#include "modbus/map/jam_status.h"

#include <cstdint>
#include <vector>

namespace campanel::looks {

struct DemoFilm {
    enum class Trouble { None, ProductAcross, MarksLost, NotStarted };

    double bagMm = 250;
    double cycleShare = 0;  // share of the present bag
    std::uint32_t bags = 0; // completed
    Trouble trouble = Trouble::None;
};

// Returns the deviation of the last bag, mm: the scatter of a good machine.
[[nodiscard]] double demoDeviationMm(std::uint32_t bag);
// Returns the group `sensor`: marks that were taken, some that are missing or outside their window.
[[nodiscard]] std::vector<std::uint16_t> demoEdges(const DemoFilm& film);
// Returns the group `jam` with a learned band in this state; with a last jam if `hasJammed`.
[[nodiscard]] std::vector<std::uint16_t> demoJam(modbus::JamState state, bool hasJammed);
// Returns the group `packer`.
[[nodiscard]] std::vector<std::uint16_t> demoPacker(const DemoFilm& film);

} // namespace campanel::looks
