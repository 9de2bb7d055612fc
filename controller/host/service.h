// SPDX-License-Identifier: Apache-2.0
// Serves a simulated controller on a pseudo-terminal in real time (times a factor). It sleeps until the next
// byte, frame end or piece of an answer, then advances the simulation. It includes the faults of the line.
#pragma once

#include "control_input.h"
#include "faulty_line.h"
#include "options.h"
#include "served_port.h"
#include "simulated_controller.h"

#include <csignal>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

namespace campanel::controller {

class Service {
public:
    // Port and flash must outlive the service.
    Service(const Options& options, ServedPort& port, FlashDevice& flash);

    // Runs until a signal sets *stop; the signal is delivered only during the wait with `waitMask`.
    void run(const volatile std::sig_atomic_t& stop, const sigset_t& waitMask);

private:
    [[nodiscard]] std::uint64_t simulatedUs(std::int64_t timeNs) const;
    void catchUp(std::int64_t nowNs);
    void moveBytes(std::int64_t nowNs);
    void takeAnswer(std::int64_t nowNs);
    void wait(std::int64_t nowNs, const sigset_t& waitMask);
    void act(const LineEvent& event, std::int64_t nowNs);
    void powerUp(std::int64_t nowNs);
    void measure() const;
    void setPin(std::string_view text);
    void moveLine(std::string_view text) const;
    void takeControlLine(std::string_view text);
    void say(std::string_view line) const;

    Options m_options;
    ServedPort& m_port;
    FlashDevice& m_flash;
    FaultyLine m_line;
    ControlInput m_control;
    std::int64_t m_gapNs = 0;
    std::int64_t m_startNs = 0; // real time of power-up, moved when the simulation cannot keep up
    std::unique_ptr<SimulatedController> m_controller;
    std::optional<BagCut> m_lastCut;
    std::uint64_t m_frame = 0;                // frame of the last bytes
    std::optional<std::int64_t> m_frameEndNs; // end of the present request
};

} // namespace campanel::controller
