// SPDX-License-Identifier: Apache-2.0
// Table 2 of the cutter's paper: set bag lengths, and the deviations measured on its machine.
#pragma once

#include <array>

namespace campanel::profile {

struct PaperLength {
    double bagLengthMm = 0;
    double deviationMm = 0;
};

inline constexpr std::array paperLengths{
    PaperLength{100, 0.1},  PaperLength{125, -0.1}, PaperLength{150, -0.1}, PaperLength{175, 0.1},
    PaperLength{200, -0.1}, PaperLength{220, 0.1},  PaperLength{249, -0.2}, PaperLength{277, -0.2},
    PaperLength{300, 0.1},  PaperLength{319, 0.2},  PaperLength{353, 0.2},  PaperLength{386, -0.1},
    PaperLength{400, 0.1},  PaperLength{434, -0.2}, PaperLength{460, 0.1}};

} // namespace campanel::profile
