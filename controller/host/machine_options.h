// SPDX-License-Identifier: Apache-2.0
// The options of campanel-controller that set numbers of the simulated machine: a table of names, members and
// ranges, also used for the program's help.
#pragma once

#include "machine.h"

#include <span>
#include <string>

namespace campanel::controller {

struct MachineOption {
    const char* name = nullptr; // without the dashes
    const char* unit = nullptr; // unit of its argument, for the help
    const char* text = nullptr;
    double minimum = 0.0;
    double maximum = 0.0;
    double& (*member)(MachineOptions&) = nullptr;
};

[[nodiscard]] std::span<const MachineOption> machineOptions();
// Returns one line per option: name, unit, text, range and default.
[[nodiscard]] std::string machineHelp();

} // namespace campanel::controller
