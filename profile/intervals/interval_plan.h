// SPDX-License-Identifier: Apache-2.0
// Finds few rows of constant acceleration that keep the speed of a motion within an error.
#pragma once

#include "profile/intervals/interval_errors.h"
#include "profile/intervals/interval_lines.h"
#include "profile/intervals/interval_search.h"

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace campanel::profile::detail {

struct IntervalPlan {
    std::vector<IntervalRow> rows;
    IntervalErrors errors;
    double errorMmPerS = 0; // the error that the plan was requested for
};

// Plans the rows of one motion. Each number of rows and style of lines has one plan, independent of the
// requested error: the lines with the smallest error, and rows with whole pulses beside them. So a larger
// error never takes more rows, and is never refused where a smaller one is accepted.
class IntervalPlanner {
public:
    // Keeps a reference to the motion.
    IntervalPlanner(const MotionProfile& motion, double pulsesPerMm, const RowRules& rules,
                    std::size_t maxRows);

    // Returns the plan with the fewest rows that keeps the error.
    [[nodiscard]] std::optional<IntervalPlan> minRows(double errorMmPerS);
    // Returns the smallest error found that can be kept when the tried one cannot; infinite when there is
    // none.
    [[nodiscard]] double keptErrorMmPerS(double triedMmPerS);
    // Returns the lower bound of the number of lines that keep the error; 0 when it exceeds the number of
    // rows.
    [[nodiscard]] std::size_t minLines(double errorMmPerS);

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
    using PlanKey = std::tuple<std::size_t, Flats, double>;
    Level& levelOf(std::size_t lineCount);
    double finestHz();
    bool isTooMany(std::size_t count);
    bool isTooShort(std::size_t count);
    std::size_t usefulCounts();
    std::optional<IntervalPlan> plan(std::size_t rowCount, const LineStyle& style, double errorMmPerS);

    const MotionProfile& m_motion;
    double m_pulsesPerMm;
    RowRules m_rules;
    double m_unitHz; // speed unit of the registers
    std::optional<double> m_finestHz;
    std::vector<std::size_t> m_counts;  // numbers of rows, ascending
    std::map<PlanKey, double> m_errors; // in mm/s, of the plans made so far; infinite for a useless one
    std::optional<std::size_t> m_usefulCounts;    // how many of these are tried at most
    std::vector<std::unique_ptr<Level>> m_levels; // each finer than the previous one, created on demand
};

} // namespace campanel::profile::detail
