// SPDX-License-Identifier: Apache-2.0
// Everything that follows from a recipe, computed at once after each change: well below one frame (27 us for
// the table of a cutter, 10 us for the curves). Only intervals take longer; they may be deferred.
#pragma once

#include "app/link/link_values.h"
#include "app/program/program_image.h"
#include "app/program/recipe.h"
#include "app/program/solved_program.h"
#include "profile/cutter/limits.h"
#include "profile/cutter/sampling.h"

#include <memory>
#include <optional>
#include <vector>

namespace campanel::panel {

struct Solution {
    std::optional<program::SolvedProgram> solved;       // empty: the recipe has no motion
    std::shared_ptr<const profile::Curves> curves;      // for the solved program
    std::vector<profile::Refusal> refusals;             // empty: the machine can execute it
    std::optional<modbus::CodecError> unstorable;       // a value that its register cannot hold
    std::shared_ptr<const program::ProgramImage> image; // image for a download; null unless feasible
    std::optional<profile::FastestRate> fastest;        // only for a rotary cutter
    bool isTablePending = false;                        // within the limits, the table is deferred

    // Returns null unless it is a solved rotary cutter.
    [[nodiscard]] const profile::RotaryCutter* cutter() const
    {
        return solved && solved->cutter ? &*solved->cutter : nullptr;
    }
    [[nodiscard]] bool isFeasible() const { return image != nullptr; }
    // Returns true when the recipe is feasible with a small margin.
    [[nodiscard]] bool isCloseToLimit() const;
};

enum class TableWork { All, WithoutSlow };

// Solves the recipe with the timer and table size of the controller, when it is known. WithoutSlow defers
// intervals.
[[nodiscard]] Solution solveRecipe(const program::Recipe& recipe,
                                   const std::optional<modbus::Identity>& controller,
                                   TableWork work = TableWork::All);

} // namespace campanel::panel
