// SPDX-License-Identifier: Apache-2.0
// The fewest straight lines, joined end to end, that lead through a channel.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace campanel::profile::detail {

// One cross-section of the channel. Between two of them its walls are straight; two at the same time are a
// step.
struct Gate {
    double timeS = 0;
    double lowerHz = 0;
    double upperHz = 0;
};

struct PathPoint {
    double timeS = 0;
    double speedHz = 0;
};

// The last link has a choice left.
enum class LastLink {
    LeastTurn, // goes on as straight as it may
    Middle,    // of all that is open to it
};

// The ends of the links from the first gate to the last one, in order: one more than links. Nothing when a
// gate is shut (lower above upper), when a step leaves no way through, or when it takes more than mostLinks.
//
// No path has fewer links: each is the line that leads farthest from what the links before it can reach.
// (Imai and Iri, "An optimal algorithm for approximating a piecewise linear function", 1986; Suri, "A linear
// time algorithm for minimum link paths inside a simple polygon", 1986.) The last link lies in the middle of
// what is left to it. Time grows with the number of gates, not with its square.
[[nodiscard]] std::optional<std::vector<PathPoint>>
fewestLinks(std::span<const Gate> channel, std::size_t mostLinks, LastLink last = LastLink::LeastTurn);

} // namespace campanel::profile::detail
