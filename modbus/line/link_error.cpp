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
        return "The port " + error.port + " was removed or closed. Plug the adapter in again.";
    case LinkErrorKind::NotOpen:
        return "The port " + error.port + " is not open.";
    case LinkErrorKind::NoAnswer:
        return "No response from the controller" + where +
               ". Check power, cable, baud rate, parity, stop bits and unit number.";
    case LinkErrorKind::BadChecksum:
        return "The response has a wrong checksum" + where +
               ". Check the cable's shield and length, and the parity setting.";
    case LinkErrorKind::BadFrame:
        return "The response is not a valid frame" + where +
               ". Check baud rate, parity and other devices with the same unit number.";
    case LinkErrorKind::ForeignAnswer:
        return "A response to another request was dropped" + where + ". Try again.";
    case LinkErrorKind::Exception:
        return "The controller refused the request with Modbus exception " + std::to_string(error.code) +
               ", " + std::string(exceptionName(error.code)) + where + ".";
    case LinkErrorKind::RangeNotReadable:
        return "The controller lacks registers: " + error.detail + where + ".";
    case LinkErrorKind::CommandLost:
        return "The command did not reach the controller" + where + ". Try again.";
    case LinkErrorKind::OutcomeUnknown:
        return "The connection was lost during the command" + where +
               "; its result is unknown. Check the machine before you try again.";
    case LinkErrorKind::ReadBackDiffers:
        return "The controller stored a different value: " + error.detail + where + ".";
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
        return "acknowledged, in progress";
    case 6:
        return "device busy";
    default:
        return "unknown";
    }
}

std::string describe(const LinkError& error)
{
    if (error.kind == LinkErrorKind::NotCamPanel)
        return "The device at " + error.port + " is not a CamPanel controller (" +
               (error.code == 0 ? "it has no identity registers"
                                : "its device type is " + hex(error.code) + ", not " + hex(deviceType)) +
               "). Nothing was written to it. Check the port and the unit number.";
    if (error.kind == LinkErrorKind::WrongMapMajor)
        return "The controller at " + error.port + " has register map " + std::to_string(error.code) +
               ", this program needs map " + std::to_string(mapMajor) + ". Update the " +
               (error.code < mapMajor ? "controller's firmware." : "panel's software.");
    if (error.kind == LinkErrorKind::WrongIdentity)
        return "The controller at " + error.port + " reports an impossible value: " + error.detail + " is " +
               std::to_string(error.code) + ". Update its firmware.";
    const std::string port = describePort(error);
    return port.empty() ? describeRequest(error) : port;
}

bool portIsLost(const LinkError& error)
{
    return error.kind == LinkErrorKind::PortGone || error.kind == LinkErrorKind::NotOpen;
}

} // namespace campanel::modbus
