// SPDX-License-Identifier: Apache-2.0
// A link without a line: answers as a controller that runs a known program would, always with the same
// numbers and on its own clock. For captures and the self-test.
#pragma once

#include "app/link/link.h"
#include "app/program/program_image.h"

#include <map>
#include <string>

namespace campanel::panel {

class DemoLink : public link::Link {
    Q_OBJECT

public:
    // Fresh: with a program that has not run yet. Empty: without one.
    enum class Situation { Running, Stopped, Fault, Lost, Absent, Empty, Fresh };
    using Kind = profile::ProgramKind;

    explicit DemoLink(QObject* parent);

    void connectTo(const link::ConnectionSettings& settings) override;
    void request(const link::CommandRequest& request) override;
    void readParameter(quint32 id, const std::string& name) override;
    void writeParameter(quint32 id, const std::string& name, double value) override;
    void download(const std::vector<std::uint16_t>& bank) override;
    void cancelDownload() override;
    // Without a line there is nothing to read, to search or to record, and no Stop ever waits.
    void withdrawStop() override {}
    void readRegisters(const link::ReadRequest& request) override;
    void compareProgram(const std::vector<std::uint16_t>& bank) override;
    void cancelComparison() override {}
    void simulateFaults(const QStringList& rules) override;
    void startScan(modbus::ScanPlan::Depth depth) override;
    void cancelScan() override {}
    void watchFigures(bool isWatched) override;
    void resetFigures() override {}
    void watchFrames(bool /*isWatched*/) override {}

    void show(Situation situation, Kind kind = Kind::RotaryCutter);
    // How often Stop arrived so far.
    [[nodiscard]] int stopRequests() const { return m_stopRequests; }
    [[nodiscard]] link::SteadyTime now() const { return m_now; }

private:
    void report(link::LinkState state);
    void runProgram();
    void runBags();
    void runCycles();
    void runStrokes();
    void pass(double timeS, const modbus::StatusBlock& status); // one status, after so much time
    [[nodiscard]] modbus::StatusBlock statusAt(double cycleShare) const;
    [[nodiscard]] modbus::StatusBlock strokeAt(double timeS) const;

    program::ProgramImage m_program;
    link::SteadyTime m_now{};
    std::uint32_t m_bags = 0;
    std::map<std::string, double> m_parameters; // 0 until written
    int m_stopRequests = 0;
    Situation m_situation = Situation::Running;
    Kind m_kind = Kind::RotaryCutter;
    bool m_isShown = false;
};

} // namespace campanel::panel
