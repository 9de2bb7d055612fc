// SPDX-License-Identifier: Apache-2.0
// A run of the simulated packing machine: the processor time of 10 000 bags.
#include "bench_report.h"

#include "app/program/program_image.h"
#include "packing_run.h"

#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>

namespace campanel::bench {

Figures measurePacking()
{
    constexpr std::uint32_t bags = 10'000;
    constexpr double limitS = 1.0;
    constexpr double half = 0.5;
    Figures figures;
    for (const double rate : {60.0, 300.0}) {
        program::Recipe recipe = program::defaultRecipe(profile::ProgramKind::RotaryCutter);
        program::setValue(recipe, profile::Field::Rate, rate);
        program::setValue(recipe, profile::Field::BagLength, 300.0);
        const auto image = program::buildProgram(recipe);
        if (!image)
            throw std::runtime_error(program::describe(image.error()));
        std::vector<double> seconds;
        double simulatedS = 0;
        for (int repeat = 0; repeat < 5; ++repeat) {
            controller::PackingJob job;
            job.bank = image->registers;
            job.bags = bags;
            job.machine.products.misplaced = 0.05;
            job.goOn = true;
            const std::clock_t before = std::clock();
            const controller::PackingResult result = runPacking(job, [](const controller::PackedBag&) {});
            seconds.push_back(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
            if (result.bags != bags)
                throw std::runtime_error("the packing machine did not cut all of its bags");
            simulatedS = result.timeS;
        }
        const double medianS = quantile(seconds, half);
        const std::string name = std::to_string(static_cast<int>(rate)) + " bags/min";
        figures.push_back(
            {"10 000 simulated bags of 300 mm at " + name, medianS, limitS, "s of CPU", "one second", true});
        figures.push_back(
            {"the same, against a real machine", simulatedS / medianS, 1000.0, "times", "a thousand", false});
    }
    return figures;
}

} // namespace campanel::bench
