// SPDX-License-Identifier: Apache-2.0
// The ids of link errors, and the names of exceptions.
#include "modbus/line/link_error.h"

#include "text/marked.h"

#include <algorithm>
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
    struct Row {
        int code;
        std::string_view name;
    };
    static constexpr std::array rows{
        Row{1, CAMPANEL_TEXT("Protocol", "illegal function")},
        Row{2, CAMPANEL_TEXT("Protocol", "illegal register address")},
        Row{3, CAMPANEL_TEXT("Protocol", "illegal value")},
        Row{4, CAMPANEL_TEXT("Protocol", "device failure")},
        Row{5, CAMPANEL_TEXT("Protocol", "acknowledged, in progress")},
        Row{6, CAMPANEL_TEXT("Protocol", "device busy")},
        Row{8, CAMPANEL_TEXT("Protocol", "memory parity error")},
        Row{10, CAMPANEL_TEXT("Protocol", "gateway path unavailable")},
        Row{11, CAMPANEL_TEXT("Protocol", "no response from the device behind the gateway")},
    };
    const auto row = std::ranges::find(rows, code, &Row::code);
    return row == rows.end() ? CAMPANEL_TEXT("Protocol", "unknown") : row->name;
}

bool isBusy(const LinkError& error)
{
    constexpr int acknowledged = 5;
    constexpr int busy = 6;
    return error.kind == LinkErrorKind::Exception && (error.code == acknowledged || error.code == busy);
}

bool portIsLost(const LinkError& error)
{
    return error.kind == LinkErrorKind::PortGone || error.kind == LinkErrorKind::NotOpen;
}

} // namespace campanel::modbus
