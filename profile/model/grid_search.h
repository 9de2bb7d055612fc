// SPDX-License-Identifier: Apache-2.0
// Finds the nearest feasible value of one field. Candidates are rounded to the field's grid and fully
// checked. `Program` needs value(), setValue() and isFeasible(). Internal to profile/.
#pragma once

#include "profile/model/machine.h"
#include "profile/model/refusal.h"

#include <cmath>
#include <optional>

namespace campanel::profile::detail {

// Tests values of one field and stores the feasible one nearest to the present value.
template <typename Program> class GridSearch {
public:
    GridSearch(const Program& program, const Machine& machine, Field field)
        : m_program(program)
        , m_machine(machine)
        , m_field(field)
        , m_present(value(program, field))
    {
        if (!std::isfinite(m_present))
            m_present = info(field).defaultValue;
        m_nearest = snapToGrid(field, m_present);
    }

    // Tries the grid points around a candidate, starting at the nearest one: rounding could skip a point
    // otherwise.
    void tryAround(double candidate)
    {
        if (!std::isfinite(candidate))
            return;
        const double step = info(m_field).resolution();
        const double nearest = snapToGrid(m_field, candidate);
        for (const int offset : {-1, 0, 1})
            tryValue(snapToGrid(m_field, nearest + offset * step));
    }

    [[nodiscard]] bool isFeasibleAt(double x)
    {
        setValue(m_program, m_field, x);
        return isFeasible(m_program, m_machine);
    }

    // Moves the best value towards the present one as far as there is no infeasible one between.
    void closeIn()
    {
        if (!m_best)
            return;
        double failing = m_nearest;
        while (std::abs(*m_best - failing) > 1.5 * info(m_field).resolution()) {
            const double middle = snapToGrid(m_field, (*m_best + failing) / 2);
            if (isFeasibleAt(middle))
                m_best = middle;
            else
                failing = middle;
        }
    }

    [[nodiscard]] std::optional<Suggestion> best() const
    {
        if (!m_best)
            return std::nullopt;
        return Suggestion{m_field, *m_best};
    }

    [[nodiscard]] double present() const { return m_present; }

private:
    void tryValue(double x)
    {
        // Beyond the range the distances from the present value itself may be equal by rounding.
        if (m_best && std::abs(x - m_nearest) >= std::abs(*m_best - m_nearest) &&
            std::abs(x - m_present) >= std::abs(*m_best - m_present))
            return;
        if (isFeasibleAt(x))
            m_best = x;
    }

    Program m_program;
    Machine m_machine;
    Field m_field;
    double m_present;
    double m_nearest; // the value of the grid nearest to it
    std::optional<double> m_best;
};

// Moves a refused value that is out of range to the nearest limit of its range, if the whole program is
// feasible then.
template <typename Program>
[[nodiscard]] std::optional<Suggestion> nearestInRange(Program program, Machine machine,
                                                       const Refusal& refusal)
{
    const double inside = std::isfinite(refusal.actual) ? refusal.allowed : info(refusal.field).defaultValue;
    setValue(program, refusal.field, inside);
    setValue(machine, refusal.field, inside);
    if (!isFeasible(program, machine))
        return std::nullopt;
    return Suggestion{refusal.field, inside};
}

} // namespace campanel::profile::detail
