// SPDX-License-Identifier: Apache-2.0
// What a packing machine's controller would tell of its film, its marks and its bags. Always the same.
// For the demonstration link.
#pragma once

#include <cstdint>
#include <vector>

namespace campanel::looks {

struct DemoFilm {
    enum class Trouble { None, ProductAcross, MarksLost };

    double bagMm = 250;
    double cycleShare = 0;  // of the bag under way
    std::uint32_t bags = 0; // made so far
    Trouble trouble = Trouble::None;
};

// What the last bag was off by, mm: scattering as that of a good machine does.
[[nodiscard]] double demoDeviationMm(std::uint32_t bag);
// The group `packer`.
[[nodiscard]] std::vector<std::uint16_t> demoPacker(const DemoFilm& film);

} // namespace campanel::looks
