// SPDX-License-Identifier: Apache-2.0
// System information about a port that cannot be used, or that is slower than it should be.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace campanel::modbus {

struct PortHolder {
    int processId = 0;
    std::string program; // "screen"; empty without permission

    bool operator==(const PortHolder&) const = default;
};

// Returns the other processes that have the port open, if this user may see them. `processes`: the folder to
// search.
[[nodiscard]] std::vector<PortHolder> holdersOf(const std::string& port,
                                                const std::string& processes = "/proc");

// Returns how long an FTDI adapter collects bytes before it delivers them; empty for other ports. `devices`:
// the folder to search.
[[nodiscard]] std::optional<int> ftdiLatencyMs(const std::string& port,
                                               const std::string& devices = "/sys/bus/usb-serial/devices");

// The largest acceptable latency: a longer one takes too much of a status exchange at 115200 baud.
inline constexpr int longestGoodLatencyMs = 2;

// Return the commands that correct it, for a person to type.
[[nodiscard]] std::string joinGroupCommand(const std::string& group);
[[nodiscard]] std::string lowerLatencyCommand(const std::string& port);

} // namespace campanel::modbus
