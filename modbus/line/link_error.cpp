// SPDX-License-Identifier: Apache-2.0
// The ids of link errors, and the names of exceptions.
#include "modbus/line/link_error.h"

#include <array>

namespace campanel::modbus {

std::string_view errorId(LinkErrorKind kind)
{
    static constexpr std::array<std::string_view, 20> ids{
        "port_absent",        "port_busy",    "port_not_permitted", "port_not_serial",   "port_settings",
        "port_gone",          "not_open",     "no_answer",          "bad_checksum",      "bad_frame",
        "foreign_answer",     "exception",    "not_campanel",       "wrong_map_major",   "wrong_identity",
        "range_not_readable", "command_lost", "outcome_unknown",    "read_back_differs", "value_refused"};
    return ids[static_cast<std::size_t>(kind)];
}

std::string describe(const LinkError& error)
{
    std::string text(errorId(error.kind));
    for (const std::string& part : {error.port, error.request, error.detail})
        text.append(part.empty() ? "" : " ").append(part);
    return error.code == 0 ? text : text.append(" ").append(std::to_string(error.code));
}

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
    case 8:
        return "memory parity error";
    case 10:
        return "gateway path unavailable";
    case 11:
        return "no response from the device behind the gateway";
    default:
        return "unknown";
    }
}

bool portIsLost(const LinkError& error)
{
    return error.kind == LinkErrorKind::PortGone || error.kind == LinkErrorKind::NotOpen;
}

} // namespace campanel::modbus
