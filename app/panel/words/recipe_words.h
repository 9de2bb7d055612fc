// SPDX-License-Identifier: Apache-2.0
// Translated names of fields, units, laws and limits.
#pragma once

#include "app/program/program_kinds.h"
#include "app/program/recipe.h"
#include "profile/model/fields.h"
#include "profile/model/law.h"
#include "profile/model/refusal.h"

#include <QCoreApplication>

namespace campanel::panel {

class RecipeWords {
    Q_DECLARE_TR_FUNCTIONS(RecipeWords)

public:
    // Translates a text that profile/ or app/program marks.
    [[nodiscard]] static QString inWords(std::string_view text);
    [[nodiscard]] static QString fieldName(profile::Field field)
    {
        return inWords(profile::info(field).name);
    }
    // Returns the value as it is shown, with the field's decimals and without its unit; ratios without
    // superfluous zeros.
    [[nodiscard]] static QString valueText(profile::Field field, double value);
    [[nodiscard]] static QString unit(std::string_view unit); // the metric one, "mm/s^2" -> "mm/s²"
    // Returns an empty text for an unknown law.
    [[nodiscard]] static QString lawName(profile::LawId law);
    [[nodiscard]] static QString lawParameterName(std::string_view parameterId);
    // Returns the name of a recipe that nobody named: that of its bag in the shown unit ("Bag 180",
    // "Bag 7.087 in"), or of its kind.
    [[nodiscard]] static QString proposedName(const program::Recipe& recipe);
    // Returns true when the recipe has such a name, in either unit.
    [[nodiscard]] static bool isProposedName(const program::Recipe& recipe);
    [[nodiscard]] static QString kindName(profile::ProgramKind kind)
    {
        return inWords(program::kindInfo(kind).name);
    }
    // Returns "Knots", "Segments"; the kind must have a list.
    [[nodiscard]] static QString listName(profile::ProgramKind kind)
    {
        return inWords(program::kindInfo(kind).list->name);
    }
    [[nodiscard]] static QString listSize(const profile::Program& program); // "5 knots"
    [[nodiscard]] static QString choiceName(profile::ProgramKind kind, program::Choice choice)
    {
        return inWords(program::choiceInfo(kind, choice).name);
    }
    // Returns "acceleration", for the end of a sentence.
    [[nodiscard]] static QString limitName(profile::Limit limit)
    {
        return inWords(profile::limitName(limit));
    }

private:
    [[nodiscard]] static QString proposedName(const program::Recipe& recipe, bool isInch);
};

} // namespace campanel::panel
