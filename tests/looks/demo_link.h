// SPDX-License-Identifier: Apache-2.0
// A link without a line: it answers like a controller that runs a known program, always with the same numbers
// and on its own clock. For captures and the self-test.
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
    // Fresh: with a program that has not run yet. Empty: without a program. ProductAcross: a cutter that
    // waits for a product to pass. MarksLost: a cutter that stopped because of lost marks. Jammed: one with
    // something under its jaws. ManyAlarms: every fault and warning at once.
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
        Jammed,
        ManyAlarms
    };
    using Kind = profile::ProgramKind;

    explicit DemoLink(QObject* parent);

    void connectTo(const link::ConnectionSettings& settings) override;
    void download(const std::vector<std::uint16_t>& bank) override;
    void cancelDownload() override;
    void compareProgram(const std::vector<std::uint16_t>& bank) override;
    void simulateFaults(const QStringList& rules) override;
    void startScan(modbus::ScanPlan::Depth depth) override;
    void cancelScan() override;
    void watchFigures(bool isWatched) override;
    void watchFrames(bool isWatched) override;

    void show(Situation situation, Kind kind = Kind::RotaryCutter);
    // Sets the state of the monitoring of the knife's torque.
    void setParameter(const std::string& name, double value) { m_parameters[name] = value; }
    void setJamState(modbus::JamState state) { m_jamState = state; }
    // Sets the order that the controller counts.
    void setOrder(const modbus::OrderStatus& order) { m_order = order; }
    // Sets what a measurement of an axis has counted; one that is asked for makes its turns at once.
    void setMeasure(const modbus::MeasureStatus& measure) { m_measure = measure; }
    // Ends the search; it never ends without this call.
    void endScan(bool isFound);
    // Behaves like the line to the simulated controller.
    void setSimulated(bool isSimulated);
    // Sets a controller of an older register map without film and marks, effective from the next change of
    // the situation. Returns true when this is a change.
    bool setOld(bool isOld) { return std::exchange(m_isOld, isOld) != isOld; }
    // Lets an encoder of the line lead the machine, or the clock of a controller without an input for one.
    void setLed(bool isLed);
    // Shows a Stop that waits for the line until the situation changes.
    void showWaitingStop();
    // How often Stop arrived so far.
    [[nodiscard]] qsizetype stopRequests() const;
    // The jog key that is held.
    [[nodiscard]] link::JogDirection jog() const
    {
        return jogs.isEmpty() ? link::JogDirection::None : jogs.constLast();
    }
    [[nodiscard]] link::SteadyTime now() const { return m_now; }
    // Advances the clock.
    void advance(std::chrono::microseconds time) { m_now += time; }

protected:
    void sendCommand(const link::CommandRequest& request) override;
    void sendParameter(const link::ParameterRequest& request) override;
    void sendRead(const link::ReadRequest& request) override;

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
    modbus::ScanPlan::Depth m_scanDepth = modbus::ScanPlan::Depth::Diagnosis;
    bool m_isOld = false;
    modbus::JamState m_jamState = modbus::JamState::Armed;
    modbus::OrderStatus m_order{
        .state = modbus::OrderState::None, .action = modbus::OrderAction::None, .lot = {}};
    modbus::MeasureStatus m_measure{};
    std::optional<link::ReadRequest> m_filmRequest; // last request; answered again with every bag
    double m_cycleShare = 0;                        // share of the present bag
};

} // namespace campanel::looks
