// SPDX-License-Identifier: Apache-2.0
// The tests' link with answers: as a controller that runs a known program would give them, always with the
// same numbers and on its own clock.
#pragma once

#include "tests/support/fake_link.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace campanel::looks {

class DemoLink : public test::FakeLink {
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
    void readRegisters(const link::ReadRequest& request) override;
    void compareProgram(const std::vector<std::uint16_t>& bank) override;
    void simulateFaults(const QStringList& rules) override;
    void startScan(modbus::ScanPlan::Depth depth) override;
    void cancelScan() override;
    void watchFigures(bool isWatched) override;
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
    // How often Stop arrived so far.
    [[nodiscard]] qsizetype stopRequests() const;
    // The jog key that is held.
    [[nodiscard]] link::JogDirection jog() const
    {
        return jogs.isEmpty() ? link::JogDirection::None : jogs.constLast();
    }
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
    void pass(double timeS, const modbus::StatusBlock& block); // one status, after so much time
    [[nodiscard]] bool isRunning() const;
    [[nodiscard]] modbus::Identity demoIdentity() const;
    [[nodiscard]] modbus::StatusBlock statusAt(double cycleShare) const;
    [[nodiscard]] modbus::StatusBlock strokeAt(double timeS) const;

    program::ProgramImage m_program;
    link::SteadyTime m_now{};
    std::uint32_t m_bags = 0;
    std::map<std::string, double> m_parameters; // 0 until written
    Situation m_situation = Situation::Running;
    Kind m_kind = Kind::RotaryCutter;
    bool m_isShown = false;
    bool m_isSimulated = false;
    bool m_isScanning = false;
    bool m_isOld = false;
    std::optional<link::ReadRequest> m_filmRequest; // the last one; answered again with every bag
    double m_cycleShare = 0;                        // of the bag under way
};

} // namespace campanel::looks
