// SPDX-License-Identifier: Apache-2.0
// Two recipes compared input by input, in words; they need not be feasible, nor be in any controller.
#pragma once

#include "app/panel/kit/difference_model.h"
#include "app/program/recipe.h"

#include <QCoreApplication>

namespace campanel::machine {

class RecipeComparison {
    Q_DECLARE_TR_FUNCTIONS(RecipeComparison)

public:
    // The numbers of a cycle that follow from the pinned ones, filled in; as it is when it is no cycle.
    [[nodiscard]] static program::Recipe solved(program::Recipe recipe);
    // What differs; active is `before`, edited is `after`. The version and the data of the machine do not
    // count, nor does a number that neither of the two reads.
    [[nodiscard]] static QList<DifferenceRow> rows(const program::Recipe& before,
                                                   const program::Recipe& after);
    // "250.0 mm · 60.0 bags/min": the first two inputs.
    [[nodiscard]] static QString summary(const program::Recipe& recipe);

private:
    [[nodiscard]] static QString pinnedText(const program::Recipe& recipe);
    [[nodiscard]] static QString choiceText(const program::Recipe& recipe, program::Choice choice);
};

} // namespace campanel::machine
