// SPDX-License-Identifier: Apache-2.0
// campanelctl simulate --table: the bag lengths of a machine as listed in a manual, with the measured
// results.
#pragma once

#include "app/cli/failure.h"
#include "app/program/recipe.h"
#include "packing_run.h"

namespace campanel::cli {

class Invocation;

// Runs each length at 60 bags/min and at the largest feasible rate up to 300, with and without mark tracking,
// and with the gentlest ratios at the same rates and at their own largest one.
// Prints the whole table; fails when a row is incomplete.
[[nodiscard]] Outcome simulateTable(const Invocation& call, const program::Recipe& recipe,
                                    const controller::PackingJob& job, double toleranceMm);

} // namespace campanel::cli
