// SPDX-License-Identifier: Apache-2.0
// How the controller sees what lies between the jaws: from their first touch until it tells a jam, and from
// there to standstill. Jams that are met before it has learned the torque are counted apart.
#pragma once

#include "ctl_core.h"
#include "machine.h"

#include <cstdint>

namespace campanel::controller {

class JamFigures {
public:
    // Follows a step of the machine.
    void take(const ctl_core& core, const Machine& machine, std::uint64_t stepUs);

    std::uint32_t count = 0;      // jams that the jaws touched
    std::uint32_t cutThrough = 0; // of them
    std::uint32_t notArmed = 0;   // of them before the torque was learned
    std::uint32_t seen = 0;       // of the others
    std::uint32_t falsely = 0;    // stops without a jam
    double meanSeenDegrees = 0.0;
    double longestSeenDegrees = 0.0;
    double longestSeenMs = 0.0;
    double longestRunOnDegrees = 0.0;
    double largestForceN = 0.0;

private:
    void see(double degrees);

    std::uint64_t m_pressedUs = 0; // since the jaws touched it
    bool m_wasArmed = false;
    std::uint16_t m_number = 0; // of the controller's jams
    double m_seenAtDegrees = 0.0;
};

} // namespace campanel::controller
