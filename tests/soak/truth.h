// SPDX-License-Identifier: Apache-2.0
// The true state of one controller, known to its master without trusting the line: what was written, applied
// and commanded, the contents of the flash, and the speed of its clock. Every value that a master accepts is
// compared with it; the check returns a sentence when it is wrong.
#pragma once

#include "modbus/map/blocks.h"
#include "tests/soak/faulty_controller.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace campanel::soak {

using Image = std::vector<std::uint16_t>;

// Returns short moves of the same distance, no two tables alike.
[[nodiscard]] std::vector<Image> knownImages();
inline constexpr std::int32_t pulsesOfMove = 100;

// The time of power-up on this program's clock, in an interval that becomes narrower with every answer. An
// answer from before its request, or from after its arrival, is wrong.
class ControllerClock {
public:
    [[nodiscard]] std::string check(std::uint32_t uptimeS, std::uint16_t sampleTimeMs,
                                    Clock::time_point asked, Clock::time_point answered);

private:
    std::optional<Clock::time_point> m_earliest;
    std::optional<Clock::time_point> m_latest;
};

class Truth {
public:
    Truth();

    // --- Events.
    void restarted(); // RAM contents are lost, the flash is loaded
    void saved();     // the present state is in the flash
    void commandCarriedOut(bool isStart, Clock::time_point when);
    void writing(std::uint16_t address, std::span<const std::uint16_t> registers); // it may be so from now on
    void written(std::uint16_t address, std::span<const std::uint16_t> registers); // it is so from now on
    void refused(std::uint16_t address, std::span<const std::uint16_t> registers); // reported to the master
    void applying(std::uint32_t crc);           // it may become active from now on
    void notApplied() { m_pendingCrc.reset(); } // the master was told that the active program is unchanged
    void resetClock() { m_clock = {}; }

    [[nodiscard]] std::uint32_t activeCrc() const { return m_now.crc; }
    [[nodiscard]] const Image& activeImage() const { return m_images.at(m_now.crc); }
    [[nodiscard]] const std::vector<std::uint32_t>& imageCrcs() const { return m_crcs; }
    [[nodiscard]] const Image& image(std::uint32_t crc) const { return m_images.at(crc); }

    // --- Checks of a master's results. Empty: correct. Check everything but the tag and the heartbeat, which
    // the master sets.
    [[nodiscard]] std::string checkStatus(const modbus::StatusBlock& status, Clock::time_point asked,
                                          Clock::time_point answered);
    // Checks how many commands were executed, by the counter, by the cycles and by the position of the axis.
    [[nodiscard]] std::string checkCommands(const modbus::StatusBlock& status);
    // Checks registers of identity, parameters and active bank; ignores others.
    [[nodiscard]] std::string checkRegisters(std::uint16_t address, std::span<const std::uint16_t> registers);
    // Checks a whole bank that was read in pieces: it must be a known one, and the active one.
    [[nodiscard]] std::string checkBank(const std::vector<std::uint16_t>& registers) const;

private:
    struct State { // contents of a save
        std::uint32_t crc = 0;
        std::uint32_t generation = 0;
        std::map<std::uint16_t, std::uint16_t> parameters;
    };
    [[nodiscard]] std::string checkProgram(const modbus::StatusBlock& status);
    [[nodiscard]] std::string checkState(const modbus::StatusBlock& status, Clock::time_point answered) const;
    [[nodiscard]] bool stands(const modbus::StatusBlock& status) const;
    [[nodiscard]] std::string checkBankSlice(std::size_t offset,
                                             std::span<const std::uint16_t> registers) const;

    std::map<std::uint32_t, Image> m_images;
    std::vector<std::uint32_t> m_crcs;
    State m_now;
    State m_flash;
    std::optional<std::uint32_t> m_pendingCrc;
    std::map<std::uint16_t, std::set<std::uint16_t>> m_perhaps; // parameters with an unconfirmed write
    std::map<std::uint16_t, std::uint16_t> m_identity;          // as first read
    std::uint16_t m_commands = 0;                               // executed since power-up
    // The controller's counter before the first of them. After a restart it is 0, but the master may continue
    // from its own: then empty until a status reports it.
    std::optional<std::uint16_t> m_counterBase = 0;
    std::uint32_t m_starts = 0;
    Clock::time_point m_lastStart;
    std::optional<std::uint16_t> m_linkRequests;
    ControllerClock m_clock;
};

} // namespace campanel::soak
