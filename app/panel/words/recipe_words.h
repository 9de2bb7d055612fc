// SPDX-License-Identifier: Apache-2.0
// Translated names of fields, units, laws and limits.
#pragma once

#include "app/program/program_kinds.h"
#include "profile/model/fields.h"
#include "profile/model/law.h"
#include "profile/model/refusal.h"

#include <QCoreApplication>

namespace campanel::panel {

class RecipeWords {
    Q_DECLARE_TR_FUNCTIONS(RecipeWords)

public:
    [[nodiscard]] static QString fieldName(profile::Field field);
    // Explains a number of machine or film: its meaning, where to find it and the effect of a wrong one.
    // Empty for the other fields.
    [[nodiscard]] static QString machineHelp(profile::Field field);
    // Returns the value with the field's decimals and without its unit; ratios without superfluous zeros.
    [[nodiscard]] static QString valueText(profile::Field field, double value);
    [[nodiscard]] static QString unit(std::string_view unit); // "mm/s^2" -> "mm/s²"
    // Returns an empty text for an unknown law.
    [[nodiscard]] static QString lawName(profile::LawId law);
    [[nodiscard]] static QString inWords(std::string_view text);
    [[nodiscard]] static QString lawParameterName(std::string_view parameterId);
    [[nodiscard]] static QString kindName(profile::ProgramKind kind);
    // Returns "Knots", "Segments"; the kind must have a list.
    [[nodiscard]] static QString listName(profile::ProgramKind kind);
    [[nodiscard]] static QString listSize(const profile::Program& program); // "5 knots"
    [[nodiscard]] static QString choiceName(program::Choice choice);
    // Returns the name of an option of a choice other than the law, by its key.
    [[nodiscard]] static QString optionName(std::string_view key);
    // Returns "acceleration", for the end of a sentence.
    [[nodiscard]] static QString limitName(profile::Limit limit);
};

} // namespace campanel::panel
