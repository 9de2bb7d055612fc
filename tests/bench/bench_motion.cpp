// SPDX-License-Identifier: Apache-2.0
// The mathematics behind one edit: solve, sample, build the table. Timed by Google Benchmark.
#include "bench_report.h"

#include "profile/cutter/regime_map.h"
#include "profile/cutter/sampling.h"
#include "profile/cutter/step_table.h"

#include <benchmark/benchmark.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace campanel::bench {
namespace {

profile::RotaryCutterProgram largeTableProgram()
{
    profile::RotaryCutterProgram program;
    program.slicesPerRamp = 127; // two ramps and three constant stretches: 257 rows
    return program;
}

void editOnce(benchmark::State& state)
{
    const profile::RotaryCutterProgram program = largeTableProgram();
    const profile::Machine machine;
    for (auto _ : state) {
        const auto cutter = profile::solve(program, machine);
        const auto curves = profile::sampleCurves(*cutter, 1000);
        const auto table = profile::buildStepTable(*cutter);
        benchmark::DoNotOptimize(curves.velocityMmPerS.data());
        benchmark::DoNotOptimize(table->rows.data());
    }
}

// Returns a map of a machine on which five limits set a rate: motor speed, RMS torque, the machine's rate,
// seal time and, for bags that rest the knife, acceleration. Ratios by hand meet four of them: their RMS
// torque and acceleration are proportional.
profile::RegimeMap mapWithFiveLimits(profile::RatioMode ratios)
{
    profile::RotaryCutterProgram program;
    program.ratioMode = ratios;
    program.minSealTimeMs = 12;
    profile::Machine machine;
    machine.contactAngleDeg = 20;
    machine.maxMotorRpm = 300;
    machine.maxRateBagsPerMin = 280;
    machine.maxKnifeAccelerationMmPerS2 = 20000;
    machine.inertiaKgCm2 = 20;
    machine.frictionNm = 0.1;
    machine.ratedTorqueNm = 0.4;
    const auto map = profile::regimeMap(program, machine, profile::regimeRange(program, machine), 200);
    return map.value();
}

template <profile::RatioMode ratios> void mapOnce(benchmark::State& state)
{
    for (auto _ : state) {
        const profile::RegimeMap map = mapWithFiveLimits(ratios);
        benchmark::DoNotOptimize(map.points.data());
    }
}

// Stores the medians instead of printing.
class MedianReporter : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override
    {
        for (const Run& run : runs) {
            if (run.aggregate_name == "median")
                m_medianMs[run.run_name.function_name] = run.GetAdjustedRealTime();
        }
    }
    [[nodiscard]] double medianMs(const std::string& name) const { return m_medianMs.at(name); }

private:
    std::map<std::string, double> m_medianMs;
};

} // namespace

Figures measureMotion()
{
    const auto cutter = profile::solve(largeTableProgram(), profile::Machine{});
    const auto table = cutter ? profile::buildStepTable(*cutter) : tl::make_unexpected(cutter.error());
    if (!table || table->rows.size() < 256)
        throw std::runtime_error("the program to be timed does not give a table of 256 rows");
    if (mapWithFiveLimits(profile::RatioMode::Gentle).limits.size() != 5 ||
        mapWithFiveLimits(profile::RatioMode::ByHand).limits.size() != 4)
        throw std::runtime_error("other limits set the rates of the map to be timed");

    for (const auto& [name, function] :
         {std::pair("edit", &editOnce), std::pair("map", &mapOnce<profile::RatioMode::ByHand>),
          std::pair("gentle map", &mapOnce<profile::RatioMode::Gentle>)})
        benchmark::RegisterBenchmark(name, function)
            ->Unit(benchmark::kMillisecond)
            ->MinTime(0.1)
            ->Repetitions(9)
            ->ReportAggregatesOnly();
    MedianReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return {{"solve + sample 1000 points + " + std::to_string(table->rows.size()) + "-row table",
             reporter.medianMs("edit"), 1.0, "ms", "one millisecond", true},
            {"regime map of 200 lengths, gentle ratios, 5 limits set a rate", reporter.medianMs("gentle map"),
             2.0, "ms", "two milliseconds", true},
            {"the same with ratios by hand, 4 limits", reporter.medianMs("map"), 2.0, "ms",
             "two milliseconds", true}};
}

} // namespace campanel::bench
