// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/choice_model.h"

#include "app/panel/words/master_sentences.h"
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

ChoiceRow masterRow(program::RecipeMaster present)
{
    using enum program::RecipeMaster;
    ChoiceRow row;
    row.name = MasterSentences::title();
    row.group = QStringLiteral("tools"); // not among the inputs, which must fit the screen
    for (const auto master : {Any, Clock, Encoder}) {
        row.options << MasterSentences::name(master);
        row.codes << static_cast<std::uint16_t>(master);
    }
    row.option = static_cast<int>(present);
    return row;
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
    if (program::hasMaster(recipe))
        rows << masterRow(recipe.master);
    return rows;
}

void ChoiceRow::apply(int index, program::Recipe& recipe) const
{
    if (index < 0 || index >= codes.size())
        return;
    if (choice)
        program::setChoice(recipe.program, *choice, codes[index]);
    else
        recipe.master = static_cast<program::RecipeMaster>(codes[index]);
}

} // namespace campanel::panel
