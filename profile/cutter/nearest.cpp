// SPDX-License-Identifier: Apache-2.0
// Finds the nearest feasible values. The feasible values of a pinned input form intervals; at each end of an
// interval one limit is met exactly. These points have closed forms. The nearest one that passes the whole
// check is the result, rounded to the field's grid towards the feasible side.
#include "profile/cutter/nearest.h"

#include "profile/cutter/cycle_shape.h"
#include "profile/cutter/jaw.h"
#include "profile/cutter/limits.h"
#include "profile/cutter/ratios.h"
#include "profile/cutter/validate.h"
#include "profile/cutter/window_mend.h"
#include "profile/laws/laws.h"
#include "profile/model/bounds.h"
#include "profile/model/grid_search.h"
#include "profile/model/torque.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace campanel::profile::detail {
namespace {

// Returns the cycle times at which the acceleration's peak equals +-limit for a fixed `kept`. With D = limit
// * shortest ramp / Cv and both signs of D: v_b - v_a = D T.
std::vector<double> accelerationTimes(const CycleShape& shape, FieldValue kept, double d)
{
    const double h = shape.strokeMm;
    const double w = shape.weight;
    const auto roots = [](double a, double b, double c) { // a T^2 + b T + c = 0
        const double root = std::sqrt(b * b - 4 * a * c);
        return std::vector{(-b - root) / (2 * a), (-b + root) / (2 * a)};
    };
    switch (kept.field) {
    case Field::BagLength: {
        const double film = shape.syncRatio * kept.value;
        return {std::sqrt((film - (h - film * w) / (1 - w)) / d)};
    }
    case Field::BaseSpeed:
        return roots(w * d, kept.value, -h);
    case Field::FilmSpeed:
        return roots(-(1 - w) * d, kept.value, -h);
    default:
        return {60 / kept.value};
    }
}

// Returns the values of (v_b - v_a) / T at which the peak of acceleration or torque, or the RMS torque, is
// met. Either ramp may have the peak of the torque.
std::array<double, 12> speedChangeLimits(const RotaryCutterProgram& program, const Machine& machine,
                                         const CycleShape& shape)
{
    const TorqueLoad load = knifeLoad(machine);
    const double there = 1 / program.k[1] - 1 / program.k[0];
    const double back = 1 / program.k[3] - 1 / program.k[2];
    const double acceleration = machine.maxKnifeAccelerationMmPerS2 * shape.shortestRamp / shape.lawPeaks.cv;
    const double speeding = load.speedingAllowance(machine.maxTorqueNm) / shape.lawPeaks.cv;
    const double slowing = load.slowingAllowance(machine.maxTorqueNm) / shape.lawPeaks.cv;
    const double ramps = 1 / there + 1 / back;
    const double square = lawSpeedSquare(*findLaw(program.speedLaw), program.speedLawParameters) * ramps;
    const double rms = load.rmsAllowance(machine.ratedTorqueNm) / std::sqrt(square);
    return {acceleration,
            -acceleration,
            rms,
            -rms,
            speeding * there,
            -speeding * there,
            speeding * back,
            -speeding * back,
            slowing * there,
            -slowing * there,
            slowing * back,
            -slowing * back};
}

std::vector<double> candidates(const RotaryCutterProgram& program, const Machine& machine, Field field)
{
    const CycleShape shape = cycleShape(program, machine);
    const Field keptField = program.pinned[0] == field ? program.pinned[1] : program.pinned[0];
    const FieldValue kept{keptField, value(program, keptField)};
    std::vector<double> found{info(field).min, info(field).max};

    const auto meet = [&](Field other, double bound) {
        if (other == field)
            found.push_back(bound);
        else if (other != keptField)
            found.push_back(closeCycle(shape, kept, {other, bound}).of(field));
    };
    for (const Field other : cycleFields) {
        meet(other, info(other).min);
        meet(other, info(other).max);
    }
    meet(Field::Rate, machine.maxRateBagsPerMin);
    meet(Field::BagLength, cutterLengths(program, machine).jawWithMarginMm);
    meet(Field::FilmSpeed, 1000 * jawArcMm(machine) / program.minSealTimeMs); // from ms
    for (const double speed : {machine.maxMotorRpm / motorRpmPerMmPerS(machine),
                               pulseFrequencyLimitHz(machine) / pulsesPerMm(machine)}) {
        meet(Field::BaseSpeed, speed);
        meet(Field::FilmSpeed, speed);
    }
    meet(Field::Rate, 60 * machine.naturalFrequencyHz);
    for (const double d : speedChangeLimits(program, machine, shape)) {
        for (const double time : accelerationTimes(shape, kept, d)) {
            if (keptField == Field::Rate)
                meet(Field::BaseSpeed, shape.strokeMm / time - shape.weight * d * time);
            else
                meet(Field::Rate, 60 / time);
        }
    }
    return found;
}

// A program whose ratios follow each value that is tried.
struct FollowingProgram : RotaryCutterProgram {};

double value(const FollowingProgram& program, Field field)
{
    return profile::value<RotaryCutterProgram>(program, field);
}

void setValue(FollowingProgram& program, Field field, double value)
{
    profile::setValue<RotaryCutterProgram>(program, field, value);
}

bool isFeasible(const FollowingProgram& program, const Machine& machine)
{
    return profile::isFeasible(withRatios(program, machine), machine);
}

template <typename Program>
std::optional<Suggestion> nearestOf(const Program& program, const Machine& machine, Field field)
{
    GridSearch search(program, machine, field);
    search.tryAround(search.present()); // feasible when only the value's grid or finiteness was wrong
    for (const double candidate : candidates(program, machine, field))
        search.tryAround(candidate);
    if (program.ratioMode != RatioMode::ByHand)
        search.closeIn(); // the ratios at the limit are others than the present ones
    return search.best();
}

std::optional<Suggestion> nearestPinned(const RotaryCutterProgram& program, const Machine& machine,
                                        Field field)
{
    RotaryCutterProgram mendable = program;
    setValue(mendable, field, info(field).defaultValue);
    if (findInvalid(mendable, machine))
        return std::nullopt; // another input is wrong as well
    return program.ratioMode == RatioMode::ByHand ? nearestOf(program, machine, field)
                                                  : nearestOf(FollowingProgram{program}, machine, field);
}

// Finds a ratio between its neighbors: coarse steps away from the violated neighbor, then bisection on the
// grid.
std::optional<Suggestion> nearestRatio(const RotaryCutterProgram& program, const Machine& machine,
                                       Field field)
{
    const std::size_t i = static_cast<std::size_t>(field) - static_cast<std::size_t>(Field::K1);
    const double step = info(field).resolution();
    const double low = (i + 1 < program.k.size() ? program.k[i + 1] + step : info(field).min);
    const double high = (i > 0 ? program.k[i - 1] - step : info(field).max);
    if (!(low <= high))
        return std::nullopt;
    GridSearch search(program, machine, field);
    const bool fromAbove = search.present() > high;
    const auto place = [&](double share) { // share 0: at the violated neighbor
        return snapToGrid(field, fromAbove ? high - share * (high - low) : low + share * (high - low));
    };
    constexpr int coarseSteps = 256;
    double before = place(0);
    for (int s = 0; s <= coarseSteps; ++s) {
        double feasible = place(std::pow(static_cast<double>(s) / coarseSteps, 2));
        if (!search.isFeasibleAt(feasible)) {
            before = feasible;
            continue;
        }
        while (std::abs(feasible - before) > 1.5 * step) {
            const double middle = snapToGrid(field, (feasible + before) / 2);
            (search.isFeasibleAt(middle) ? feasible : before) = middle;
        }
        return Suggestion{field, feasible};
    }
    return std::nullopt;
}

// Lowers the demand of jaws or film to what the present cycle gives.
std::optional<Suggestion> nearestDemand(RotaryCutterProgram program, Machine machine, const Refusal& refusal)
{
    const double given = refusal.limit == Limit::JawWindow ? refusal.actual - jawMarginDeg : refusal.actual;
    const double step = info(refusal.field).resolution();
    const double demand = snapToGrid(refusal.field, std::floor(given / step) * step);
    setValue(program, refusal.field, demand);
    setValue(machine, refusal.field, demand);
    if (!isFeasible(program, machine))
        return std::nullopt;
    return Suggestion{refusal.field, demand};
}

// Returns the natural frequency that the cycle needs, for one that was entered too low.
std::optional<Suggestion> nearestNaturalFrequency(const RotaryCutterProgram& program, Machine machine,
                                                  const Refusal& refusal)
{
    const double step = info(Field::NaturalFrequency).resolution();
    machine.naturalFrequencyHz = snapToGrid(Field::NaturalFrequency, std::ceil(refusal.actual / step) * step);
    if (!isFeasible(program, machine))
        return std::nullopt;
    return Suggestion{Field::NaturalFrequency, machine.naturalFrequencyHz};
}

// Returns the sort key of a suggestion: a machine limit is corrected by a lower speed first; the product
// stays.
std::pair<bool, double> cost(const RotaryCutterProgram& program, const Refusal& refusal,
                             const Suggestion& suggestion)
{
    const bool isTooDemanding =
        refusal.limit != Limit::FieldRange && refusal.limit != Limit::StrokeCannotClose;
    const double present = value(program, suggestion.field);
    const double change = std::abs(suggestion.value - present);
    return {isTooDemanding && suggestion.field != Field::Rate,
            change / maxOf(std::abs(present), info(suggestion.field).resolution())};
}

} // namespace

std::vector<Suggestion> nearestFeasible(const RotaryCutterProgram& program, const Machine& machine,
                                        const Refusal& refusal)
{
    std::vector<Suggestion> found;
    const auto keep = [&found](std::optional<Suggestion> suggestion) {
        if (suggestion)
            found.push_back(*suggestion);
    };
    switch (refusal.limit) {
    case Limit::PinnedPair:
    case Limit::LawUnknown:
    case Limit::LawParameter:
        return {};
    case Limit::RatioOrder:
        keep(nearestRatio(program, machine, refusal.field));
        keep(nearestRatio(program, machine, static_cast<Field>(static_cast<int>(refusal.field) - 1)));
        break;
    default: {
        const bool isCycleField =
            std::find(cycleFields.begin(), cycleFields.end(), refusal.field) != cycleFields.end();
        if (refusal.limit == Limit::FieldRange && !isCycleField) {
            keep(nearestInRange(program, machine, refusal));
            break;
        }
        for (const Field field : program.pinned)
            keep(nearestPinned(program, machine, field));
    }
    }
    std::stable_sort(found.begin(), found.end(), [&](const Suggestion& a, const Suggestion& b) {
        return cost(program, refusal, a) < cost(program, refusal, b);
    });
    if (refusal.limit == Limit::JawWindow) {
        if (const auto widened = widenedWindow(program, machine))
            found.insert(found.begin(), *widened);
    }
    if (found.empty() && (refusal.limit == Limit::JawWindow || refusal.limit == Limit::SealTime))
        keep(nearestDemand(program, machine, refusal));
    if (refusal.limit == Limit::NaturalFrequency)
        keep(nearestNaturalFrequency(program, machine, refusal));
    return found;
}

} // namespace campanel::profile::detail
