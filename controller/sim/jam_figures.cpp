// SPDX-License-Identifier: Apache-2.0
#include "jam_figures.h"

#include <algorithm>

namespace campanel::controller {
namespace {

constexpr double usPerMs = 1000.0;

} // namespace

void JamFigures::take(const ctl_core& core, const Machine& machine, std::uint64_t stepUs)
{
    const Jaws& jaws = machine.jaws();
    const auto pressed = jaws.pressedDegrees();
    if (jaws.touched() != count) {
        m_wasArmed = ctl_jam_state(&core.packer.jam) == CTL_JAM_STATE_ARMED;
        notArmed += m_wasArmed ? 0u : 1u;
    }
    count = jaws.touched();
    cutThrough = jaws.cutThrough();
    largestForceN = jaws.largestForceN();
    m_pressedUs = pressed ? m_pressedUs + stepUs : 0;
    if (core.packer.jam.number != m_number) {
        m_number = core.packer.jam.number;
        m_seenAtDegrees = machine.shaftDegrees();
        falsely += pressed ? 0u : 1u;
        if (pressed && m_wasArmed)
            see(*pressed);
    }
    if (core.motion.park.jam && m_wasArmed)
        longestRunOnDegrees = std::max(longestRunOnDegrees, machine.shaftDegrees() - m_seenAtDegrees);
}

void JamFigures::see(double degrees)
{
    ++seen;
    meanSeenDegrees += (degrees - meanSeenDegrees) / seen;
    longestSeenDegrees = std::max(longestSeenDegrees, degrees);
    longestSeenMs = std::max(longestSeenMs, static_cast<double>(m_pressedUs) / usPerMs);
}

} // namespace campanel::controller
