// SPDX-License-Identifier: Apache-2.0
// The bag length may depend on the ratios (rate and v_a given), so the window is found by repetition.
#include "profile/cutter/window_mend.h"

#include "profile/cutter/jaw.h"
#include "profile/cutter/limits.h"
#include "profile/cutter/validate.h"
#include "profile/model/bounds.h"

#include <array>
#include <cmath>

namespace campanel::profile::detail {
namespace {

constexpr double minRampShare = 0.01;   // of the cycle
constexpr double firstEndShare = 0.001; // ta and T - td: k1 is at most 1000

enum class Ramps : std::uint8_t { Present, Longest };

// Returns the ratio of an end at this share of the cycle, rounded so that the end moves outwards.
double ratioOutwards(double share, bool isBeforeWindow)
{
    const double step = info(Field::K1).resolution();
    const double steps = 1 / share / step;
    return snapToGrid(Field::K1, (isBeforeWindow ? std::ceil(steps) : std::floor(steps)) * step);
}

// Returns the ratios with a window of this share of the cycle; nothing when no ramps of 1 % remain beside it.
std::optional<std::array<double, 4>> ratiosFor(const RotaryCutterProgram& program, double window, Ramps ramps)
{
    constexpr double edge = firstEndShare + minRampShare;
    if (!(window <= 1 - 2 * edge))
        return std::nullopt;
    const double present = (1 / program.k[1] + 1 / program.k[2]) / 2;
    const double middle =
        ramps == Ramps::Longest ? 0.5 : clamped(present, edge + window / 2, 1 - edge - window / 2);
    const double tb = middle - window / 2;
    const double tc = middle + window / 2;
    const double rampBefore = tb - 1 / program.k[0];
    const double rampAfter = 1 / program.k[3] - tc;
    std::array ratios{program.k[0], ratioOutwards(tb, true), ratioOutwards(tc, false), program.k[3]};
    if (ramps == Ramps::Longest) {
        ratios.front() = ratioOutwards(firstEndShare, true);
        ratios.back() = ratioOutwards(1 - firstEndShare, false);
    } else {
        if (rampBefore < minRampShare)
            ratios.front() = ratioOutwards(maxOf(firstEndShare, tb / 2), true);
        if (rampAfter < minRampShare)
            ratios.back() = ratioOutwards(minOf(1 - firstEndShare, (1 + tc) / 2), false);
    }
    return ratios;
}

// Returns the program with a window that holds the jaws; nothing when there is none.
std::optional<RotaryCutterProgram> widened(RotaryCutterProgram program, const Machine& machine, Ramps ramps)
{
    constexpr int repetitions = 30;
    const double required = requiredWindowDeg(machine);
    for (int i = 0; i < repetitions; ++i) {
        const auto cycle = solveNumbers(program, machine);
        if (!cycle)
            return std::nullopt;
        const double present = windowDeg(*cycle, machine);
        if (i > 0 && present >= required)
            return program;
        const double share = 1 / program.k[2] - 1 / program.k[1];
        const auto ratios = ratiosFor(program, share * required / present, ramps);
        if (!ratios)
            return std::nullopt;
        program.k = *ratios;
    }
    return std::nullopt;
}

} // namespace

std::optional<Suggestion> widenedWindow(const RotaryCutterProgram& program, const Machine& machine)
{
    if (findInvalid(program, machine))
        return std::nullopt;
    std::optional<RotaryCutterProgram> gentle;
    for (const Ramps ramps : {Ramps::Present, Ramps::Longest}) {
        const auto wide = widened(program, machine, ramps);
        if (wide && isFeasible(*wide, machine))
            return Suggestion{Field::K2, wide->k[1], wide->k};
        if (wide)
            gentle = wide;
    }
    if (!gentle || !isPinned(*gentle, Field::Rate))
        return std::nullopt;
    const auto cycle = solveNumbers(*gentle, machine);
    const auto fastest = cycle ? fastestRate(*cycle, *gentle, machine) : std::nullopt;
    if (!fastest)
        return std::nullopt;
    gentle->rateBagsPerMin = fastest->rateBagsPerMin;
    if (!isFeasible(*gentle, machine))
        return std::nullopt;
    return Suggestion{Field::Rate, gentle->rateBagsPerMin, gentle->k};
}

} // namespace campanel::profile::detail
