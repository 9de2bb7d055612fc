// SPDX-License-Identifier: Apache-2.0
// Finds the fewest straight lines, joined end to end, through a channel.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace campanel::profile::detail {

// One cross-section of the channel. The walls between two gates are straight; two gates at the same time are
// a step.
struct Gate {
    double timeS = 0;
    double lowerHz = 0;
    double upperHz = 0;
};

struct PathPoint {
    double timeS = 0;
    double speedHz = 0;
};

// The choice of the last link, which is not unique.
enum class LastLink {
    LeastTurn, // continues as straight as possible
    Middle,    // in the middle of the possible range
};

// Returns the ends of the links from the first gate to the last one, in order: one more than the links.
// Returns nothing when a gate is closed (lower above upper), a step is impassable, or more than maxLinks are
// necessary.
//
// No path has fewer links: each one extends as far as possible from what the previous links can reach. (Imai
// and Iri, "An optimal algorithm for approximating a piecewise linear function", 1986; Suri, "A linear time
// algorithm for minimum link paths inside a simple polygon", 1986.) `last` selects the last link within
// its possible range. The time is linear in the number of gates.
[[nodiscard]] std::optional<std::vector<PathPoint>>
minLinks(std::span<const Gate> channel, std::size_t maxLinks, LastLink last = LastLink::LeastTurn);

} // namespace campanel::profile::detail
