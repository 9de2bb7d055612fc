// SPDX-License-Identifier: Apache-2.0
// Compares two recipes input by input, as text. They need not be feasible, nor in any controller.
#pragma once

#include "app/panel/kit/difference_model.h"
#include "app/program/recipe.h"

#include <QCoreApplication>

namespace campanel::panel {

class RecipeComparison {
    Q_DECLARE_TR_FUNCTIONS(RecipeComparison)

public:
    // Returns the recipe with the numbers of a cycle that follow from the pinned ones. Returns it unchanged
    // when there is no cycle.
    [[nodiscard]] static program::Recipe solved(program::Recipe recipe);
    // Returns the differences; active is `before`, edited is `after`. The version, the machine data and
    // numbers that neither recipe uses are ignored.
    [[nodiscard]] static QList<DifferenceRow> rows(const program::Recipe& before,
                                                   const program::Recipe& after);
    // Returns the first two inputs, "250.0 mm · 60.0 bags/min".
    [[nodiscard]] static QString summary(const program::Recipe& recipe);
    // Return name and amount of a trim, by its place in the table.
    [[nodiscard]] static QString trimTitle(std::size_t trim);
    [[nodiscard]] static QString trimText(const program::Recipe& recipe, std::size_t trim);
    // Return name and limits of the approved window of an input.
    [[nodiscard]] static QString windowTitle(profile::Field field);
    [[nodiscard]] static QString windowText(const program::Recipe& recipe, profile::Field field);

private:
    [[nodiscard]] static QString pinnedText(const program::Recipe& recipe);
    [[nodiscard]] static QString codeText(const std::string& code);
    [[nodiscard]] static QString advanceText(const program::Recipe& recipe);
    [[nodiscard]] static QString choiceText(const program::Recipe& recipe, program::Choice choice);
};

} // namespace campanel::panel
