// SPDX-License-Identifier: Apache-2.0
// The English sentences of the findings.
#include "modbus/line/line_scan.h"

#include <cstdio>

namespace campanel::modbus {
namespace {

std::string lineText(const LineFinding& finding)
{
    char text[64];
    std::snprintf(text, sizeof text, "%u baud 8%c%u, unit %d", finding.line.baud,
                  static_cast<char>(finding.line.parity), static_cast<unsigned>(finding.line.stopBits),
                  finding.unit);
    return text;
}

std::string busyText(const LineFinding& finding)
{
    std::string text = "The port " + finding.port + " is in use by ";
    if (finding.holders.empty())
        return text.append("another user's program. Close that program, then try again.");
    bool isFirst = true;
    for (const PortHolder& holder : finding.holders) {
        text.append(isFirst ? "" : " and ").append(holder.program.empty() ? "a program" : holder.program);
        text.append(" (process ").append(std::to_string(holder.processId)).append(")");
        isFirst = false;
    }
    return text.append(". Close that program, then try again.");
}

std::string answerText(const LineFinding& finding)
{
    const std::string where = finding.port + " with " + lineText(finding);
    switch (finding.condition) {
    case LineCondition::Controller:
        return "A CamPanel controller, firmware " +
               (finding.identity ? finding.identity->firmwareVersion() : std::string("unknown")) +
               ", responds at " + where + ".";
    case LineCondition::WrongUnit:
        return "The controller responds at " + where + ": set the unit number to " +
               std::to_string(finding.unit) + ".";
    case LineCondition::OtherMapVersion:
        return "The controller at " + where + " has register map " + std::to_string(finding.code) +
               ", this program needs map " + std::to_string(mapMajor) + ". Update the " +
               (finding.code < mapMajor ? "controller's firmware." : "panel's software.");
    default:
        return "A device other than a CamPanel controller responds at " + where +
               ". Nothing was written to it. Check the cable, the port and the unit number.";
    }
}

std::string silenceText(const LineFinding& finding)
{
    if (finding.condition == LineCondition::Garbage)
        return "Invalid data at " + finding.port + " (" + std::to_string(finding.bytesSeen) +
               " bytes). Check baud rate and parity, or search for the settings; then check shield and "
               "ground.";
    if (finding.condition == LineCondition::EchoOnly)
        return "The adapter echoes the requests at " + finding.port +
               ", and no controller responds. Check the controller's power, the cable, and A and B.";
    return "No data at " + finding.port +
           ". Check the controller's power and the cable; transmit and receive must be crossed.";
}

} // namespace

std::string describe(const LineFinding& finding)
{
    std::string text;
    switch (finding.condition) {
    case LineCondition::Controller:
    case LineCondition::WrongUnit:
    case LineCondition::OtherMapVersion:
    case LineCondition::OtherDevice:
        text = answerText(finding);
        break;
    case LineCondition::Garbage:
    case LineCondition::NoBytes:
    case LineCondition::EchoOnly:
        text = silenceText(finding);
        break;
    case LineCondition::PortBusy:
        text = busyText(finding);
        break;
    case LineCondition::PortNotPermitted:
        text = "No permission to open the port " + finding.port + ". It belongs to the group '" +
               finding.group + "': run \"" + joinGroupCommand(finding.group) + "\" and log in again.";
        break;
    case LineCondition::PortAbsent:
        text = describe(LinkError{LinkErrorKind::PortAbsent, finding.port, {}, {}, 0});
        break;
    case LineCondition::PortNotSerial:
        text = describe(LinkError{LinkErrorKind::PortNotSerial, finding.port, {}, {}, 0});
        break;
    case LineCondition::PortSettings:
        text = describe(LinkError{LinkErrorKind::PortSettings, finding.port, {}, finding.detail, 0});
        break;
    case LineCondition::PortGone:
        text = describe(LinkError{LinkErrorKind::PortGone, finding.port, {}, {}, 0});
        break;
    }
    if (finding.isLatencyTooLong())
        text.append(" The adapter's latency timer is ")
            .append(std::to_string(*finding.latencyTimerMs))
            .append(" ms, which slows every exchange: run \"")
            .append(lowerLatencyCommand(finding.port))
            .append("\".");
    return text;
}

} // namespace campanel::modbus
