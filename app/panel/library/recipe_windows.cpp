// SPDX-License-Identifier: Apache-2.0
#include "app/panel/library/recipe_windows.h"

#include "app/panel/library/recipes.h"
#include "app/panel/recipe/recipe_comparison.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/refusal_sentences.h"

#include <algorithm>

namespace campanel::panel {

RecipeWindow::RecipeWindow(const program::Recipe& solved, profile::Field field, QObject* parent)
    : QObject(parent)
    , m_field(field)
    , m_present(RefusalSentences::valueWithUnit(field, program::value(solved, field)))
{
    if (const auto found = solved.windows.find(field); found != solved.windows.end())
        m_window = found->second;
    connect(&m_lowest, &Value::setRequested, this,
            [this](double value) { set(&program::ApprovedWindow::min, value); });
    connect(&m_highest, &Value::setRequested, this,
            [this](double value) { set(&program::ApprovedWindow::max, value); });
    show();
}

QString RecipeWindow::fieldId() const
{
    const std::string_view id = profile::info(m_field).id;
    return QString::fromLatin1(id.data(), static_cast<qsizetype>(id.size()));
}

QString RecipeWindow::label() const
{
    return RecipeWords::fieldName(m_field);
}

void RecipeWindow::set(double program::ApprovedWindow::*end, double value)
{
    const profile::FieldInfo& info = profile::info(m_field);
    if (!m_window)
        m_window = program::ApprovedWindow{info.min, info.max};
    (*m_window).*end = value;
    show();
}

void RecipeWindow::clear()
{
    m_window.reset();
    show();
}

void RecipeWindow::show()
{
    const profile::FieldInfo& info = profile::info(m_field);
    const auto showEnd = [&](Value& value, const QString& label, double program::ApprovedWindow::*end) {
        ValueView view;
        view.label = label;
        view.unit = RecipeWords::unit(info.unit);
        view.minimum = info.min;
        view.maximum = info.max;
        view.decimals = info.decimals;
        view.defaultValue = end == &program::ApprovedWindow::min ? info.min : info.max;
        view.text = Format::unknownText();
        if (m_window) {
            const ShownUnit shown = Units::of(view.unit);
            view.value = (*m_window).*end;
            view.text = Format().number(view.value * shown.factor, shown.decimals(info.decimals));
        }
        value.show(view);
    };
    showEnd(m_lowest, tr("%1, lowest", "name of a value").arg(label()), &program::ApprovedWindow::min);
    showEnd(m_highest, tr("%1, highest", "name of a value").arg(label()), &program::ApprovedWindow::max);
    emit changed();
}

RecipeWindows::RecipeWindows(Recipes& recipes)
    : QObject(&recipes)
    , m_recipes(recipes)
{
}

QVariantList RecipeWindows::rows() const
{
    QVariantList rows;
    for (RecipeWindow* each : m_rows)
        rows << QVariant::fromValue(each);
    return rows;
}

RecipeWindow* RecipeWindows::row(profile::Field field) const
{
    const auto found = std::ranges::find(m_rows, field, &RecipeWindow::field);
    return found == m_rows.end() ? nullptr : *found;
}

program::ApprovedWindows RecipeWindows::draft() const
{
    program::ApprovedWindows windows;
    for (const RecipeWindow* each : m_rows) {
        if (each->window())
            windows[each->field()] = *each->window();
    }
    return windows;
}

bool RecipeWindows::isTouched() const
{
    return draft() != m_recipe.windows;
}

QString RecipeWindows::problem() const
{
    for (const RecipeWindow* each : m_rows) {
        const auto& window = each->window();
        if (window && window->min > window->max)
            return tr("%1: the lowest value is above the highest. Correct one of them.").arg(each->label());
    }
    return {};
}

void RecipeWindows::begin()
{
    for (RecipeWindow* each : m_rows)
        each->deleteLater(); // a page may still show it
    m_rows.clear();
    const store::RecipeVersion* chosen = m_recipes.chosenRecipe();
    m_recipe = chosen ? chosen->recipe : program::Recipe();
    const program::Recipe solved = RecipeComparison::solved(m_recipe);
    for (const profile::Field field : program::kindInfo(solved.kind()).programFields) {
        if (!chosen || !program::canHaveWindow(solved, field))
            continue;
        m_rows << new RecipeWindow(solved, field, this);
        connect(m_rows.last(), &RecipeWindow::changed, this, &RecipeWindows::changed);
    }
    emit begun();
    emit changed();
}

void RecipeWindows::store()
{
    if (!m_recipes.accessCheck().require(Level::Technician) || !problem().isEmpty() || !isTouched())
        return;
    // Another version may have been saved since the draft began.
    const store::RecipeVersion* newest = m_recipes.named(QString::fromStdString(m_recipe.name));
    program::Recipe recipe = newest ? newest->recipe : m_recipe;
    recipe.windows = draft();
    m_recipe.windows = recipe.windows;
    m_recipes.setWindows(recipe);
    emit changed();
}

} // namespace campanel::panel
