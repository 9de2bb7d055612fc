// SPDX-License-Identifier: Apache-2.0
// Serves a simulated controller on a pseudo-terminal in real time (times a factor): sleeps until the next
// byte, frame end or piece of an answer, then catches up with the simulation.
#pragma once

#include "line.h"
#include "options.h"
#include "pseudo_terminal.h"
#include "simulated_controller.h"

#include <csignal>
#include <cstdint>
#include <optional>

namespace campanel::controller {

class Service {
public:
    // Terminal and flash must outlive the service.
    Service(const Options& options, PseudoTerminal& terminal, FlashDevice& flash);

    // Until *stop is set by a signal that is delivered only while this waits with `waitMask`.
    void run(const volatile std::sig_atomic_t& stop, const sigset_t& waitMask);

private:
    [[nodiscard]] std::uint64_t simulatedUs(std::int64_t timeNs) const;
    void catchUp(std::int64_t nowNs);
    void moveBytes(std::int64_t nowNs);
    void wait(std::int64_t nowNs, const sigset_t& waitMask);

    PseudoTerminal& m_terminal;
    Line m_line;
    std::int64_t m_gapNs = 0;
    double m_speed = 1.0;
    std::int64_t m_startNs = 0; // real time of power-up, moved when the simulation cannot keep up
    SimulatedController m_controller;
    std::optional<std::int64_t> m_frameEndNs; // of the request under way
};

} // namespace campanel::controller
