// SPDX-License-Identifier: Apache-2.0
// A Link to the controller's core on simulated time: requests are answered at once by the core of a rig, and
// pass() lets time go on, with statuses, heartbeats and the panel's reading of the film as on a line.
#pragma once

#include "controller/rig.h"
#include "fake_link.h"
#include "modbus/line/wire_time.h"
#include "modbus/map/blocks.h"
#include "modbus/map/codec.h"

#include <QTimer>

#include <memory>

namespace campanel::test {

class CoreLink : public FakeLink {
public:
    static constexpr std::uint64_t stepUs = 50'000;
    static constexpr std::uint64_t filmPeriodUs = 150'000;

    explicit CoreLink(std::unique_ptr<Rig> rig)
        : m_rig(std::move(rig))
    {
    }

    [[nodiscard]] Rig& rig() { return *m_rig; }
    [[nodiscard]] link::SteadyTime now()
    {
        return m_epoch + std::chrono::microseconds(m_rig->controller().nowUs());
    }
    [[nodiscard]] bool isConnected() const { return m_isConnected; }

    // Starts or ends the connection, which the panel learns at once.
    void setConnected(bool isConnected)
    {
        m_isConnected = isConnected;
        link::LinkReport report;
        report.state = isConnected ? link::LinkState::Connected : link::LinkState::Lost;
        report.portName = QStringLiteral("/dev/rig");
        report.simulator = link::SimulatorState::Serving;
        report.identity = identity();
        report.identity->mapMinor = modbus::mapMinor;
        m_isProgramKnown = false;
        emit reported(report);
    }
    // Replaces the controller by one that has just been powered up; the time goes on.
    void powerUp(std::unique_ptr<Rig> rig)
    {
        m_epoch = now();
        m_rig = std::move(rig);
    }
    // Lets the film be read, as the panel's own timer does in real time.
    void setFilmTimer(QTimer* timer) { m_filmTimer = timer; }

    // One step of simulated time with what the panel learns in it.
    void step()
    {
        if (m_isConnected)
            m_rig->heartbeat(0, permit);
        m_rig->run(stepUs);
        m_sinceFilmUs += stepUs;
        if (!m_isConnected)
            return;
        readStatus();
        if (m_filmTimer && m_sinceFilmUs >= filmPeriodUs) {
            m_sinceFilmUs = 0;
            QMetaObject::invokeMethod(m_filmTimer, "timeout", Qt::DirectConnection);
        }
    }

    void download(const std::vector<std::uint16_t>& bank) override
    {
        ++m_session;
        link::DownloadReport report;
        report.crc = crc32(bank);
        const bool isSealed = m_rig->download(bank, m_session) == CTL_TRANSFER_RESULT_ACCEPTED;
        const bool isArmed =
            isSealed && m_rig->apply(bank, CTL_APPLY_MODE_NEXT_CYCLE, m_session) == CTL_REFUSAL_NONE;
        report.stage = isArmed ? link::DownloadStage::Armed : link::DownloadStage::Failed;
        m_awaited = isArmed ? std::optional(report) : std::nullopt;
        emit downloadReported(report);
    }

protected:
    void sendCommand(const link::CommandRequest& request) override
    {
        FakeLink::sendCommand(request);
        m_rig->heartbeat(0, permit);
        link::CommandOutcome outcome;
        outcome.id = request.id;
        outcome.command = request.command;
        outcome.reason = static_cast<modbus::Refusal>(
            m_rig->command(static_cast<std::uint16_t>(request.command), request.arguments.argument0,
                           request.arguments.argument1, request.arguments.argument2));
        outcome.end =
            outcome.reason == modbus::Refusal::None ? link::CommandEnd::Done : link::CommandEnd::Refused;
        emit commandEnded(outcome);
    }
    void sendParameter(const link::ParameterRequest& request) override
    {
        const modbus::RegisterInfo& info = *modbus::findRegister(request.name);
        link::ParameterOutcome outcome{request.id, request.name, link::ParameterEnd::NotSent, {}, {}};
        if (m_isConnected) {
            if (request.value)
                write(info, *request.value);
            const Registers registers = m_rig->read(info.address, info.count);
            outcome.end = link::ParameterEnd::Done;
            outcome.value = modbus::RegisterReader(registers, info.address).physical(info);
        }
        // Queued as on a line.
        QMetaObject::invokeMethod(
            this, [this, outcome] { emit parameterEnded(outcome); }, Qt::QueuedConnection);
    }
    void sendRead(const link::ReadRequest& request) override
    {
        const Registers registers = m_isConnected ? m_rig->read(request.address, request.count) : Registers();
        emit registersRead({request, registers.empty() ? link::ReadEnd::NotSent : link::ReadEnd::Done,
                            registers, now(), std::nullopt});
    }

private:
    void write(const modbus::RegisterInfo& info, double value)
    {
        Registers registers(info.count);
        if (!modbus::RegisterWriter(registers, info.address).physical(info, value) ||
            m_rig->write(info.address, registers) != 0)
            qFatal("%s cannot be %g", std::string(info.name).c_str(), value);
    }
    void readStatus()
    {
        status = modbus::decodeStatus(m_rig->read(modbus::statusAddress, modbus::statusRegisters));
        sendStatus(now());
        if (!m_isProgramKnown || m_generation != status.generation || m_crc != status.activeCrc)
            readProgram();
        if (m_awaited && status.activeCrc == m_awaited->crc) {
            link::DownloadReport report = *std::exchange(m_awaited, std::nullopt);
            report.stage = link::DownloadStage::Active;
            emit downloadReported(report);
        }
    }
    // The header comes with the status after the one that names the program.
    void readProgram()
    {
        m_isProgramKnown = m_generation == status.generation && m_crc == status.activeCrc;
        m_generation = status.generation;
        m_crc = status.activeCrc;
        if (!m_isProgramKnown)
            return;
        link::ActiveProgram program{status.generation, status.activeCrc.value_or(0), {}};
        if (status.activeCrc) {
            const ctl_bank* bank = ctl_active_bank(&m_rig->core().banks);
            program.header.assign(bank->registers, bank->registers + modbus::bankHeaderRegisters);
            const modbus::ListSpan span = modbus::listSpan(program.header);
            program.list.assign(bank->registers + span.offset, bank->registers + span.offset + span.count);
        }
        emit programRead(program);
    }

    std::unique_ptr<Rig> m_rig;
    link::SteadyTime m_epoch{std::chrono::hours(1)};
    bool m_isConnected = false;
    QTimer* m_filmTimer = nullptr;
    std::uint64_t m_sinceFilmUs = 0;
    std::uint16_t m_session = 0;
    std::optional<link::DownloadReport> m_awaited;
    bool m_isProgramKnown = false;
    std::uint32_t m_generation = 0;
    std::optional<std::uint32_t> m_crc;
};

} // namespace campanel::test
