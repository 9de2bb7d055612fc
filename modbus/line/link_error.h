// SPDX-License-Identifier: Apache-2.0
// The reason why a request, or opening a port, failed. The fields hold everything a translated sentence
// needs.
#pragma once

#include "modbus/map/codec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace campanel::modbus {

enum class LinkErrorKind : std::uint8_t {
    PortAbsent,       // no such device node
    PortBusy,         // in use by another program
    PortNotPermitted, // `detail` is the group that owns the node
    PortNotSerial,    // exists, but is not a serial port
    PortSettings,     // `detail` names the unsupported setting
    PortGone,         // unplugged, or its other end was closed
    NotOpen,          // used before open() or after close()
    NoAnswer,         // no answer, or an incomplete one, within the time allowed
    BadChecksum,      // CRC-16
    BadFrame,         // wrong length or function, a line that does not accept bytes, or an answer that was
                      // dropped for the bytes behind it; `code` is their number then
    ForeignAnswer,    // the answer to another question: dropped
    Exception,        // `code` is the Modbus exception code
    NotCamPanel,      // another device; `code` is its identity.device_type, 0 when it has none
    WrongMapMajor,    // `code` is its register-map major version
    WrongIdentity,    // `detail` is the identity register whose value is impossible, `code` the value
    RangeNotReadable, // the controller has no such registers
    CommandLost,      // the controller did not receive the command, `code` is its counter
    OutcomeUnknown,   // unknown whether the command was received; `code` is its counter
    ReadBackDiffers,  // a parameter was written but reads back differently
    ValueRefused,     // outside the register's limits, see `limits`; without them, not readable or writable
};

struct LinkError {
    LinkErrorKind kind = LinkErrorKind::NoAnswer;
    std::string port;
    std::string request; // "status" or "start", empty for the port itself
    std::string detail;
    int code = 0;
    std::optional<CodecError> limits{};
};

// Returns the stable id of a kind, such as "no_answer", for logs and machine-readable output.
[[nodiscard]] std::string_view errorId(LinkErrorKind kind);

// Returns the id and the fields, for logs.
[[nodiscard]] std::string describe(const LinkError& error);

// Returns "illegal register address"; "unknown" for codes without a name.
[[nodiscard]] std::string_view exceptionName(int code);

// Returns true when the device says that it is busy (Modbus exceptions 5 and 6).
[[nodiscard]] bool isBusy(const LinkError& error);

// Returns true when the port must be closed and searched again.
[[nodiscard]] bool portIsLost(const LinkError& error);

} // namespace campanel::modbus
