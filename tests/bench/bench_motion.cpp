// SPDX-License-Identifier: Apache-2.0
// The mathematics behind one edit: solve, sample, build the table. Timed by Google Benchmark.
#include "bench_report.h"

#include "profile/cutter/sampling.h"
#include "profile/cutter/step_table.h"

#include <benchmark/benchmark.h>

#include <stdexcept>

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

// Stores the medians instead of printing.
class MedianReporter : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override
    {
        for (const Run& run : runs) {
            if (run.aggregate_name == "median")
                m_medianMs = run.GetAdjustedRealTime();
        }
    }
    [[nodiscard]] double medianMs() const { return m_medianMs; }

private:
    double m_medianMs = -1;
};

} // namespace

Figures measureMotion()
{
    const auto cutter = profile::solve(largeTableProgram(), profile::Machine{});
    const auto table = cutter ? profile::buildStepTable(*cutter) : tl::make_unexpected(cutter.error());
    if (!table || table->rows.size() < 256)
        throw std::runtime_error("the program to be timed does not give a table of 256 rows");

    benchmark::RegisterBenchmark("edit", editOnce)
        ->Unit(benchmark::kMillisecond)
        ->MinTime(0.1)
        ->Repetitions(9)
        ->ReportAggregatesOnly();
    MedianReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return {{"solve + sample 1000 points + " + std::to_string(table->rows.size()) + "-row table",
             reporter.medianMs(), 1.0, "ms", "one millisecond", true}};
}

} // namespace campanel::bench
