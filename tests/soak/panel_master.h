// SPDX-License-Identifier: Apache-2.0
// Drives one controller as the panel does, with the project's own client and download, at random but seeded,
// and compares everything that it believes with the truth.
#pragma once

#include "modbus/download/download.h"
#include "modbus/line/rtu_client.h"
#include "tests/soak/fault_classes.h"
#include "tests/soak/faulty_controller.h"
#include "tests/soak/tally.h"
#include "tests/soak/truth.h"

#include <memory>
#include <random>

namespace campanel::soak {

struct MasterSettings {
    modbus::LineSettings line;
    std::chrono::milliseconds answerAllowance{20};
    std::uint64_t seed = 1;

    // Of a status exchange: the time-out that late answers are measured in.
    [[nodiscard]] std::chrono::milliseconds statusTimeout() const;
};

// The class's rules with seed, time-out and the names of this controller's ports.
[[nodiscard]] std::string rulesFor(const FaultClass& faults, const MasterSettings& settings,
                                   const FaultyController& controller);

class PanelMaster {
public:
    PanelMaster(FaultyController& controller, const FaultClass& faults, const MasterSettings& settings,
                Tally& tally, Watch& watch);
    ~PanelMaster();

    // On a clean line: a program, parameters, both saved.
    void prepare();
    // So many exchanges with the faults; then on a clean line again whether everything is as it should be.
    void run(std::uint64_t exchanges);

    [[nodiscard]] Truth& truth() { return m_truth; }
    // Lets go of the port.
    void disconnect() { m_client.reset(); }

private:
    enum class Slow : bool { No, Yes }; // the controller may take its time

    template <typename Ask> auto timed(const char* what, int exchanges, Slow slow, Ask ask);
    void connect();
    [[nodiscard]] bool tryToConnect();
    void noteEvents();
    void noteError(const modbus::LinkError& error);
    void noteGoodStatus();

    void oneStep();
    void pollStatus();
    void readBankSlice();
    void readRegisters(std::uint16_t address, std::uint16_t count);
    void readWholeBank();
    void writeParameter();
    void command(modbus::Command code, modbus::CommandArguments arguments = {});
    void settle(const modbus::LinkError& error, modbus::Command code);
    void startDownload();
    void stepDownload();
    void endDownload(const modbus::DownloadError* error);
    [[nodiscard]] std::uint32_t pick(std::uint32_t bound);
    void finish();

    FaultyController& m_controller;
    FaultClass m_faults;
    MasterSettings m_settings;
    Tally& m_tally;
    Watch& m_watch;
    Truth m_truth;
    std::mt19937_64 m_random;
    std::unique_ptr<modbus::RtuClient> m_client;
    std::optional<modbus::Identity> m_identity;
    std::unique_ptr<modbus::Download> m_download;
    std::optional<std::pair<std::uint32_t, std::uint32_t>>
        m_program;                   // generation and CRC-32 by the last status
    FaultyController::Events m_seen; // events up to here are part of the truth
    bool m_replugOpen = false;       // the port has come back, no good status since
    bool m_restartOpen = false;
    bool m_isClean = true; // no faults now
    std::uint16_t m_heartbeat = 0;
    std::uint16_t m_session = 0;
};

// Counts the exchange and holds the call to its bound: so many exchanges, each with draining before a
// question and after a doubtful answer, and something for the other programs on this computer.
template <typename Ask> auto PanelMaster::timed(const char* what, int exchanges, Slow slow, Ask ask)
{
    using std::chrono::milliseconds;
    constexpr milliseconds drainBound{2 * 650};
    constexpr milliseconds schedulingBound{1000};
    constexpr milliseconds slowWork{2000};
    constexpr int longestFrames = 512; // bytes, both ways
    const auto single =
        std::chrono::ceil<milliseconds>(modbus::charactersTime(m_settings.line, longestFrames)) +
        m_settings.answerAllowance + drainBound + (slow == Slow::Yes ? slowWork : milliseconds{0});
    const auto bound = exchanges * single + schedulingBound;
    const auto begun = Clock::now();
    m_watch.begin(what);
    auto result = ask();
    m_watch.end();
    const auto took = Clock::now() - begun;
    m_tally.longestCallMs =
        std::max(m_tally.longestCallMs, std::chrono::duration<double, std::milli>(took).count());
    if (took > bound)
        m_tally.find(m_tally.hangs, std::string(what) + " took " +
                                        std::to_string(std::chrono::ceil<milliseconds>(took).count()) +
                                        " ms");
    m_tally.exchanges += m_isClean ? 0 : 1;
    noteEvents();
    return result;
}

} // namespace campanel::soak
