// SPDX-License-Identifier: Apache-2.0
// What is true of one controller, as far as whoever drives it can know without believing the line: what was
// written, applied and commanded, what the flash holds, and how fast its clock runs. Every value that a
// master believes is compared with it; the check returns a sentence when it is wrong.
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

// Short moves of the same distance, no two tables alike.
[[nodiscard]] std::vector<Image> knownImages();
inline constexpr std::int32_t pulsesOfMove = 100;

// Power-up as a moment of this program's clock, in an interval that becomes narrower with every answer. An
// answer that was taken before it was asked for, or after it came, is a wrong one.
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

    // --- What was done.
    void restarted(); // what was in RAM is gone, the flash is loaded
    void saved();     // the state now is what the flash holds
    void commandCarriedOut(bool isStart, Clock::time_point when);
    void writing(std::uint16_t address, std::span<const std::uint16_t> registers); // from now on it may be so
    void written(std::uint16_t address, std::span<const std::uint16_t> registers); // from now on it is so
    void refused(std::uint16_t address, std::span<const std::uint16_t> registers); // the master was told so
    void applying(std::uint32_t crc);           // from now on it may become active
    void notApplied() { m_pendingCrc.reset(); } // the master was told that the active program is unchanged
    void resetClock() { m_clock = {}; }

    [[nodiscard]] std::uint32_t activeCrc() const { return m_now.crc; }
    [[nodiscard]] const Image& activeImage() const { return m_images.at(m_now.crc); }
    [[nodiscard]] const std::vector<std::uint32_t>& imageCrcs() const { return m_crcs; }
    [[nodiscard]] const Image& image(std::uint32_t crc) const { return m_images.at(crc); }

    // --- What a master believes. Empty: it is so.
    // Everything but the tag and the heartbeat, which are the asker's.
    [[nodiscard]] std::string checkStatus(const modbus::StatusBlock& status, Clock::time_point asked,
                                          Clock::time_point answered);
    // How many commands were carried out, by the counter, by the cycles and by where the axis stands.
    [[nodiscard]] std::string checkCommands(const modbus::StatusBlock& status);
    // Registers of identity, parameters and active bank; others are not judged.
    [[nodiscard]] std::string checkRegisters(std::uint16_t address, std::span<const std::uint16_t> registers);
    // A whole bank that was read in pieces: one of the known ones, and the active one.
    [[nodiscard]] std::string checkBank(const std::vector<std::uint16_t>& registers) const;

private:
    struct State { // what a save keeps
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
    std::map<std::uint16_t, std::set<std::uint16_t>> m_perhaps; // parameters whose write was not confirmed
    std::map<std::uint16_t, std::uint16_t> m_identity;          // as first read
    std::uint16_t m_commands = 0;                               // carried out since power-up
    // Counter of the controller before the first of them. After a restart it is 0, but the master may go on
    // from where it was: then empty until a status tells.
    std::optional<std::uint16_t> m_counterBase = 0;
    std::uint32_t m_starts = 0;
    Clock::time_point m_lastStart;
    std::optional<std::uint16_t> m_linkRequests;
    ControllerClock m_clock;
};

} // namespace campanel::soak
