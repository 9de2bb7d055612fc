// SPDX-License-Identifier: Apache-2.0
// The operator's trims, one row each: where a recipe, its file and the controller have them. The limits are
// those of the register.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace campanel::program {

enum class Trim { Cut, Product, Length };
inline constexpr std::size_t trimCount = 3;

// mm, by Trim: the cut later on the print, the product forward in its bag, every bag longer.
using Trims = std::array<double, trimCount>;

struct TrimInfo {
    std::string_view key;          // in recipe files
    std::string_view registerName; // of the program that is active
    std::string_view nextName;     // of the next one of another name
};

inline constexpr std::array<TrimInfo, trimCount> trimTable{
    TrimInfo{"cut_mm", "hand.cut", "hand.next_cut"},
    TrimInfo{"product_mm", "hand.product", "hand.next_product"},
    TrimInfo{"length_mm", "hand.length", "hand.next_length"},
};

// Returns the limit in both directions.
[[nodiscard]] double maxTrimMm(Trim trim);

} // namespace campanel::program
