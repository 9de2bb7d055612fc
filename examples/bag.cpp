// SPDX-License-Identifier: Apache-2.0
// Solves a bag and prints what the controller would execute: campanel-example-bag [LENGTH_MM [BAGS_PER_MIN]]
#include "profile/cutter/limits.h"
#include "profile/cutter/step_table.h"

#include <cstdlib>
#include <iostream>

using namespace campanel::profile;

int main(int argc, char** argv)
{
    RotaryCutterProgram program;
    program.bagLengthMm = argc > 1 ? std::atof(argv[1]) : 250;
    program.rateBagsPerMin = argc > 2 ? std::atof(argv[2]) : 60;
    const auto cutter = solve(program, Machine());
    if (!cutter) {
        std::cerr << describe(cutter.error()) << '\n';
        return 1;
    }
    for (const Refusal& broken : checkLimits(*cutter))
        std::cerr << describe(broken) << '\n';
    const auto table = buildStepTable(*cutter);
    if (!table || !isFeasible(program, Machine()))
        return 1;
    std::cout << "v_a " << cutter->cycle.baseSpeedMmPerS << " mm/s, v_b " << cutter->cycle.filmSpeedMmPerS
              << " mm/s\n";
    std::cout << table->rows.size() << " rows, " << table->pulses.whole << " pulses per bag\n";
    return 0;
}
