// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/recipe_comparison.h"

#include "app/panel/recipe/recipe_edit.h"
#include "app/panel/words/cam_sentences.h"
#include "app/panel/words/master_sentences.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"
#include "app/panel/words/trim_words.h"
#include "app/program/cam_advance.h"
#include "profile/cutter/rotary_cutter.h"

#include <algorithm>

namespace campanel::panel {

using program::Recipe;

Recipe RecipeComparison::solved(Recipe recipe)
{
    if (recipe.isCutter()) {
        if (const auto numbers = profile::solveNumbers(recipe.cutter(), recipe.machine))
            adopt(recipe, *numbers);
    }
    return recipe;
}

QString RecipeComparison::pinnedText(const Recipe& recipe)
{
    QStringList names;
    for (const profile::Field field : profile::cycleFields) {
        if (profile::isPinned(recipe.cutter(), field))
            names << RecipeWords::fieldName(field);
    }
    return names.join(QStringLiteral(" + "));
}

QString RecipeComparison::choiceText(const Recipe& recipe, program::Choice choice)
{
    const std::uint16_t code = program::choice(recipe.program, choice);
    if (choice == program::Choice::Law)
        return RecipeWords::lawName(static_cast<profile::LawId>(code));
    const auto options = program::choiceInfo(recipe.kind(), choice).options;
    const auto option = std::ranges::find(options, code, &program::ChoiceOption::code);
    return option == options.end() ? Format::unknownText() : RecipeWords::inWords(option->name);
}

QString RecipeComparison::codeText(const std::string& code)
{
    return code.empty() ? tr("none") : QString::fromStdString(code);
}

QString RecipeComparison::advanceText(const Recipe& recipe)
{
    const double mm = program::confirmedAdvanceMm(recipe.program);
    return mm == 0 ? tr("none") : tr("%1 per cycle").arg(CamSentences::signedMm(mm));
}

QString RecipeComparison::trimTitle(std::size_t trim)
{
    return tr("Trim: %1").arg(TrimWords::title(static_cast<program::Trim>(trim)));
}

QString RecipeComparison::trimText(const Recipe& recipe, std::size_t trim)
{
    return TrimWords::amount(static_cast<program::Trim>(trim), recipe.trims[trim]);
}

QString RecipeComparison::windowTitle(profile::Field field)
{
    return tr("Approved: %1", "name of a value").arg(RecipeWords::fieldName(field));
}

QString RecipeComparison::windowText(const Recipe& recipe, profile::Field field)
{
    const auto found = recipe.windows.find(field);
    return found == recipe.windows.end() ? tr("none") : RefusalSentences::window(field, found->second);
}

QList<DifferenceRow> RecipeComparison::rows(const Recipe& before, const Recipe& after)
{
    const Recipe a = solved(before);
    const Recipe b = solved(after);
    QList<DifferenceRow> rows;
    const auto compare = [&rows](const QString& name, const QString& left, const QString& right) {
        if (left != right)
            rows << DifferenceRow{name, left, right};
    };
    compare(tr("Recipe"), QString::fromStdString(a.name), QString::fromStdString(b.name));
    compare(tr("Code"), codeText(a.scanCode), codeText(b.scanCode));
    compare(tr("Film reel"), codeText(a.filmCode), codeText(b.filmCode));
    compare(MasterSentences::title(), MasterSentences::name(a.master), MasterSentences::name(b.master));
    if (a.kind() != b.kind()) {
        compare(tr("Program type"), RecipeWords::kindName(a.kind()), RecipeWords::kindName(b.kind()));
        return rows; // inputs of different kinds cannot be compared
    }
    if (a.isCutter())
        compare(tr("Pinned values"), pinnedText(a), pinnedText(b));
    for (std::size_t i = 0; i < program::trimCount; ++i)
        compare(trimTitle(i), trimText(a, i), trimText(b, i));
    const program::KindInfo& kind = program::kindInfo(a.kind());
    for (const profile::Field field : kind.programFields) {
        if (program::isRead(a.program, field) || program::isRead(b.program, field))
            compare(RecipeWords::fieldName(field),
                    RefusalSentences::valueWithUnit(field, program::value(a, field)),
                    RefusalSentences::valueWithUnit(field, program::value(b, field)));
    }
    for (const profile::Field field : kind.programFields)
        compare(windowTitle(field), windowText(a, field), windowText(b, field));
    for (const program::ChoiceInfo& each : kind.choices)
        compare(RecipeWords::inWords(each.name), choiceText(a, each.choice), choiceText(b, each.choice));
    const profile::LawParameters* left = program::lawParameters(a.program);
    const profile::LawParameters* right = program::lawParameters(b.program);
    for (std::size_t i = 0; left && right && i < left->size(); ++i)
        compare(i == 0 ? tr("Law parameter 1") : tr("Law parameter 2"), Format().compact((*left)[i], 0, 3),
                Format().compact((*right)[i], 0, 3));
    if (kind.list && !kind.list->isEqual(a.program, b.program))
        rows << DifferenceRow{RecipeWords::listName(a.kind()), RecipeWords::listSize(a.program),
                              RecipeWords::listSize(b.program)};
    compare(tr("Confirmed advance"), advanceText(a), advanceText(b));
    return rows;
}

QString RecipeComparison::summary(const Recipe& recipe)
{
    const Recipe numbers = solved(recipe);
    QStringList texts;
    if (program::kindInfo(numbers.kind()).list)
        texts << RecipeWords::listSize(numbers.program);
    for (const profile::Field field : program::kindInfo(numbers.kind()).programFields) {
        const bool isShown = numbers.isCutter() ? profile::info(field).isForOperators
                                                : program::isRead(numbers.program, field);
        if (isShown && texts.size() < 2)
            texts << RefusalSentences::valueWithUnit(field, program::value(numbers, field));
    }
    return texts.join(QStringLiteral(" · "));
}

} // namespace campanel::panel
