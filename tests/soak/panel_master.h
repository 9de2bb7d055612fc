// SPDX-License-Identifier: Apache-2.0
// Operates one controller like the panel, with the project's own client and download, at random but seeded,
// and compares every result with the truth.
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
    ControllerTime time = ControllerTime::Steady;

    // Returns the time-out of a status exchange, the unit of late answers.
    [[nodiscard]] std::chrono::milliseconds statusTimeout() const;
    // Returns the time after which something hangs: much longer where other programs may stop the controller.
    [[nodiscard]] std::chrono::milliseconds patience(std::chrono::milliseconds usual) const
    {
        constexpr int busy = 10;
        return time == ControllerTime::Steady ? usual : busy * usual;
    }
};

// Returns the rules of the class with seed, time-out and the names of this controller's ports.
[[nodiscard]] std::string rulesFor(const FaultClass& faults, const MasterSettings& settings,
                                   const FaultyController& controller);

class PanelMaster {
public:
    PanelMaster(FaultyController& controller, const FaultClass& faults, const MasterSettings& settings,
                Tally& tally, Watch& watch);
    ~PanelMaster();

    // Downloads a program, sets parameters and saves both on a clean line.
    void prepare();
    // Performs this many exchanges with the faults, then checks everything on a clean line.
    void run(std::uint64_t exchanges);

    [[nodiscard]] Truth& truth() { return m_truth; }
    // Closes the port.
    void disconnect() { m_client.reset(); }

private:
    enum class Slow : bool { No, Yes }; // the controller may take longer

    template <typename Ask> auto timed(const char* what, int exchanges, Slow slow, Ask ask);
    void connect();
    [[nodiscard]] bool tryToConnect();
    void noteEvents();
    void noteError(const modbus::LinkError& error);
    void noteGoodStatus();
    void noteReturn(const char* what, Clock::duration took, std::vector<double>& times);
    // Returns how many more times the controller has answered, by its own count, than the client believed.
    [[nodiscard]] std::int64_t unbelievedAnswers() const;

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
    const std::shared_ptr<modbus::LinkRecord> m_record =
        std::make_shared<modbus::LinkRecord>(); // of all connections
    std::unique_ptr<modbus::RtuClient> m_client;
    std::optional<modbus::Identity> m_identity;
    std::unique_ptr<modbus::Download> m_download;
    std::optional<std::pair<std::uint32_t, std::uint32_t>>
        m_program;                   // generation and CRC-32 of the last status
    FaultyController::Events m_seen; // events already included in the truth
    bool m_replugOpen = false;       // the port is back, without a good status since
    bool m_restartOpen = false;
    std::int64_t m_unbelievedBefore = 0; // in the last good status
    bool m_isClean = true;               // without faults at present
    std::uint16_t m_heartbeat = 0;
    std::uint16_t m_session = 0;
};

// Counts the exchange and checks the duration of the call. The limit covers this many exchanges, each with
// draining before a question and after a doubtful answer, and a margin for other programs on this computer.
template <typename Ask> auto PanelMaster::timed(const char* what, int exchanges, Slow slow, Ask ask)
{
    using std::chrono::milliseconds;
    constexpr milliseconds drainBound{2 * 650};
    constexpr milliseconds schedulingBound{1000};
    constexpr milliseconds slowWork{2000};
    constexpr int longestFrames = 512; // bytes, both directions
    const auto single =
        std::chrono::ceil<milliseconds>(modbus::charactersTime(m_settings.line, longestFrames)) +
        m_settings.answerAllowance + drainBound + (slow == Slow::Yes ? slowWork : milliseconds{0});
    const auto bound = m_settings.patience(exchanges * single + schedulingBound);
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
