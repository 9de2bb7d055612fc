// SPDX-License-Identifier: Apache-2.0
// A scanner that is set up, and a wrong film reel. These screens come last: they leave Start blocked.
#include "tests/looks/screen_lists.h"

#include "tests/looks/test_window.h"

namespace campanel::looks {

namespace {

using namespace Qt::StringLiterals;

tl::expected<void, store::StoreError> saveFilms(store::Database& database)
{
    store::RecipeLibrary library(database);
    for (const auto& [name, filmCode] :
         {std::pair("Biscuit 250", "PE 30 clear"), std::pair("Rusk 310", "PP 40 white")}) {
        program::Recipe recipe;
        recipe.name = name;
        recipe.filmCode = filmCode;
        if (const auto saved = library.save(recipe, {}, 1); !saved)
            return tl::unexpected(saved.error());
    }
    return {};
}

void scanWrongFilm(TestWindow& window)
{
    panel::Recipes& recipes = window.panel().recipes();
    const auto hasFilm = [](const panel::Recipes& each) {
        const auto& newest = each.newest();
        return std::ranges::count_if(
                   newest, [](const auto& version) { return !version.recipe.filmCode.empty(); }) >= 2;
    };
    if (!hasFilm(recipes)) {
        window.panel().records().store().run(&recipes, &saveFilms,
                                             [&recipes](const auto& /*saved*/) { recipes.reload(); });
        window.waitUntil(recipes, &panel::Recipes::listChanged, hasFilm);
    }
    window.link().show(DemoLink::Situation::Stopped);
    window.tap(u"nav_run"_s);
    window.panel().scan().takeCode(u"PP 40 white"_s);
    window.settle();
}

} // namespace

QList<Screen> scanScreens()
{
    return {{u"scanner-read"_s,
             [](TestWindow& window) {
                 window.panel().settings().overrideValue("scanner.prefix", u"~~"_s);
                 for (const char* tapped : {"nav_maintenance", "maintenancePanel", "maintenanceScanner"})
                     window.tap(QString::fromLatin1(tapped));
                 window.panel().scan().takeCode(u"4006381333931"_s);
             }},
            {u"scan-wrong-film"_s, &scanWrongFilm},
            {u"scan-film-reason"_s, [](TestWindow& window) {
                 scanWrongFilm(window);
                 window.tap(u"confirm_override"_s);
             }}};
}

} // namespace campanel::looks
