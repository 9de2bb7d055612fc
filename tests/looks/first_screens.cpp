// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/screen_lists.h"

#include "app/panel/words/recipe_words.h"
#include "tests/looks/test_window.h"

namespace campanel::looks {

namespace {

// A new panel has no recipe yet: its name is proposed.
void openAsNew(panel::Editor& editor)
{
    program::Recipe recipe = editor.newRecipe(DemoLink::Kind::RotaryCutter);
    recipe.version = 0;
    recipe.name = panel::RecipeWords::proposedName(recipe).toStdString();
    editor.open(recipe, {});
}

// Advances by this number of steps, then taps.
Screen step(const char* name, int steps, const QStringList& tapped = {})
{
    return {QString::fromLatin1(name), [steps, tapped](TestWindow& window) {
                window.link().show(DemoLink::Situation::Empty);
                window.checkClock();
                openAsNew(window.panel().editor());
                window.panel().settings().beginFirstStart();
                window.settle();
                for (int i = 0; i < steps; ++i)
                    window.tap(QStringLiteral("firstNext"));
                for (const QString& each : tapped)
                    window.tap(each);
            }};
}

} // namespace

QList<Screen> firstScreens()
{
    return {step("first-language", 0),
            step("first-controller", 1),
            {QStringLiteral("first-controller-searching"),
             [](TestWindow& window) {
                 step("", 1, {QStringLiteral("firstSearch")}).enter(window);
                 window.settle();
             }},
            {QStringLiteral("first-controller-none"),
             [](TestWindow& window) {
                 step("", 1, {QStringLiteral("firstSearch")}).enter(window);
                 window.link().endScan(false);
                 window.settle();
             }},
            {QStringLiteral("first-controller-found"),
             [](TestWindow& window) {
                 step("", 1, {QStringLiteral("firstSearch")}).enter(window);
                 window.link().endScan(true);
                 window.settle();
             }},
            step("first-pin", 2),
            step("first-pin-user", 2, {QStringLiteral("firstSetPin")}),
            step("first-machine", 3),
            step("first-machine-others", 3, {QStringLiteral("firstOthers")}),
            step("first-machine-keypad", 3, {QStringLiteral("first_knife_radius_mm")}),
            step("first-recipe", 4), // the keypad of the length is open
            step("first-recipe-keypad", 4, {QStringLiteral("first_rate_bags_per_min")}),
            step("first-recipe-wide", 4, {QStringLiteral("keypadCancel")}),
            step("first-recipe-downloading", 4, {QStringLiteral("firstDownload")}),
            step("first-start-refused", 4, {QStringLiteral("startKey")})};
}

} // namespace campanel::looks
