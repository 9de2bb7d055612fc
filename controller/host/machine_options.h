// SPDX-License-Identifier: Apache-2.0
// The options of campanel-controller that are numbers of the simulated machine: a table from name to member
// and range, from which the program's help is made too.
#pragma once

#include "machine.h"

#include <span>
#include <string>

namespace campanel::controller {

struct MachineOption {
    const char* name = nullptr; // without the dashes
    const char* unit = nullptr; // of its argument, for the help
    const char* text = nullptr;
    double minimum = 0.0;
    double maximum = 0.0;
    double& (*member)(MachineOptions&) = nullptr;
};

[[nodiscard]] std::span<const MachineOption> machineOptions();
// One line an option: name, unit, text, range and default.
[[nodiscard]] std::string machineHelp();

} // namespace campanel::controller
