// SPDX-License-Identifier: Apache-2.0
// A Link without a line: records requests and lets a test set the controller's answers. No thread.
#pragma once

#include "app/link/link.h"
#include "app/program/program_image.h"

namespace campanel::test {

class FakeLink : public link::Link {
    Q_OBJECT

public:
    using Link::Link;

    void connectTo(const link::ConnectionSettings& settings) override { connections << settings; }
    void download(const std::vector<std::uint16_t>& bank) override { banks << bank; }
    void cancelDownload() override { ++cancels; }
    void withdrawStop() override { ++withdrawals; }
    void setJog(link::JogDirection direction) override { jogs << direction; }
    void setPermit(std::uint16_t bits) override { permit = bits; }
    void compareProgram(const std::vector<std::uint16_t>& bank) override { comparisons << bank; }
    void cancelComparison() override { ++comparisonCancels; }
    void startScan(modbus::ScanPlan::Depth depth) override { scans << depth; }
    void cancelScan() override { ++scanCancels; }
    void simulateFaults(const QStringList& rules) override { faults << rules; }
    void measureSimulatedBag() override { ++rulers; }
    void watchFigures(bool isWatched) override { areFiguresWatched = isWatched; }
    void resetFigures() override { ++figuresResets; }
    void watchFrames(bool isWatched) override { areFramesWatched = isWatched; }

    QList<link::ConnectionSettings> connections;
    QList<link::CommandRequest> requests;
    QList<link::ParameterRequest> parameters;
    QList<std::vector<std::uint16_t>> banks;
    int cancels = 0;
    int withdrawals = 0;
    QList<link::JogDirection> jogs;
    std::uint16_t permit = 0;
    QList<link::ReadRequest> reads;
    QList<std::vector<std::uint16_t>> comparisons;
    int comparisonCancels = 0;
    QList<modbus::ScanPlan::Depth> scans;
    int scanCancels = 0;
    QList<QStringList> faults;
    int rulers = 0;
    bool areFiguresWatched = false;
    int figuresResets = 0;
    bool areFramesWatched = false;

    static modbus::Identity identity()
    {
        modbus::Identity identity;
        identity.deviceType = modbus::deviceType;
        identity.mapMajor = modbus::mapMajor;
        identity.uniqueId = 42;
        for (const program::KindInfo& kind : program::kinds())
            identity.programKinds =
                static_cast<std::uint16_t>(identity.programKinds | 1u << static_cast<unsigned>(kind.kind));
        identity.rowCapacity = modbus::rowCapacity;
        identity.bankRegisters = modbus::bankRegisters;
        identity.blockRegisters = modbus::blockRegisters;
        identity.timerClockHz = 8'000'000;
        identity.timerBits = 16;
        identity.maxPulseFrequencyHz = 200'000;
        return identity;
    }

    void becomeConnected()
    {
        link::LinkReport report;
        report.state = link::LinkState::Connected;
        report.portName = QStringLiteral("/dev/fake");
        report.simulator = link::SimulatorState::Serving;
        report.identity = identity();
        emit reported(report);
    }

    void becomeLost(std::optional<modbus::Command> pendingStop = std::nullopt)
    {
        link::LinkReport report;
        report.state = link::LinkState::Lost;
        report.portName = QStringLiteral("/dev/fake");
        report.simulator = link::SimulatorState::Serving;
        report.identity = identity();
        report.error = modbus::LinkError{modbus::LinkErrorKind::PortGone, "/dev/fake", {}, {}, 0};
        report.simulated = false;
        report.pendingStop = pendingStop;
        emit reported(report);
    }

    // Sends one status; `status` can be changed between two calls.
    void sendStatus(link::SteadyTime at)
    {
        link::StatusBatch batch;
        batch.samples << link::StatusSample{at, status};
        emit statusReceived(batch);
    }

    // Behaves as after a download of this program: the status names it, its header and knots are read.
    void activate(const program::ProgramImage& image, link::SteadyTime at)
    {
        ++status.generation;
        status.activeCrc = image.crc;
        status.programKind = static_cast<modbus::ProgramKind>(image.recipe.kind());
        if (status.state == modbus::State::Idle)
            status.state = modbus::State::Ready;
        sendStatus(at);
        const modbus::ListSpan span = modbus::listSpan(image.registers);
        const auto knots = image.registers.begin() + span.offset;
        emit programRead({status.generation,
                          image.crc,
                          {image.registers.begin(), image.registers.begin() + modbus::bankHeaderRegisters},
                          {knots, knots + span.count}});
    }

    modbus::StatusBlock status = idle();

protected:
    void sendCommand(const link::CommandRequest& request) override { requests << request; }
    void sendParameter(const link::ParameterRequest& request) override { parameters << request; }
    void sendRead(const link::ReadRequest& request) override { reads << request; }

private:
    static modbus::StatusBlock idle()
    {
        modbus::StatusBlock status;
        status.state = modbus::State::Idle;
        status.stagedState = modbus::StagedState::Empty;
        return status;
    }
};

} // namespace campanel::test
