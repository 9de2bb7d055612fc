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

// Returns a map with five limits: jaws, acceleration, motor speed, seal time and the machine's rate. Some of
// them set no rate with these numbers; the row says how many do.
profile::RegimeMap mapWithFiveLimits(profile::RatioMode ratios)
{
    profile::RotaryCutterProgram program;
    program.ratioMode = ratios;
    program.minSealTimeMs = 12;
    profile::Machine machine;
    machine.contactAngleDeg = 20;
    machine.maxMotorRpm = 300;
    machine.maxRateBagsPerMin = 280;
    machine.maxKnifeAccelerationMmPerS2 = 60000;
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
    const auto limits = [](profile::RatioMode ratios) {
        return std::to_string(mapWithFiveLimits(ratios).limits.size());
    };
    return {{"solve + sample 1000 points + " + std::to_string(table->rows.size()) + "-row table",
             reporter.medianMs("edit"), 1.0, "ms", "one millisecond", true},
            {"regime map of 200 lengths, ratios by hand, " + limits(profile::RatioMode::ByHand) +
                 " limits set a rate",
             reporter.medianMs("map"), 2.0, "ms", "two milliseconds", true},
            {"the same with gentle ratios, " + limits(profile::RatioMode::Gentle) + " limits",
             reporter.medianMs("gentle map"), 2.0, "ms", "two milliseconds", true}};
}

} // namespace campanel::bench
