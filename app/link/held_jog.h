// SPDX-License-Identifier: Apache-2.0
// The jog key that is held, as the link thread knows it: which bits go with the next exchange, and when that
// must come. A jog that ended by anything but the finger comes back only after the key was let go.
#pragma once

#include "app/link/link_values.h"

namespace campanel::link {

class HeldJog {
public:
    void hold(const JogRequest& request);
    // Whatever the finger does, until it lets go.
    void end();

    // Of exchange.jog, for the exchange that goes out now; noteAnswer() when that was answered.
    [[nodiscard]] std::uint16_t bits(SteadyTime now);
    void noteAnswer() { m_heard = m_sent; }
    [[nodiscard]] JogDirection directionAt(SteadyTime now) const;
    // The controller must hear of it before anything else but a Stop goes out.
    [[nodiscard]] bool isPollDue(SteadyTime now, SteadyTime lastPollAt) const;

private:
    JogRequest m_held;
    JogDirection m_sent = JogDirection::None;
    JogDirection m_heard = JogDirection::None; // by the controller, for certain
    bool m_isBlocked = false;
};

} // namespace campanel::link
