// SPDX-License-Identifier: Apache-2.0
// The sentences for link errors.
#include "modbus/line/link_error.h"

#include "modbus/map/protocol.h"

#include <cstdio>

namespace campanel::modbus {
namespace {

std::string hex(int value)
{
    char text[16];
    std::snprintf(text, sizeof text, "0x%04X", static_cast<unsigned>(value));
    return text;
}

std::string describePort(const LinkError& error)
{
    switch (error.kind) {
    case LinkErrorKind::PortAbsent:
        return "The port " + error.port + " does not exist. Check the cable and the name of the port.";
    case LinkErrorKind::PortBusy:
        return "The port " + error.port +
               " is in use by another program. Close that program, then try again.";
    case LinkErrorKind::PortNotPermitted:
        return "No permission to open the port " + error.port + ". It belongs to the group '" + error.detail +
               "': add the user to it (usermod -aG " + error.detail + " USER) and log in again.";
    case LinkErrorKind::PortNotSerial:
        return error.port + " is not a serial port. Name a device such as /dev/ttyUSB0.";
    case LinkErrorKind::PortSettings:
        return "The port " + error.port + " cannot be used with these settings: " + error.detail;
    default:
        return {};
    }
}

std::string describeRequest(const LinkError& error)
{
    const std::string where = " (" + error.request + ", " + error.port + ")";
    switch (error.kind) {
    case LinkErrorKind::PortGone:
        return "The port " + error.port +
               " has gone: the adapter was unplugged or the controller's end was closed. Plug it in again.";
    case LinkErrorKind::NotOpen:
        return "The port " + error.port + " is not open.";
    case LinkErrorKind::NoAnswer:
        return "The controller does not answer" + where +
               ". Check its power, the cable, and that baud rate, parity, stop bits and unit number agree.";
    case LinkErrorKind::BadChecksum:
        return "The answer arrived damaged, its CRC-16 is wrong" + where +
               ". Check the cable's screen and length, and the parity setting.";
    case LinkErrorKind::BadFrame:
        return "The answer is not a valid frame" + where +
               ". Check that baud rate and parity agree and that no other device has the same unit number.";
    case LinkErrorKind::ForeignAnswer:
        return "An answer to another question arrived and was dropped" + where + ". Ask again.";
    case LinkErrorKind::Exception:
        return "The controller refused the request with Modbus exception " + std::to_string(error.code) +
               ", " + std::string(exceptionName(error.code)) + where + ".";
    case LinkErrorKind::RangeNotReadable:
        return "The controller has no such registers: " + error.detail + where + ".";
    case LinkErrorKind::CommandLost:
        return "The command did not reach the controller" + where + ". Nothing was done; give it again.";
    case LinkErrorKind::OutcomeUnknown:
        return "The connection broke while the command was under way" + where +
               "; whether it was carried out is not known. Look at the machine's state before giving it "
               "again.";
    case LinkErrorKind::ReadBackDiffers:
        return "The controller did not keep the value written: " + error.detail + where + ".";
    default:
        return error.detail;
    }
}

} // namespace

std::string_view exceptionName(int code)
{
    switch (code) {
    case 1:
        return "illegal function";
    case 2:
        return "illegal register address";
    case 3:
        return "illegal value";
    case 4:
        return "device failure";
    case 5:
        return "acknowledged, not yet done";
    case 6:
        return "device busy";
    default:
        return "unknown";
    }
}

std::string describe(const LinkError& error)
{
    if (error.kind == LinkErrorKind::NotCamPanel)
        return "The device at " + error.port + " answers, but is no CamPanel controller (" +
               (error.code == 0 ? "it has no identity registers"
                                : "its device type is " + hex(error.code) + ", not " + hex(deviceType)) +
               "). Nothing was written to it. Check the port and the unit number.";
    if (error.kind == LinkErrorKind::WrongMapMajor)
        return "The controller at " + error.port + " has register map " + std::to_string(error.code) +
               ", this program needs map " + std::to_string(mapMajor) + ". Update the " +
               (error.code < mapMajor ? "controller's firmware." : "panel's software.");
    if (error.kind == LinkErrorKind::WrongIdentity)
        return "The controller at " + error.port + " reports an impossible value: " + error.detail + " is " +
               std::to_string(error.code) + ". Correct its firmware.";
    const std::string port = describePort(error);
    return port.empty() ? describeRequest(error) : port;
}

bool portIsLost(const LinkError& error)
{
    return error.kind == LinkErrorKind::PortGone || error.kind == LinkErrorKind::NotOpen;
}

} // namespace campanel::modbus
