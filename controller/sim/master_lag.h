// SPDX-License-Identifier: Apache-2.0
// How far the axes are behind a line's shaft that leads them, in film: where they are told to be, and where
// the film's motor is. From the true shaft, while the line is engaged.
#pragma once

#include "ctl_core.h"
#include "machine.h"

#include <cstdint>

namespace campanel::controller {

struct Lag {
    double meanMm = 0.0;
    double largestMm = 0.0; // magnitude
    void take(double mm, std::uint64_t number);
};

struct MasterLag {
    std::uint64_t samples = 0;
    Lag commands;
    Lag film;
    void take(const ctl_core& core, Machine& machine, const MachineOptions& options);
};

} // namespace campanel::controller
