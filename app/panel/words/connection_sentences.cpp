// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/connection_sentences.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/controller_sentences.h"
#include "app/panel/words/register_words.h"

using namespace Qt::StringLiterals;

namespace campanel::panel {

using link::CommandEnd;
using link::LinkState;
using modbus::LinkErrorKind;

namespace {

// Returns true for errors of bytes that were received: the line is not silent.
bool isOfBytes(LinkErrorKind kind)
{
    return kind == LinkErrorKind::BadChecksum || kind == LinkErrorKind::BadFrame ||
           kind == LinkErrorKind::ForeignAnswer || kind == LinkErrorKind::Exception;
}

} // namespace

QString ConnectionSentences::connection(const link::LinkReport& report, const QDateTime& lostAt)
{
    if (report.isScanning)
        return tr("The diagnostics are using the ports. The panel reconnects when they have finished.");
    if (report.state == LinkState::Connected)
        return report.simulated ? tr("Connected to the simulated controller.")
                                : tr("Connected to the controller on %1.").arg(report.portName);
    if (report.simulated && report.simulator != link::SimulatorState::Serving)
        return simulator(report);
    if (report.error && !report.simulated && report.error->port.empty())
        return tr("No controller is selected. Select one on the Settings page, under Connection.");
    if (report.state == LinkState::Lost)
        return lost(report, Format::local(lostAt, QStringLiteral("HH:mm:ss")));
    if (report.error)
        return error(*report.error);
    if (report.state == LinkState::Connecting)
        return tr("Identifying the controller on %1 …").arg(report.portName);
    return tr("Searching for port %1 …").arg(report.portName);
}

QString ConnectionSentences::lost(const link::LinkReport& report, const QString& since)
{
    const bool isPortGone = report.error && (report.error->kind == LinkErrorKind::PortAbsent ||
                                             report.error->kind == LinkErrorKind::PortGone);
    if (report.simulated)
        return tr("No connection since %1 to the simulated controller on %2. The panel reconnects "
                  "automatically.")
            .arg(since, report.portName);
    if (isPortGone)
        return report.hasSerialNumber
                   ? tr("No connection since %1: port %2 was removed. Plug the adapter in again; the "
                        "panel finds it under any name and reconnects automatically.")
                         .arg(since, report.portName)
                   : tr("No connection since %1: port %2 was removed. Plug the adapter into the same socket; "
                        "the panel reconnects automatically.")
                         .arg(since, report.portName);
    if (report.error && isOfBytes(report.error->kind))
        return tr("No connection since %1. %2", "time, %2: whole sentences").arg(since, error(*report.error));
    return tr("No connection since %1: no response on %2. Check the cable and the controller's power; the "
              "panel reconnects automatically.")
        .arg(since, report.portName);
}

QString ConnectionSentences::simulator(const link::LinkReport& report)
{
    switch (report.simulator) {
    case link::SimulatorState::NotFound:
        return tr("The simulated controller was not found at %1. Install it, or choose a serial port in the "
                  "settings.")
            .arg(report.simulatorDetail);
    case link::SimulatorState::Ended:
        return report.simulatorDetail.isEmpty()
                   ? tr("The simulated controller has stopped and is restarting.")
                   : tr("The simulated controller has stopped and is restarting. Its output: %1")
                         .arg(report.simulatorDetail);
    case link::SimulatorState::NotUsed:
    case link::SimulatorState::Starting:
    case link::SimulatorState::Serving:
        break;
    }
    return tr("The simulated controller is starting …");
}

QString ConnectionSentences::error(const modbus::LinkError& error)
{
    const QString port = QString::fromStdString(error.port);
    const QString detail = QString::fromStdString(error.detail);
    switch (error.kind) {
    case LinkErrorKind::PortAbsent:
        return tr("Port %1 does not exist. Plug the adapter in, or choose another port in the settings.")
            .arg(port);
    case LinkErrorKind::PortBusy:
        return tr("Another program is using port %1. Close that program, or choose another port.").arg(port);
    case LinkErrorKind::PortNotPermitted:
        return detail.isEmpty()
                   ? tr("This user has no right to use port %1. Ask the administrator for this right.")
                         .arg(port)
                   : tr("This user has no right to use port %1. Add the user to the group \"%2\" and log in "
                        "again.")
                         .arg(port, detail);
    case LinkErrorKind::PortNotSerial:
        return tr("%1 is not a serial port. Choose another port in the settings.").arg(port);
    case LinkErrorKind::PortSettings:
        return tr("Port %1 cannot be set up: %2. Choose other settings.").arg(port, detail);
    case LinkErrorKind::PortGone:
    case LinkErrorKind::NotOpen:
        return tr("Port %1 was removed. Plug the adapter in again.").arg(port);
    case LinkErrorKind::NoAnswer:
        return tr("No response on %1. Check cable, power, baud rate, parity and unit number.").arg(port);
    case LinkErrorKind::BadChecksum:
    case LinkErrorKind::BadFrame:
        if (error.code > 0)
            return tr("Stray bytes behind a response on %1. Check the bias resistors, and the switching "
                      "between "
                      "sending and receiving.")
                .arg(port);
        return tr("Invalid data on %1. Check baud rate, parity and stop bits.").arg(port);
    case LinkErrorKind::ForeignAnswer:
        return tr("Responses on %1 belong to other requests. Check for another master on the line.")
            .arg(port);
    case LinkErrorKind::Exception:
        return exception(port, error.code);
    case LinkErrorKind::NotCamPanel:
        return tr("The device on %1 is not a CamPanel controller. Choose another port or unit number.")
            .arg(port);
    case LinkErrorKind::WrongMapMajor:
        return tr("The controller on %1 has register map version %2, not %3. Update the older device.")
            .arg(port, QString::number(error.code), QString::number(modbus::mapMajor));
    case LinkErrorKind::WrongIdentity:
        return tr("The controller on %1 reports an impossible value: %2 is %3. Update its firmware.")
            .arg(port, detail, QString::number(error.code));
    case LinkErrorKind::RangeNotReadable:
        return tr("The controller on %1 lacks required registers. Update its firmware.").arg(port);
    case LinkErrorKind::CommandLost:
        return tr("The controller did not receive the command. Try again.");
    case LinkErrorKind::OutcomeUnknown:
        return tr("It is unknown whether the controller received the command. Check the machine before you "
                  "try again.");
    case LinkErrorKind::ReadBackDiffers:
        return tr("The controller stored a different value. Try again.");
    case LinkErrorKind::ValueRefused:
        return error.limits ? RegisterWords::outOfRange(*error.limits)
                            : tr("The controller does not allow this access to %1.")
                                  .arg(QString::fromStdString(error.request));
    }
    return {};
}

QString ConnectionSentences::exception(const QString& port, int code)
{
    const QString number = QString::number(code);
    switch (code) {
    case 4:
    case 8:
        return tr("The device on %1 reports a failure (Modbus exception %2). Restart the device.")
            .arg(port, number);
    case 5:
    case 6:
        return tr("The device on %1 is busy (Modbus exception %2). Wait, or restart the device.")
            .arg(port, number);
    case 10:
    case 11:
        return tr("The gateway on %1 gets no response from the controller (Modbus exception %2). Check the "
                  "unit number, and the line behind the gateway.")
            .arg(port, number);
    default:
        return tr("The device on %1 refuses the request (Modbus exception %2). Check that it is a CamPanel "
                  "controller.")
            .arg(port, number);
    }
}

QString ConnectionSentences::commandName(modbus::Command command)
{
    const QString name = ControllerSentences::text(command);
    return name.isEmpty() ? tr("Command") : name;
}

QString ConnectionSentences::refused(modbus::Command command, modbus::Refusal reason)
{
    return tr("%1 was refused. %2", "%1: command, %2: whole sentence")
        .arg(commandName(command), ControllerSentences::refusal(reason));
}

QString ConnectionSentences::command(const link::CommandOutcome& outcome)
{
    const QString name = commandName(outcome.command);
    switch (outcome.end) {
    case CommandEnd::Done:
    case CommandEnd::Withdrawn: // the user already knows
        return {};
    case CommandEnd::Refused:
        return refused(outcome.command, outcome.reason);
    case CommandEnd::NotSent:
        return tr("%1 was not sent: there is no connection to the controller.").arg(name);
    case CommandEnd::NotReceived:
        return tr("%1 did not reach the controller. Try again.").arg(name);
    case CommandEnd::OutcomeUnknown:
        return tr("%1 was sent, but no response was received. Check the machine before you try again.")
            .arg(name);
    }
    return {};
}

QString ConnectionSentences::outcomeKey(const link::CommandOutcome& outcome)
{
    switch (outcome.end) {
    case CommandEnd::Done:
        return u"done"_s;
    case CommandEnd::Refused:
        return u"refused %1"_s.arg(static_cast<int>(outcome.reason));
    case CommandEnd::NotSent:
        return u"not_sent"_s;
    case CommandEnd::NotReceived:
        return u"not_received"_s;
    case CommandEnd::Withdrawn:
        return u"withdrawn"_s;
    case CommandEnd::OutcomeUnknown:
        break;
    }
    return u"unknown"_s;
}

QString ConnectionSentences::parameter(const QString& what, const link::ParameterOutcome& outcome)
{
    switch (outcome.end) {
    case link::ParameterEnd::Done:
        return {};
    case link::ParameterEnd::NotSent:
        return tr("%1 was not changed: there is no connection to the controller.").arg(what);
    case link::ParameterEnd::Refused:
        return tr("%1 was not changed. %2", "%2: whole sentence")
            .arg(what, outcome.error ? error(*outcome.error) : QString());
    case link::ParameterEnd::OutcomeUnknown:
        return tr("%1 was sent, but not confirmed. Check the machine before you try again.").arg(what);
    }
    return {};
}

QString ConnectionSentences::download(const link::DownloadReport& report)
{
    if (report.isConnectionMissing)
        return tr("Not downloaded: there is no connection to the controller.");
    if (report.isBusy)
        return tr("Not downloaded: another download is in progress.");
    switch (report.stage) {
    case link::DownloadStage::Transferring:
        return report.isInterrupted
                   ? tr("The connection is lost. The download continues when it is restored.")
                   : tr("Sending the table …");
    case link::DownloadStage::Sealing:
        return tr("The controller is checking the table …");
    case link::DownloadStage::Armed:
        return tr("Checked. The program becomes active at the end of the cycle.");
    case link::DownloadStage::Active:
        return tr("The controller has this program.");
    case link::DownloadStage::Canceled:
        return tr("Canceled. The controller's program is unchanged.");
    case link::DownloadStage::Failed:
        break;
    }
    return report.error ? error(*report.error) : QString();
}

QString ConnectionSentences::error(const modbus::DownloadError& error)
{
    using modbus::DownloadErrorKind;
    switch (error.kind) {
    case DownloadErrorKind::Link:
        return tr("Download failed; the controller's program is unchanged. %1", "%1: whole sentence")
            .arg(ConnectionSentences::error(error.link));
    case DownloadErrorKind::ImageTooLong:
        return tr("The table needs %1 registers, the controller has %2; its program is unchanged. Use fewer "
                  "slices per ramp.")
            .arg(QString::number(error.actual), QString::number(error.expected));
    case DownloadErrorKind::KindNotSupported:
        return tr("This controller cannot execute this kind of program; its program is unchanged. Update its "
                  "firmware.");
    case DownloadErrorKind::IntervalsNotSupported:
        return tr("This controller cannot execute intervals; its program is unchanged. Choose cam points.");
    case DownloadErrorKind::TransferRefused:
        return tr("The controller refused the table; its program is unchanged. %1", "%1: whole sentence")
            .arg(ControllerSentences::transferResult(error.transfer));
    case DownloadErrorKind::ChecksumDiffers:
    case DownloadErrorKind::RowsDiffer:
        return tr("The received data differ from the sent data; the controller's program is unchanged. "
                  "Download again.");
    case DownloadErrorKind::CommandRefused:
        return tr("The controller did not apply the table; its program is unchanged. %1",
                  "%1: whole sentence")
            .arg(ControllerSentences::refusal(error.refusal));
    case DownloadErrorKind::Withdrawn:
        return tr("The change was withdrawn before it became active; the controller's program is unchanged.");
    }
    return {};
}

} // namespace campanel::panel
