// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/choice_model.h"

#include "app/panel/words/recipe_words.h"

#include <algorithm>

namespace campanel::panel {

namespace {

bool isExecuted(program::Choice choice, std::uint16_t code, const std::optional<modbus::Identity>& controller)
{
    return choice != program::Choice::Execution ||
           code != static_cast<std::uint16_t>(profile::Execution::Intervals) || !controller ||
           controller->supports(modbus::TableLayout::Intervals);
}

} // namespace

QList<ChoiceRow> ChoiceRow::rows(const program::Recipe& recipe,
                                 const std::optional<modbus::Identity>& controller)
{
    QList<ChoiceRow> rows;
    for (const program::ChoiceInfo& info : program::kindInfo(recipe.kind()).choices) {
        if (info.choice == program::Choice::Law || info.choice == program::Choice::Ratios)
            continue; // they have views of their own
        ChoiceRow row;
        row.choice = info.choice;
        row.name = RecipeWords::inWords(info.name);
        row.group = QString::fromLatin1(info.group);
        const std::uint16_t current = program::choice(recipe.program, info.choice);
        for (const program::ChoiceOption& option : info.options) {
            if (option.code != current && !isExecuted(info.choice, option.code, controller))
                continue;
            row.options << RecipeWords::inWords(option.name);
            row.codes << option.code;
        }
        row.option = static_cast<int>(row.codes.indexOf(current));
        rows << row;
    }
    return rows;
}

void ChoiceRow::apply(int index, program::Recipe& recipe) const
{
    if (index >= 0 && index < codes.size())
        program::setChoice(recipe.program, choice, codes[index]);
}

} // namespace campanel::panel
