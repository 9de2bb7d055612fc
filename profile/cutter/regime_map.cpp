// SPDX-License-Identifier: Apache-2.0
// A cycle at a low rate gives the fastest one in closed form, see fastestRate().
#include "profile/cutter/regime_map.h"

#include "profile/cutter/cutter_search.h"
#include "profile/cutter/validate.h"
#include "profile/model/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::profile {
namespace {

// The first of these rates with a possible cycle is the start. The lowest would exceed the range of the film
// speed for the shortest bags.
constexpr std::array startRates{10.0, 1.0};
constexpr double roomBeyond = 1.1;   // beyond the last line of the map
constexpr double roundMm = 50;       // the range ends at a multiple of it
constexpr double besideEndMm = 1e-6; // from the exact end of the feasible lengths

RotaryCutterProgram pinnedAt(RotaryCutterProgram program, double bagLengthMm, double rate)
{
    program.pinned = {Field::BagLength, Field::Rate};
    program.bagLengthMm = bagLengthMm;
    program.rateBagsPerMin = rate;
    return program;
}

std::vector<double> lengthsOf(const LengthRange& range, std::size_t count, const CutterLengths& ends)
{
    std::vector<double> lengths;
    lengths.reserve(count + 4);
    const double step = (range.toMm - range.fromMm) / static_cast<double>(count - 1);
    for (std::size_t i = 0; i < count; ++i)
        lengths.push_back(range.fromMm + static_cast<double>(i) * step);
    for (const double end : {ends.jawWithMarginMm, ends.strokeMm}) {
        for (const double beside : {end - besideEndMm, end + besideEndMm}) {
            if (beside > range.fromMm && beside < range.toMm)
                lengths.push_back(beside);
        }
    }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

RegimePoint pointAt(const RotaryCutterProgram& program, double bagLengthMm,
                    const detail::CutterFigures& figures)
{
    RegimePoint point{bagLengthMm, 0, Limit::StrokeCannotClose};
    const RotaryCutterProgram fastest = program.ratioMode == RatioMode::ByHand
                                            ? program
                                            : detail::withFastestRatios(program, bagLengthMm, figures);
    const detail::CycleShape shape = detail::cycleShape(fastest, figures.shape);
    constexpr double rounding = 1e-12; // share; that of the speeds has more room at a low rate
    if (bagLengthMm > shape.strokeMm / (shape.syncRatio * shape.weight) * (1 + rounding))
        return point;
    for (const double rate : startRates) {
        const RotaryCutterProgram tried = pinnedAt(fastest, bagLengthMm, rate);
        const auto cycle = detail::solveValid(tried, shape);
        if (!cycle) {
            point.limit = cycle.error().limit;
            continue;
        }
        if (const auto found = detail::fastestByHand(*cycle, tried, figures))
            return {bagLengthMm, found->rateBagsPerMin, found->limitedBy};
        point.limit = detail::firstBroken(*cycle, figures).value_or(Limit::FieldRange);
    }
    return point;
}

} // namespace

RegimePoint regimePoint(const RotaryCutterProgram& program, const Machine& machine, double bagLengthMm)
{
    if (!inRange(Field::BagLength, bagLengthMm))
        return {bagLengthMm, 0, Limit::FieldRange};
    return pointAt(program, bagLengthMm, {program, machine});
}

LengthRange regimeRange(const RotaryCutterProgram& program, const Machine& machine)
{
    const CutterLengths lengths = cutterLengths(program, machine);
    const auto cycle = solveNumbers(program, machine);
    const double last =
        maxOf(lengths.dwellMm, lengths.equalSpeedMm, cycle ? cycle->bagLengthMm : program.bagLengthMm);
    const FieldInfo& length = info(Field::BagLength);
    return {length.min, clamped(std::ceil(last * roomBeyond / roundMm) * roundMm, 2 * roundMm, length.max)};
}

tl::expected<RegimeMap, Refusal> regimeMap(const RotaryCutterProgram& program, const Machine& machine,
                                           const LengthRange& range, std::size_t count)
{
    if (auto refusal = detail::findInvalid(pinnedAt(program, range.fromMm, startRates[0]), machine))
        return tl::unexpected(*std::move(refusal));
    RegimeMap map;
    map.lengths = cutterLengths(program, machine);
    map.range = range;
    const detail::CutterFigures figures(program, machine);
    for (const double length : lengthsOf(range, count, map.lengths)) {
        const RegimePoint& point = map.points.emplace_back(pointAt(program, length, figures));
        map.maxRateBagsPerMin = maxOf(map.maxRateBagsPerMin, point.rateBagsPerMin);
        if (point.rateBagsPerMin > 0 && std::ranges::find(map.limits, point.limit) == map.limits.end())
            map.limits.push_back(point.limit);
    }
    return map;
}

} // namespace campanel::profile
