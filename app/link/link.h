// SPDX-License-Identifier: Apache-2.0
// The interface between the panel and the line: functions return at once, results arrive as replies and
// signals in the caller's thread. ThreadedLink is the real implementation; tests use a fake.
#pragma once

#include "app/link/link_events.h"

#include <QHash>
#include <QPointer>

#include <functional>

namespace campanel::link {

// Receives the one outcome of a request, unless its context was destroyed before.
template <class Outcome> struct Reply {
    QPointer<const QObject> context{};
    std::function<void(const Outcome&)> receive{};
};

class Link : public LinkEvents {
    Q_OBJECT

public:
    explicit Link(QObject* parent = nullptr);

    // Returns a number that no other request of this link has.
    [[nodiscard]] quint32 nextId() { return ++m_lastId; }

    // Closes the present connection, if any, and tries this one from now on.
    virtual void connectTo(const campanel::link::ConnectionSettings& settings) = 0;
    // Sends a command. A request without an id gets the next one.
    void request(CommandRequest request, const Reply<CommandOutcome>& reply = {});
    // Reads the physical value of a register with proof, or writes one into a register of the group
    // "parameter" and reads it back.
    void exchange(ParameterRequest request, const Reply<ParameterOutcome>& reply = {});
    // Reads registers. Reads alternate with the status polls and follow commands; at most 32 wait.
    void readRegisters(ReadRequest request, const Reply<ReadOutcome>& reply = {});
    // Stages the bank (header and rows), compares CRC-32 and applies it at the next cycle. Ends in exactly
    // one downloadReported() with stage Active, Failed or Canceled. A second download during the first fails
    // at once.
    virtual void download(const std::vector<std::uint16_t>& bank) = 0;
    virtual void cancelDownload() = 0;
    // Withdraws a Stop that waits for the line (LinkReport::pendingStop); it then ends as Withdrawn.
    virtual void withdrawStop() = 0;
    // Sets the jog key that is held. It is valid for `jogCounts` and must be repeated before that; None
    // releases it. Any Stop, a lost connection and a scan end it too. After these, and after the time has
    // expired, nothing moves before a None.
    virtual void setJog(campanel::link::JogDirection direction) = 0;

    // Sets what the panel permits (modbus::PermitBit), from the next exchange on and before any command but a
    // Stop. It is valid for `permitCounts` and must be repeated before that.
    virtual void setPermit(std::uint16_t bits) = 0;

    // Reads the whole active bank back and compares it with `bank`, the downloaded one. With an empty `bank`,
    // only its CRC-32 is compared with the controller's own. Ends in exactly one comparisonReported() with
    // another stage than Reading.
    virtual void compareProgram(const std::vector<std::uint16_t>& bank) = 0;
    virtual void cancelComparison() = 0;

    // Finds out why there is no connection, or searches for a controller on all ports. The connection is
    // closed during the scan and restored afterwards; a running scan is replaced. Ends in exactly one
    // scanReported() that is not running.
    virtual void startScan(campanel::modbus::ScanPlan::Depth depth) = 0;
    virtual void cancelScan() = 0;

    // Sets the rules of simulated line faults and the statements about the simulated machine, see
    // controller/README.md. They replace the earlier ones; an empty list clears them. They outlive a restart
    // of the controller, but not connectTo(). Ends in exactly one faultsSimulated(), at once while the
    // controller is not serving.
    virtual void simulateFaults(const QStringList& rules) = 0;

    // Measures the last bag of the simulated machine. Ends in exactly one rulerRead(), at once for a link
    // without a simulated machine.
    virtual void measureSimulatedBag() { emit rulerRead({RulerEnd::NotSimulated}); }

    // Requests one pingAnswered() with that number from the thread that serves the line. There is no answer
    // while that thread is blocked.
    virtual void ping(quint32 number) { emit pingAnswered(number); }

    // Starts or stops figuresReported(), once a second, the first one at once.
    virtual void watchFigures(bool isWatched) = 0;
    virtual void resetFigures() = 0;
    // Starts or stops framesRecorded(), ten times a second when there are frames; the first one has all
    // recorded frames.
    virtual void watchFrames(bool isWatched) = 0;

protected:
    // Send the request with its id. Each ends in exactly one commandEnded(), parameterEnded() or
    // registersRead() with that id, after the function has returned or within it.
    virtual void sendCommand(const campanel::link::CommandRequest& request) = 0;
    virtual void sendParameter(const campanel::link::ParameterRequest& request) = 0;
    virtual void sendRead(const campanel::link::ReadRequest& request) = 0;

private:
    template <class Outcome> using Waiting = QHash<quint32, Reply<Outcome>>;
    template <class Outcome> void deliver(Waiting<Outcome>& waiting, quint32 id, const Outcome& outcome)
    {
        const Reply<Outcome> reply = waiting.take(id);
        if (reply.context)
            reply.receive(outcome);
    }

    quint32 m_lastId = 0;
    Waiting<CommandOutcome> m_commands;
    Waiting<ParameterOutcome> m_parameters;
    Waiting<ReadOutcome> m_reads;
};

} // namespace campanel::link
