// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/doctor_sentences.h"

#include "app/panel/kit/format.h"

#include <QStringList>

namespace campanel::panel {

using modbus::LineCondition;

QString DoctorSentences::settings(const modbus::LineSettings& line, int unit)
{
    return tr("%1 baud, 8%2%3, unit %4", "parity letter, stop bits")
        .arg(line.baud)
        .arg(QChar::fromLatin1(static_cast<char>(line.parity)))
        .arg(line.stopBits)
        .arg(unit);
}

QString DoctorSentences::condition(LineCondition condition)
{
    switch (condition) {
    case LineCondition::Controller:
        return tr("Controller found");
    case LineCondition::WrongUnit:
        return tr("Controller at another unit number");
    case LineCondition::OtherMapVersion:
        return tr("Controller of another version");
    case LineCondition::OtherDevice:
        return tr("Another device");
    case LineCondition::Garbage:
        return tr("Only garbage");
    case LineCondition::NoBytes:
        return tr("No answer");
    case LineCondition::EchoOnly:
        return tr("Echo only");
    case LineCondition::PortAbsent:
        return tr("No such port");
    case LineCondition::PortNotPermitted:
        return tr("Not permitted");
    case LineCondition::PortBusy:
        return tr("In use by another program");
    case LineCondition::PortNotSerial:
        return tr("No serial port");
    case LineCondition::PortSettings:
        return tr("Settings not possible");
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
        text = tr("A CamPanel controller with firmware %1 answers.")
                   .arg(finding.identity ? QString::fromStdString(finding.identity->firmwareVersion())
                                         : Format::unknownText());
        break;
    case LineCondition::WrongUnit:
        text = tr("A CamPanel controller answers at unit %1, which is not the one that is set. Use this "
                  "connection, or set the unit number at the controller.")
                   .arg(finding.unit);
        break;
    case LineCondition::OtherMapVersion:
        text = tr("A CamPanel controller answers with register map version %1; this panel needs version %2. "
                  "Update the older of the two.")
                   .arg(finding.code)
                   .arg(modbus::mapMajor);
        break;
    case LineCondition::OtherDevice:
        text = tr("A device answers that is no CamPanel controller. Choose another port or unit number.");
        break;
    case LineCondition::Garbage:
        text = tr("%1 bytes came, but no answer could be read. Baud rate, parity or stop bits differ from "
                  "the controller's, or the cable picks up noise. Search for the controller; check shield "
                  "and ground.")
                   .arg(finding.bytesSeen);
        break;
    case LineCondition::NoBytes:
        text = tr("Not a single byte comes. Check that the controller has power and that the cable is "
                  "plugged in at both ends; on RS-232 the transmit and receive wires must be crossed, on "
                  "RS-485 A and B may be swapped.");
        break;
    case LineCondition::EchoOnly:
        text = tr(
            "The adapter returns what the panel sends, and no controller answers. Check that the controller "
            "has power, that the cable is plugged in at both ends, and that A and B are not swapped.");
        break;
    default:
        text = portFinding(finding);
    }
    if (finding.isLatencyTooLong())
        text = tr("%1 The USB adapter collects bytes for %2 ms before it hands them on, which slows the line "
                  "down: set its latency timer to 1 ms.",
                  "%1: whole sentence")
                   .arg(text)
                   .arg(*finding.latencyTimerMs);
    return text;
}

QString DoctorSentences::portFinding(const modbus::LineFinding& finding)
{
    switch (finding.condition) {
    case LineCondition::PortAbsent:
        return tr("This port is not there. Plug the adapter in, or choose another port in the settings.");
    case LineCondition::PortNotPermitted:
        return finding.group.empty()
                   ? tr("This user may not use the port. Ask the administrator for the right to use it.")
                   : tr("This user may not use the port. Add the user to the group \"%1\" and log in again.")
                         .arg(QString::fromStdString(finding.group));
    case LineCondition::PortBusy:
        return busy(finding);
    case LineCondition::PortNotSerial:
        return tr("This is no serial port. Choose another port in the settings.");
    case LineCondition::PortSettings:
        return tr("The port cannot be set up like this: %1. Choose other settings.")
            .arg(QString::fromStdString(finding.detail));
    case LineCondition::PortGone:
        return tr("The adapter disappeared while it was asked. Check its plug and cable.");
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
                                                 .arg(QString::fromStdString(holder.program))
                                                 .arg(holder.processId));
    return holders.isEmpty()
               ? tr("Another program has this port open. Close that program, or choose another port.")
               : tr("The port is held by %1. Close that program, or choose another port.")
                     .arg(holders.join(QStringLiteral(", ")));
}

QString DoctorSentences::progress(const modbus::ScanProgress& progress)
{
    constexpr int secondsOfMinute = 60;
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(progress.remaining).count();
    if (seconds > 2 * secondsOfMinute)
        return tr("%1 of %2, at most %3 min more")
            .arg(progress.done)
            .arg(progress.total)
            .arg((seconds + secondsOfMinute - 1) / secondsOfMinute);
    return tr("%1 of %2, at most %3 s more").arg(progress.done).arg(progress.total).arg(seconds);
}

} // namespace campanel::panel
