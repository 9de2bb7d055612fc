// SPDX-License-Identifier: Apache-2.0
#include "app/machine/differences_text.h"

#include "app/machine/editor_views.h"
#include "app/machine/recipe_edit.h"
#include "app/machine/recipe_words.h"
#include "app/machine/refusal_sentences.h"

namespace campanel::machine {

namespace {

bool isDerivedInBoth(const program::Difference& difference, const program::Recipe& active,
                     const program::Recipe& edited)
{
    return difference.field && isPinnable(*difference.field) &&
           !profile::isPinned(active.program, *difference.field) &&
           !profile::isPinned(edited.program, *difference.field);
}

QString lawText(double code)
{
    return RecipeWords::lawName(static_cast<profile::LawId>(static_cast<int>(code)));
}

} // namespace

QString DifferencesText::pinnedText(std::uint16_t bits)
{
    QStringList names;
    for (std::size_t i = 0; i < program::pinnableFields.size(); ++i) {
        if (bits >> i & 1)
            names << RecipeWords::fieldName(program::pinnableFields[i]);
    }
    return names.join(QStringLiteral(" + "));
}

DifferenceRow DifferencesText::row(const program::Difference& difference)
{
    if (difference.field)
        return {RecipeWords::fieldName(*difference.field),
                RefusalSentences::valueWithUnit(*difference.field, difference.a),
                RefusalSentences::valueWithUnit(*difference.field, difference.b)};
    if (difference.info->name == "program.recipe_name")
        return {tr("Recipe"), QString::fromStdString(difference.textA),
                QString::fromStdString(difference.textB)};
    if (difference.info->name == "program.law")
        return {tr("Speed law"), lawText(difference.a), lawText(difference.b)};
    if (difference.info->name == "program.pinned")
        return {tr("Pinned"), pinnedText(static_cast<std::uint16_t>(difference.a)),
                pinnedText(static_cast<std::uint16_t>(difference.b))};
    const QString name =
        difference.info->name == "program.law_parameter2" ? tr("Law parameter 2") : tr("Law parameter 1");
    return {name, Format().compact(difference.a, 0, 3), Format().compact(difference.b, 0, 3)};
}

QList<DifferenceRow> DifferencesText::rows(const ControllerProgram& active,
                                           const program::ProgramImage& edited)
{
    QList<DifferenceRow> rows;
    for (const program::Difference& difference : program::differences(active.registers, edited.registers)) {
        if (difference.info->name != "program.recipe_version" &&
            !isDerivedInBoth(difference, active.recipe, edited.recipe))
            rows << row(difference);
    }
    return rows;
}

} // namespace campanel::machine
