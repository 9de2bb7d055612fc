// SPDX-License-Identifier: Apache-2.0
// What the system knows about a port that cannot be used, or that is slower than it should be.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace campanel::modbus {

struct PortHolder {
    int processId = 0;
    std::string program; // "screen"; empty when it may not be read

    bool operator==(const PortHolder&) const = default;
};

// The other processes that have the port open, as far as this user may look into them. `processes`: the
// folder to look in.
[[nodiscard]] std::vector<PortHolder> holdersOf(const std::string& port,
                                                const std::string& processes = "/proc");

// How long an FTDI adapter collects bytes before it hands them on; empty for other ports. `devices`: the
// folder to look in.
[[nodiscard]] std::optional<int> ftdiLatencyMs(const std::string& port,
                                               const std::string& devices = "/sys/bus/usb-serial/devices");

// A longer one costs more than a status exchange at 115200 baud can spare.
inline constexpr int longestGoodLatencyMs = 2;

// The commands that mend it, for a person to type.
[[nodiscard]] std::string joinGroupCommand(const std::string& group);
[[nodiscard]] std::string lowerLatencyCommand(const std::string& port);

} // namespace campanel::modbus
