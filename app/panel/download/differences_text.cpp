// SPDX-License-Identifier: Apache-2.0
#include "app/panel/download/differences_text.h"

#include "app/panel/recipe/recipe_edit.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"

namespace campanel::panel {

namespace {

// Returns true for a number that neither of the two programs uses.
bool isUnreadInBoth(const program::Difference& difference, const program::Recipe& active,
                    const program::Recipe& edited)
{
    return difference.field && active.kind() == edited.kind() &&
           program::isProgramField(active, *difference.field) &&
           !program::isRead(active.program, *difference.field) &&
           !program::isRead(edited.program, *difference.field);
}

QString lawText(double code)
{
    return RecipeWords::lawName(static_cast<profile::LawId>(static_cast<int>(code)));
}

QString optionText(profile::ProgramKind kind, program::Choice choice, double code)
{
    for (const program::ChoiceOption& option : program::choiceInfo(kind, choice).options) {
        if (option.code == static_cast<std::uint16_t>(code))
            return RecipeWords::inWords(option.name);
    }
    return {};
}

} // namespace

QString DifferencesText::pinnedText(std::uint16_t bits)
{
    QStringList names;
    for (std::size_t i = 0; i < profile::cycleFields.size(); ++i) {
        if (bits >> i & 1)
            names << RecipeWords::fieldName(profile::cycleFields[i]);
    }
    return names.join(QStringLiteral(" + "));
}

DifferenceRow DifferencesText::row(const program::Difference& difference, profile::ProgramKind kind)
{
    const std::string_view name = difference.info->name;
    if (name == "cam.master_ramp") {
        constexpr double msPerS = 1000;
        return {RecipeWords::fieldName(profile::Field::MasterRamp),
                RefusalSentences::valueWithUnit(profile::Field::MasterRamp, difference.a / msPerS),
                RefusalSentences::valueWithUnit(profile::Field::MasterRamp, difference.b / msPerS)};
    }
    if (difference.field)
        return {RecipeWords::fieldName(*difference.field),
                RefusalSentences::valueWithUnit(*difference.field, difference.a),
                RefusalSentences::valueWithUnit(*difference.field, difference.b)};
    if (name == "program.recipe_name")
        return {tr("Recipe"), QString::fromStdString(difference.textA),
                QString::fromStdString(difference.textB)};
    if (name == "bank.kind")
        return {tr("Program type"), kindText(difference.a), kindText(difference.b)};
    if (name == "bank.layout")
        return {RecipeWords::choiceName(profile::ProgramKind::PositionMove, program::Choice::Execution),
                layoutText(difference.a), layoutText(difference.b)};
    if (name == "program.pinned")
        return {tr("Pinned values"), pinnedText(static_cast<std::uint16_t>(difference.a)),
                pinnedText(static_cast<std::uint16_t>(difference.b))};
    const std::string_view suffix = name.substr(name.find('.') + 1);
    if (suffix == "law")
        return {kind == profile::ProgramKind::PositionMove ? tr("Displacement law") : tr("Speed law"),
                lawText(difference.a), lawText(difference.b)};
    for (const program::ChoiceInfo& each : program::kindInfo(kind).choices) {
        if (each.registerName == suffix)
            return {RecipeWords::choiceName(kind, each.choice), optionText(kind, each.choice, difference.a),
                    optionText(kind, each.choice, difference.b)};
    }
    const QString parameter = suffix == "law_parameter2" ? tr("Law parameter 2") : tr("Law parameter 1");
    return {parameter, Format().compact(difference.a, 0, 3), Format().compact(difference.b, 0, 3)};
}

QString DifferencesText::kindText(double code)
{
    const auto kind = static_cast<std::size_t>(code);
    return kind >= 1 && kind <= program::kinds().size()
               ? RecipeWords::kindName(static_cast<profile::ProgramKind>(kind))
               : Format::unknownText();
}

QString DifferencesText::layoutText(double code)
{
    const bool isIntervals = static_cast<int>(code) == static_cast<int>(modbus::TableLayout::Intervals);
    const auto execution = isIntervals ? profile::Execution::Intervals : profile::Execution::CamPoints;
    return optionText(profile::ProgramKind::PositionMove, program::Choice::Execution,
                      static_cast<double>(execution));
}

QList<DifferenceRow> DifferencesText::rows(const ControllerProgram& active,
                                           const program::ProgramImage& edited)
{
    QList<DifferenceRow> rows;
    for (const program::Difference& difference : program::differences(active.registers, edited.registers)) {
        if (difference.info->name != "program.recipe_version" &&
            !isUnreadInBoth(difference, active.recipe, edited.recipe))
            rows << row(difference, edited.recipe.kind());
    }
    const program::ListInfo* list = program::kindInfo(edited.recipe.kind()).list;
    if (list && active.recipe.kind() == edited.recipe.kind() &&
        !list->isEqual(active.recipe.program, edited.recipe.program))
        rows << DifferenceRow{RecipeWords::listName(edited.recipe.kind()),
                              RecipeWords::listSize(active.recipe.program),
                              RecipeWords::listSize(edited.recipe.program)};
    return rows;
}

} // namespace campanel::panel
