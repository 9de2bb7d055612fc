// SPDX-License-Identifier: Apache-2.0
// The held jog key in the link thread: the bits for the next exchange, and the time at which it is due. After
// any other end than a release, the key must be released before the next jog.
#pragma once

#include "app/link/link_values.h"

namespace campanel::link {

class HeldJog {
public:
    void hold(const JogRequest& request);
    // Ends the jog until the key is released.
    void end();

    // Returns the bits of exchange.jog for the exchange about to be sent; call noteAnswer() when it was
    // answered.
    [[nodiscard]] std::uint16_t bits(SteadyTime now);
    void noteAnswer() { m_heard = m_sent; }
    [[nodiscard]] JogDirection directionAt(SteadyTime now) const;
    // Returns true when the controller must get the bits before anything but a Stop.
    [[nodiscard]] bool isPollDue(SteadyTime now, SteadyTime lastPollAt) const;

private:
    JogRequest m_held;
    JogDirection m_sent = JogDirection::None;
    JogDirection m_heard = JogDirection::None; // confirmed by the controller
    bool m_isBlocked = false;
};

} // namespace campanel::link
