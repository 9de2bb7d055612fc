// SPDX-License-Identifier: Apache-2.0
// Why a request, or the opening of a port, did not end well. Everything a translated sentence needs is in the
// fields; describe() is the English one and says what to do.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace campanel::modbus {

enum class LinkErrorKind : std::uint8_t {
    PortAbsent,       // no such device node
    PortBusy,         // another program has it
    PortNotPermitted, // `detail` is the group that owns the node
    PortNotSerial,    // exists, but is no serial port
    PortSettings,     // `detail` says which setting cannot be used
    PortGone,         // was open, has been unplugged or its other end has ended
    NotOpen,          // asked before open() or after close()
    NoAnswer,         // nothing, or not all of it, within the time allowed
    BadChecksum,      // CRC-16
    BadFrame,         // wrong length or function, a line that does not take bytes
    ForeignAnswer,    // the answer to another question: dropped
    Exception,        // `code` is the Modbus exception code
    NotCamPanel,      // another device; `code` is its identity.device_type, 0 when it has none
    WrongMapMajor,    // `code` is its register-map major version
    WrongIdentity,    // `detail` is the identity register whose value is impossible, `code` the value
    RangeNotReadable, // the controller has no such registers
    CommandLost,      // the controller did not receive the command, `code` is its counter
    OutcomeUnknown,   // whether the command was received could not be found out; `code` is its counter
    ReadBackDiffers,  // a parameter was written but reads back as something else
    ValueRefused,     // outside the register's limits; `detail` says so
};

struct LinkError {
    LinkErrorKind kind = LinkErrorKind::NoAnswer;
    std::string port;
    std::string request; // what was asked, "status" or "start", empty for the port itself
    std::string detail;
    int code = 0;
};

// One or two sentences: what is wrong, where, and what to do.
[[nodiscard]] std::string describe(const LinkError& error);

// "illegal register address"; "unknown" for codes without a name.
[[nodiscard]] std::string_view exceptionName(int code);

// True when the port must be closed and looked for again.
[[nodiscard]] bool portIsLost(const LinkError& error);

} // namespace campanel::modbus
