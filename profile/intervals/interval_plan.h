// SPDX-License-Identifier: Apache-2.0
// Few rows of constant acceleration that keep a motion's speed within an error.
#pragma once

#include "profile/intervals/interval_errors.h"
#include "profile/intervals/interval_lines.h"
#include "profile/intervals/interval_search.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace campanel::profile::detail {

struct IntervalPlan {
    std::vector<IntervalRow> rows;
    IntervalErrors errors;
    double errorMmPerS = 0; // for which it is found
};

// One motion. For each number of rows and style of lines there is one plan, whatever error is asked for: the
// straight lines with the smallest error and the rows with whole pulses beside them. So a larger error never
// takes more rows, and is never refused where a smaller one is kept.
class IntervalPlanner {
public:
    // Keeps a reference to the motion.
    IntervalPlanner(const MotionProfile& motion, double pulsesPerMm, const RowRules& rules,
                    std::size_t maxRows);

    // Returns the plan with the fewest rows that keeps the error.
    [[nodiscard]] std::optional<IntervalPlan> fewestRows(double errorMmPerS);
    // Returns an error that can be kept where this one cannot; infinite where there is none.
    [[nodiscard]] double keptErrorMmPerS(double triedMmPerS);
    // Returns the number below which no straight lines keep the error; 0 when there would be more than rows.
    [[nodiscard]] std::size_t fewestLines(double errorMmPerS);

private:
    struct Level {
        Level(const MotionProfile& motion, double pulsesPerMm, const RowRules& rules, int samples)
            : curve(motion, pulsesPerMm, samples)
            , lines(curve, rules.minHz, rules.maxHz)
        {
        }
        SpeedCurve curve;
        IntervalLines lines;
    };
    Level& levelOf(std::size_t lineCount);
    double finestHz();
    bool isTooMany(std::size_t count);
    std::optional<IntervalPlan> plan(std::size_t rowCount, const LineStyle& style, double errorMmPerS);

    const MotionProfile& m_motion;
    double m_pulsesPerMm;
    RowRules m_rules;
    double m_unitHz; // of the registers' speeds
    std::optional<double> m_finestHz;
    std::vector<std::size_t> m_counts;            // of rows, rising
    std::vector<std::unique_ptr<Level>> m_levels; // each finer than the one before, made when it is needed
};

} // namespace campanel::profile::detail
