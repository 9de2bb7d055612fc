// SPDX-License-Identifier: Apache-2.0
// Finds nearest inputs for a table. Its size has no closed form, so the search moves away from the present
// value in doubling steps and returns by bisection on the field's grid.
#include "profile/cutter/table_nearest.h"

#include "profile/cutter/limits.h"
#include "profile/cutter/ratios.h"

#include <cmath>
#include <optional>

namespace campanel::profile::detail {
namespace {

bool fits(RotaryCutterProgram program, Machine machine, Field field, double x)
{
    setValue(program, field, x);
    setValue(machine, field, x);
    program = withRatios(program, machine);
    if (!isFeasible(program, machine))
        return false;
    const auto cutter = solve(program, machine);
    return cutter && buildTable(*cutter);
}

// Returns the nearest value in one direction (+1 or -1).
std::optional<double> nearestOnSide(const RotaryCutter& cutter, Field field, double present, int direction)
{
    const double step = info(field).resolution();
    double failing = present;
    for (double distance = step;; distance *= 2) {
        double x = snapToGrid(field, present + direction * distance);
        if (x == failing)
            return std::nullopt; // limit of the range
        if (!fits(cutter.program, cutter.machine, field, x)) {
            failing = x;
            continue;
        }
        while (std::abs(x - failing) > 1.5 * step) {
            const double middle = snapToGrid(field, (x + failing) / 2);
            (fits(cutter.program, cutter.machine, field, middle) ? x : failing) = middle;
        }
        return x;
    }
}

void append(std::vector<Suggestion>& found, const RotaryCutter& cutter, Field field, double present)
{
    const auto below = nearestOnSide(cutter, field, present, -1);
    const auto above = nearestOnSide(cutter, field, present, +1);
    if (below && (!above || present - *below <= *above - present))
        found.push_back({field, *below});
    else if (above)
        found.push_back({field, *above});
}

} // namespace

std::vector<Suggestion> nearestForTable(const RotaryCutter& cutter, const Refusal& refusal)
{
    std::vector<Suggestion> found;
    if (refusal.limit == Limit::TooFewPulses) {
        append(found, cutter, Field::PulsesPerMotorRev, cutter.machine.pulsesPerMotorRev);
        return found;
    }
    if (refusal.limit == Limit::RowCapacity)
        append(found, cutter, Field::SlicesPerRamp, cutter.program.slicesPerRamp);
    for (const Field field : cutter.program.pinned)
        append(found, cutter, field, value(cutter.program, field));
    return found;
}

} // namespace campanel::profile::detail
