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

enum class ControllerTime : std::uint8_t {
    Steady,   // the controller's clock runs like this computer's
    MayStand, // its computer may stop it for a while, and with it its clock: a firmware in QEMU
};

// The controller's clock, compared with this program's. A steady clock gives the time of power-up in an
// interval that becomes narrower with every answer: an answer from before its request, or from after its
// arrival, is wrong. A clock that may stand never goes back, and never counts more than has passed since
// power-up.
class ControllerClock {
public:
    // The controller was switched on at `powerUp` or later.
    ControllerClock(ControllerTime time, Clock::time_point powerUp)
        : m_time(time)
        , m_powerUp(powerUp)
    {
    }

    [[nodiscard]] std::string check(std::uint32_t uptimeS, std::uint16_t sampleTimeMs,
                                    Clock::time_point asked, Clock::time_point answered);
    // Returns the time since power-up by the last status.
    [[nodiscard]] std::chrono::milliseconds age() const { return m_age; }

private:
    [[nodiscard]] std::string checkSteady(std::chrono::milliseconds age, Clock::time_point asked,
                                          Clock::time_point answered);
    [[nodiscard]] std::string checkStanding(std::chrono::milliseconds age, Clock::time_point answered) const;

    ControllerTime m_time;
    Clock::time_point m_powerUp;
    std::chrono::milliseconds m_age{0};
    std::optional<Clock::time_point> m_earliest;
    std::optional<Clock::time_point> m_latest;
};

class Truth {
public:
    // The controller was switched on at `powerUp` or later.
    Truth(ControllerTime time, Clock::time_point powerUp);

    // --- Events.
    void restarted(); // RAM contents are lost, the flash is loaded
    void saved();     // the present state is in the flash
    void commandCarriedOut(bool isStart);
    void writing(std::uint16_t address, std::span<const std::uint16_t> registers); // it may be so from now on
    void written(std::uint16_t address, std::span<const std::uint16_t> registers); // it is so from now on
    void refused(std::uint16_t address, std::span<const std::uint16_t> registers); // reported to the master
    void applying(std::uint32_t crc);           // it may become active from now on
    void notApplied() { m_pendingCrc.reset(); } // the master was told that the active program is unchanged
    void resetClock() { m_clock = ControllerClock(m_time, m_powerUp); }

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
    [[nodiscard]] std::string checkState(const modbus::StatusBlock& status);
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
    // The controller's time in the first status behind the last start; empty before that status.
    std::optional<std::chrono::milliseconds> m_startAge;
    std::optional<std::uint16_t> m_linkRequests;
    ControllerTime m_time;
    Clock::time_point m_powerUp;    // not before
    Clock::time_point m_lastAnswer; // the last one believed
    ControllerClock m_clock;
};

} // namespace campanel::soak
