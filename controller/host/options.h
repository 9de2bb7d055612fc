// SPDX-License-Identifier: Apache-2.0
// The command line of campanel-controller.
#pragma once

#include "fault_rules.h"
#include "line.h"
#include "machine.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace campanel::controller {

struct Options {
    std::uint8_t unit = 1;
    LineSettings line;
    std::filesystem::path stateDirectory;
    std::filesystem::path link;  // empty: none
    double speed = 1.0;          // simulated seconds per second
    std::uint16_t mapMinor = 0;  // answers as a controller of this minor map version; 0: of the newest
    bool keepsPositions = false; // without power
    MachineOptions machine;
    FaultScript faults;
    bool control = false; // also reads rules from standard input
    bool exitWithParent = false;
};

// The end of the program before it starts: a text for the user and the exit code (0: the user requested the
// text).
struct Ending {
    int exitCode = 0;
    std::string text;
};

[[nodiscard]] tl::expected<Options, Ending> parseOptions(int argc, char** argv);

} // namespace campanel::controller
