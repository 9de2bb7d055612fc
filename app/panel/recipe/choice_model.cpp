// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/choice_model.h"

#include "app/panel/words/recipe_words.h"

#include <algorithm>

namespace campanel::panel {

void ChoiceModel::show(const program::Recipe& recipe)
{
    QList<Row> rows;
    for (const program::Choice choice : program::kindInfo(recipe.kind()).choices) {
        if (choice == program::Choice::Law)
            continue;
        const program::ChoiceInfo info = program::choiceInfo(recipe.kind(), choice);
        Row row{choice, RecipeWords::choiceName(choice), {}, 0};
        for (const program::ChoiceOption& option : info.options)
            row.options << RecipeWords::optionName(option.key);
        const auto current = std::ranges::find(info.options, program::choice(recipe.program, choice),
                                               &program::ChoiceOption::code);
        row.option = static_cast<int>(current - info.options.begin());
        rows << row;
    }
    if (rows == m_rows)
        return;
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
    emit countChanged();
}

bool ChoiceModel::apply(int row, int option, program::Recipe& recipe) const
{
    if (row < 0 || row >= count() || option < 0 || option >= m_rows[row].options.size())
        return false;
    const program::Choice choice = m_rows[row].choice;
    const auto options = program::choiceInfo(recipe.kind(), choice).options;
    program::setChoice(recipe.program, choice, options[static_cast<std::size_t>(option)].code);
    return true;
}

int ChoiceModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant ChoiceModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row& row = m_rows[index.row()];
    switch (role) {
    case NameRole:
        return row.name;
    case ValueTextRole:
        return row.options.value(row.option);
    case OptionsRole:
        return row.options;
    case OptionRole:
        return row.option;
    default:
        return {};
    }
}

QHash<int, QByteArray> ChoiceModel::roleNames() const
{
    return {
        {NameRole, "name"}, {ValueTextRole, "valueText"}, {OptionsRole, "options"}, {OptionRole, "option"}};
}

} // namespace campanel::panel
