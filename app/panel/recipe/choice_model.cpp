// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/choice_model.h"

#include "app/panel/words/recipe_words.h"

#include <algorithm>

namespace campanel::panel {

QList<ChoiceRow> ChoiceRow::rows(const program::Recipe& recipe)
{
    QList<ChoiceRow> rows;
    for (const program::ChoiceInfo& info : program::kindInfo(recipe.kind()).choices) {
        if (info.choice == program::Choice::Law || info.choice == program::Choice::Ratios)
            continue; // they have views of their own
        ChoiceRow row{info.choice, RecipeWords::choiceName(info.choice), {}, 0};
        for (const program::ChoiceOption& option : info.options)
            row.options << RecipeWords::optionName(option.key);
        const auto current = std::ranges::find(info.options, program::choice(recipe.program, info.choice),
                                               &program::ChoiceOption::code);
        row.option = static_cast<int>(current - info.options.begin());
        rows << row;
    }
    return rows;
}

void ChoiceRow::apply(int index, program::Recipe& recipe) const
{
    const auto infos = program::choiceInfo(recipe.kind(), choice).options;
    if (index >= 0 && index < options.size())
        program::setChoice(recipe.program, choice, infos[static_cast<std::size_t>(index)].code);
}

} // namespace campanel::panel
