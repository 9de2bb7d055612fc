// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/doctor_sentences.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/connection_sentences.h"

#include <QStringList>

namespace campanel::panel {

using modbus::LineCondition;

QString DoctorSentences::settings(const modbus::LineSettings& line, int unit)
{
    return tr("%1 baud, 8%2%3, unit %4", "parity letter, stop bits")
        .arg(QString::number(line.baud), QChar::fromLatin1(static_cast<char>(line.parity)),
             QString::number(line.stopBits), QString::number(unit));
}

QString DoctorSentences::condition(LineCondition condition)
{
    switch (condition) {
    case LineCondition::Controller:
        return tr("Controller found");
    case LineCondition::WrongUnit:
        return tr("Controller at another unit number");
    case LineCondition::OtherMapVersion:
        return tr("Controller with another version");
    case LineCondition::OtherDevice:
        return tr("Another device");
    case LineCondition::Garbage:
        return tr("Invalid data");
    case LineCondition::NoBytes:
        return tr("No response");
    case LineCondition::EchoOnly:
        return tr("Echo only");
    case LineCondition::Refused:
        return tr("Error response");
    case LineCondition::PortAbsent:
        return tr("Port does not exist");
    case LineCondition::PortNotPermitted:
        return tr("Permission denied");
    case LineCondition::PortBusy:
        return tr("In use by another program");
    case LineCondition::PortNotSerial:
        return tr("Not a serial port");
    case LineCondition::PortSettings:
        return tr("Settings not supported");
    case LineCondition::PortGone:
        return tr("Unplugged");
    }
    return {};
}

QString DoctorSentences::finding(const modbus::LineFinding& finding)
{
    QString text;
    switch (finding.condition) {
    case LineCondition::Controller:
        text = tr("A CamPanel controller with firmware %1 responds.")
                   .arg(finding.identity ? QString::fromStdString(finding.identity->firmwareVersion())
                                         : Format::unknownText());
        break;
    case LineCondition::WrongUnit:
        text = tr("A CamPanel controller responds at unit number %1, which differs from the setting. Use "
                  "this connection, or set the unit number at the controller.")
                   .arg(finding.unit);
        break;
    case LineCondition::OtherMapVersion:
        text = tr("A CamPanel controller responds with register map version %1, not %2. Update the older "
                  "device.")
                   .arg(QString::number(finding.code), QString::number(modbus::mapMajor));
        break;
    case LineCondition::OtherDevice:
        text = tr("The responding device is not a CamPanel controller. Choose another port or unit number.");
        break;
    case LineCondition::Garbage:
        text = tr("%1 bytes were received, but no valid response. Check baud rate, parity and stop bits, or "
                  "search for the controller; then check shield and ground.")
                   .arg(finding.bytesSeen);
        break;
    case LineCondition::NoBytes:
        text = tr("No data was received. Check the controller's power and both ends of the cable; on RS-232 "
                  "cross the transmit and receive wires, on RS-485 check A and B.");
        break;
    case LineCondition::EchoOnly:
        text = tr("The adapter echoes the requests, and no controller responds. Check the "
                  "controller's power, both ends of the cable, and A and B.");
        break;
    case LineCondition::Refused:
        text = ConnectionSentences::exception(QString::fromStdString(finding.port), finding.code);
        break;
    default:
        text = portFinding(finding);
    }
    if (finding.strayBytes > 0)
        text = tr("%1 The line adds stray bytes to the responses (%2). Check the bias resistors, and the "
                  "switching between sending and receiving.",
                  "%1: whole sentence")
                   .arg(text, QString::number(finding.strayBytes));
    if (finding.isLatencyTooLong())
        text = tr("%1 The USB adapter delays data by %2 ms: set its latency timer to 1 ms.",
                  "%1: whole sentence")
                   .arg(text, QString::number(*finding.latencyTimerMs));
    return text;
}

QString DoctorSentences::portFinding(const modbus::LineFinding& finding)
{
    switch (finding.condition) {
    case LineCondition::PortAbsent:
        return tr("This port does not exist. Plug the adapter in, or choose another port in the settings.");
    case LineCondition::PortNotPermitted:
        return finding.group.empty()
                   ? tr("This user has no right to use the port. Ask the administrator for this right.")
                   : tr("This user has no right to use the port. Add the user to the group \"%1\" and log in "
                        "again.")
                         .arg(QString::fromStdString(finding.group));
    case LineCondition::PortBusy:
        return busy(finding);
    case LineCondition::PortNotSerial:
        return tr("This is not a serial port. Choose another port in the settings.");
    case LineCondition::PortSettings:
        return tr("The port cannot be set up: %1. Choose other settings.")
            .arg(QString::fromStdString(finding.detail));
    case LineCondition::PortGone:
        return tr("The adapter was removed during the test. Check its plug and cable.");
    default:
        return {};
    }
}

QString DoctorSentences::busy(const modbus::LineFinding& finding)
{
    QStringList holders;
    for (const modbus::PortHolder& holder : finding.holders)
        holders << (holder.program.empty() ? tr("process %1").arg(holder.processId)
                                           : tr("%1 (process %2)")
                                                 .arg(QString::fromStdString(holder.program),
                                                      QString::number(holder.processId)));
    return holders.isEmpty()
               ? tr("Another program is using this port. Close that program, or choose another port.")
               : tr("The port is in use by %1. Close that program, or choose another port.")
                     .arg(holders.join(QStringLiteral(", ")));
}

QString DoctorSentences::progress(const modbus::ScanProgress& progress)
{
    constexpr int secondsOfMinute = 60;
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(progress.remaining).count();
    if (seconds > 2 * secondsOfMinute)
        return tr("%1 of %2, max. %3 min left")
            .arg(QString::number(progress.done), QString::number(progress.total),
                 QString::number((seconds + secondsOfMinute - 1) / secondsOfMinute));
    return tr("%1 of %2, max. %3 s left")
        .arg(QString::number(progress.done), QString::number(progress.total), QString::number(seconds));
}

} // namespace campanel::panel
