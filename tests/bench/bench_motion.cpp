// SPDX-License-Identifier: Apache-2.0
// The mathematics behind one edit: solve, sample, build the table. Timed by Google Benchmark.
#include "bench_report.h"

#include "profile/cutter/regime_map.h"
#include "profile/cutter/sampling.h"
#include "profile/cutter/step_table.h"
#include "profile/intervals/intervals.h"
#include "profile/moves/position_move.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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

// Returns the milliseconds, the median of three, in which an error is refused that whole pulses cannot keep.
double refusalMs(const profile::MotionProfile& motion, const profile::Machine& machine, double errorMmPerS)
{
    std::vector<double> ms;
    for (int i = 0; i < 3; ++i) {
        const auto start = std::chrono::steady_clock::now();
        const auto table =
            profile::compileIntervals(motion, machine, errorMmPerS, profile::IntervalMode::Corrected);
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        if (table || table.error().limit != profile::Limit::SpeedError)
            throw std::runtime_error("the intervals to be timed are not refused");
        ms.push_back(took.count());
    }
    return quantile(ms, 0.5);
}

// A cutter of 610 pulses a cycle, moving at both ends.
double cutterRefusalMs()
{
    profile::RotaryCutterProgram program;
    program.pinned = {profile::Field::Rate, profile::Field::FilmSpeed};
    program.rateBagsPerMin = 227.5;
    program.filmSpeedMmPerS = 385.6;
    program.k = {1.8914, 1.8079, 1.1843, 1.0683};
    program.speedLaw = profile::LawId::Harmonic;
    profile::Machine machine;
    machine.knifeRadiusMm = 97.14;
    machine.knives = 2;
    machine.pulsesPerMotorRev = 2500;
    machine.gearDenominator = 2;
    machine.maxKnifeAccelerationMmPerS2 = 1'000'000;
    machine.maxPulseFrequencyHz = 500'000;
    machine.maxRateBagsPerMin = 600;
    const auto cutter = profile::solve(program, machine);
    machine.feedMmPerMotorRev = 4 * std::numbers::pi * machine.knifeRadiusMm;
    return refusalMs(cutter.value().motion, machine, 8);
}

// A move of 15 mm, 1536 pulses, as fast as its motor can.
double moveRefusalMs()
{
    profile::PositionMoveProgram program;
    program.distanceMm = 15.355;
    program.law = profile::LawId::SCurve;
    program.lawParameters = {0.465, 0.485};
    program.duration = profile::MoveDuration::Fastest;
    profile::Machine machine;
    machine.feedMmPerMotorRev = 10;
    machine.pulsesPerMotorRev = 1000;
    machine.maxMotorRpm = 7200;
    machine.maxAccelerationMmPerS2 = 200'000;
    machine.maxPulseFrequencyHz = 500'000;
    machine.maxTorqueNm = 1.33;
    machine.inertiaKgCm2 = 0.2;
    machine.frictionNm = 0.1;
    machine.ratedTorqueNm = 0.522;
    return refusalMs(profile::solve(program, machine).value().motion, machine, 2.05007);
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
             "two milliseconds", true},
            {"intervals of a cutter, refused", cutterRefusalMs(), 1000, "ms", "one second", true},
            {"intervals of a move of 15 mm, refused", moveRefusalMs(), 1000, "ms", "one second", true}};
}

} // namespace campanel::bench
