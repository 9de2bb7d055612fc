// SPDX-License-Identifier: Apache-2.0
// A link without a line: answers as a controller that runs a known program would, always with the same
// numbers and on its own clock. For captures and the self-test.
#pragma once

#include "app/link/link.h"
#include "app/program/program_image.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace campanel::panel {

class DemoLink : public link::Link {
    Q_OBJECT

public:
    // Fresh: with a program that has not run yet. Empty: without one. ProductAcross: a cutter that waits for
    // one to pass. MarksLost: a cutter that stopped for that. ManyAlarms: every fault and warning at once.
    enum class Situation {
        Running,
        Stopped,
        Fault,
        Lost,
        Absent,
        Empty,
        Fresh,
        ProductAcross,
        MarksLost,
        ManyAlarms
    };
    using Kind = profile::ProgramKind;

    explicit DemoLink(QObject* parent);

    void connectTo(const link::ConnectionSettings& settings) override;
    void request(const link::CommandRequest& request) override;
    void readParameter(quint32 id, const std::string& name) override;
    void writeParameter(quint32 id, const std::string& name, double value) override;
    void download(const std::vector<std::uint16_t>& bank) override;
    void cancelDownload() override;
    void withdrawStop() override { ++m_withdrawals; } // none ever waits
    void setJog(link::JogDirection direction) override { m_jog = direction; }
    void readRegisters(const link::ReadRequest& request) override;
    void compareProgram(const std::vector<std::uint16_t>& bank) override;
    void cancelComparison() override {}
    void simulateFaults(const QStringList& rules) override;
    void startScan(modbus::ScanPlan::Depth depth) override;
    void cancelScan() override;
    void watchFigures(bool isWatched) override;
    void resetFigures() override {}
    void watchFrames(bool isWatched) override;

    void show(Situation situation, Kind kind = Kind::RotaryCutter);
    // The search that was begun comes to its end; by itself it never does.
    void endScan(bool isFound);
    // As if the line were that to the simulated controller.
    void setSimulated(bool isSimulated);
    // A controller of an older register map, which tells nothing of film and marks; holds from the next
    // show() of another situation on. True when that is another one than before.
    bool setOld(bool isOld) { return std::exchange(m_isOld, isOld) != isOld; }
    // A Stop waits for the line, as long as the situation is this one.
    void showWaitingStop();
    // How often Stop arrived so far, and how often it was taken back.
    [[nodiscard]] int stopRequests() const { return m_stopRequests; }
    [[nodiscard]] int withdrawals() const { return m_withdrawals; }
    // The key that is held, as it was told last.
    [[nodiscard]] link::JogDirection jog() const { return m_jog; }
    [[nodiscard]] link::SteadyTime now() const { return m_now; }
    // So much of that time goes by.
    void advance(std::chrono::microseconds time) { m_now += time; }

private:
    void report(link::LinkState state, std::optional<modbus::Command> pendingStop = std::nullopt);
    void reportScan(const link::ScanReport& scan);
    void runProgram();
    void tellFilm();
    void runBags();
    void runCycles();
    void runStrokes();
    void pass(double timeS, const modbus::StatusBlock& status); // one status, after so much time
    [[nodiscard]] bool isRunning() const;
    [[nodiscard]] modbus::Identity identity() const;
    [[nodiscard]] modbus::StatusBlock statusAt(double cycleShare) const;
    [[nodiscard]] modbus::StatusBlock strokeAt(double timeS) const;

    program::ProgramImage m_program;
    link::SteadyTime m_now{};
    std::uint32_t m_bags = 0;
    std::map<std::string, double> m_parameters; // 0 until written
    int m_stopRequests = 0;
    int m_withdrawals = 0;
    link::JogDirection m_jog = link::JogDirection::None;
    Situation m_situation = Situation::Running;
    Kind m_kind = Kind::RotaryCutter;
    bool m_isShown = false;
    bool m_isSimulated = false;
    bool m_isScanning = false;
    bool m_isOld = false;
    std::optional<link::ReadRequest> m_filmRequest; // the last one; answered again with every bag
    double m_cycleShare = 0;                        // of the bag under way
};

} // namespace campanel::panel
