// SPDX-License-Identifier: Apache-2.0
#include "tests/looks/screen_lists.h"

#include "tests/looks/test_window.h"

#include <array>

namespace campanel::looks {

namespace {

using namespace Qt::StringLiterals;
using panel::Recipes;

struct Kept {
    const char* name;
    double lengthMm;
    double rateBagsPerMin;
    const char* by;
    int day; // day of January
};

constexpr std::array kept{Kept{"Chocolate bar 120", 120, 180, "Anna", 5},
                          Kept{"Chocolate bar 120", 122, 180, "Li Wei", 8},
                          Kept{"Chocolate bar 120", 122, 165, "Anna", 9},
                          Kept{"Rusk 310", 310, 45, "Li Wei", 9},
                          Kept{"Biscuit 250 twin", 250, 75, "Anna", 10},
                          Kept{"Wafer 90", 90, 190, "Anna", 11},
                          Kept{"\xE8\x8B\x8F\xE6\x89\x93\xE9\xA5\xBC\xE5\xB9\xB2 200", 200, 90, "Li Wei", 12},
                          Kept{"Crispbread 160", 160, 120, "Anna", 13}};
constexpr int keptNames = 7; // including the open one

tl::expected<void, store::StoreError> saveAll(store::Database& database)
{
    store::RecipeLibrary library(database);
    for (const Kept& each : kept) {
        program::Recipe recipe;
        recipe.name = each.name;
        recipe.cutter().bagLengthMm = each.lengthMm;
        recipe.cutter().rateBagsPerMin = each.rateBagsPerMin;
        const QDateTime when(QDate(2026, 1, each.day), QTime(9, 30));
        if (const auto saved = library.save(recipe, QString::fromLatin1(each.by), when.toMSecsSinceEpoch());
            !saved)
            return tl::unexpected(saved.error());
    }
    return {};
}

// Opens the page with a library, then taps.
void openLibrary(TestWindow& window, const QStringList& tapped = {})
{
    Recipes& recipes = window.panel().recipes();
    recipes.setSearch({});
    recipes.dismissMessage();
    if (recipes.total() < keptNames) {
        window.panel().records().store().run(&recipes, &saveAll,
                                             [&recipes](const auto& /*saved*/) { recipes.reload(); });
        window.waitUntil(recipes, &Recipes::listChanged,
                         [](const Recipes& each) { return each.total() >= keptNames; });
    }
    window.tap(QStringLiteral("nav_recipes"));
    window.tap(QStringLiteral("recipe0"));
    for (const QString& name : tapped)
        window.tap(name);
}

void openCodes(TestWindow& window)
{
    openLibrary(window);
    window.panel().settings().overrideValue("scanner.prefix", QStringLiteral("~~"));
    window.settle();
    window.tap(QStringLiteral("recipeCodes"));
}

Screen page(const char* name, const QStringList& tapped = {})
{
    return {QString::fromLatin1(name), [tapped](TestWindow& window) { openLibrary(window, tapped); }};
}

// Returns a usable file, an unusable one, and a signed recipe with many differences.
QList<store::RecipeOffer> recipesOnStick(const QString& /*ownFolder*/)
{
    const QString path = QStringLiteral("/media/panel/KINGSTON/");
    const QString place = QStringLiteral("KINGSTON");
    program::Recipe recipe;
    recipe.name = "Rusk 310";
    recipe.cutter().bagLengthMm = 315;
    store::FileError error{
        store::FileError::Kind::NotJson, path + QStringLiteral("notes.json"), {}, {}, {}, 17};
    error.found = QStringLiteral("illegal value");
    program::Recipe next;
    next.name = "Biscuit 250";
    next.version = 8;
    next.cutter().bagLengthMm = 260;
    next.cutter().rateBagsPerMin = 70;
    next.cutter().k = {4.2, 2.6, 1.7, 1.35};
    return {
        {path + QStringLiteral("Rusk 310.json"), place, QDateTime(QDate(2026, 1, 14), QTime(8, 12)), recipe},
        {error.path, place, QDateTime(QDate(2026, 1, 2), QTime(16, 40)), tl::unexpected(error)},
        {path + QStringLiteral("Biscuit 250 signed.json"), place, QDateTime(QDate(2026, 1, 1), QTime(9, 30)),
         next, store::RecipeSignature{QStringLiteral("Anna Plant"), 0, 0}}};
}

// Returns a recipe from the plant's network, an older one and one of an unknown signer.
QList<store::RecipeOffer> recipesFromPlant(const QString& ownFolder)
{
    const QString place = store::FileErrorText::tr("Plant network");
    const QDateTime received(QDate(2026, 1, 15), QTime(14, 2));
    store::RecipeOffer next = recipesOnStick(ownFolder).last();
    next.path = QStringLiteral("Biscuit");
    next.placeName = place;
    next.changed = received;
    next.isFromPlant = true;
    store::RecipeOffer older = next;
    older.path = QStringLiteral("Chocolate");
    older.recipe->name = "Chocolate bar 120";
    older.recipe->version = 1;
    store::FileError error{
        store::FileError::Kind::UnknownSigner, QStringLiteral("Wafer"), {}, QStringLiteral("Bert"), {}, 0};
    return {next, older, {error.path, place, received, tl::unexpected(error), {}, true}};
}

Screen importing(const char* name, const QString& tapped)
{
    return {QString::fromLatin1(name), [tapped](TestWindow& window) {
                panel::RecipeFiles& files = *window.panel().recipes().files();
                files.setScanner(&recipesOnStick);
                openLibrary(window, {QStringLiteral("recipeImport")});
                window.waitFor(files);
                window.tap(tapped);
            }};
}

// Opens the page with the notice of an offer, and by its key the list; without a tap the page stays.
Screen offering(const char* name, const QString& tapped = {})
{
    return {QString::fromLatin1(name), [tapped](TestWindow& window) {
                panel::RecipeFiles& files = *window.panel().recipes().files();
                files.setScanner(&recipesFromPlant);
                openLibrary(window);
                files.scan();
                window.waitFor(files);
                if (tapped.isEmpty())
                    return;
                window.tap(QStringLiteral("recipeOffer"));
                window.waitFor(files);
                window.tap(tapped);
            }};
}

// Opens a dialog with rows from the database.
Screen versions(const char* name, const QString& tapped)
{
    return {QString::fromLatin1(name), [tapped](TestWindow& window) {
                openLibrary(window);
                const auto& rows = window.panel().recipes().list()->rows();
                const auto row =
                    std::ranges::find(rows, QStringLiteral("Chocolate bar 120"), &panel::RecipeRow::name);
                window.panel().recipes().choose(static_cast<int>(row - rows.begin()));
                panel::OfferModel& candidates = *window.panel().recipes().candidates();
                window.tap(QStringLiteral("recipeVersions"));
                window.waitUntil(candidates, &panel::OfferModel::countChanged,
                                 [](const panel::OfferModel& model) { return model.count() == 3; });
                window.tap(tapped);
            }};
}

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
        if (const auto* running = recipes.named(u"Biscuit 250"_s))
            emit recipes.codesSet(*running);
    }
    window.link().show(DemoLink::Situation::Stopped);
    window.tap(u"nav_run"_s);
    window.panel().scan().takeCode(u"PP 40 white"_s);
    window.settle();
}

} // namespace

QList<Screen> recipeScreens()
{
    return {page("recipes"),
            {QStringLiteral("recipes-nothing-found"),
             [](TestWindow& window) {
                 openLibrary(window);
                 window.panel().recipes().setSearch(QStringLiteral("pretzel"));
             }},
            {QStringLiteral("recipes-edited"),
             [](TestWindow& window) {
                 window.panel().editor().bagLength()->set(240);
                 openLibrary(window);
             }},
            {QStringLiteral("recipes-unsaved"),
             [](TestWindow& window) {
                 window.panel().editor().bagLength()->set(240);
                 openLibrary(window, {QStringLiteral("recipe1"), QStringLiteral("recipeOpen")});
             }},
            page("recipes-new-kind", {QStringLiteral("recipeNew")}),
            page("recipes-name", {QStringLiteral("recipeRename")}),
            page("recipes-name-signs", {QStringLiteral("recipeCopy"), QStringLiteral("textSigns")}),
            {QStringLiteral("recipes-name-pinyin"),
             [](TestWindow& window) {
                 openLibrary(window, {QStringLiteral("recipeRename")});
                 if (QLocale().language() != QLocale::Chinese)
                     window.tap(QStringLiteral("textChinese"));
                 for (const QChar letter : QStringLiteral("binggan"))
                     window.tap(QStringLiteral("key_") + letter);
             }},
            {QStringLiteral("recipes-codes"), [](TestWindow& window) { openCodes(window); }},
            {QStringLiteral("recipes-windows"),
             [](TestWindow& window) {
                 openLibrary(window, {QStringLiteral("recipeWindows")});
                 panel::RecipeWindows& windows = *window.panel().recipes().windows();
                 windows.row(profile::Field::BagLength)->lowest()->set(240);
                 windows.row(profile::Field::BagLength)->highest()->set(260);
                 windows.row(profile::Field::Rate)->lowest()->set(70);
                 windows.row(profile::Field::Rate)->highest()->set(55);
             }},
            {QStringLiteral("recipes-code"),
             [](TestWindow& window) {
                 openCodes(window);
                 window.tap(QStringLiteral("codeOfRecipe"));
             }},
            {QStringLiteral("recipes-scan-edits"),
             [](TestWindow& window) {
                 openLibrary(window);
                 window.panel().editor().bagLength()->set(240);
                 window.panel().scan().takeCode(QStringLiteral("Rusk 310"));
             }},
            {QStringLiteral("recipes-scan-unknown"),
             [](TestWindow& window) {
                 openLibrary(window);
                 window.panel().scan().takeCode(QStringLiteral("4006381333931"));
             }},
            {QStringLiteral("recipes-name-kept"),
             [](TestWindow& window) {
                 openLibrary(window, {QStringLiteral("recipeRename"), QStringLiteral("key_q")});
                 window.frame()->property("sheet").value<QQuickItem*>()->setProperty("warned", true);
             }},
            page("recipes-search", {QStringLiteral("recipeSearch"), QStringLiteral("textCapital")}),
            versions("recipes-versions", QStringLiteral("candidate0")),
            page("recipes-compare", {QStringLiteral("recipeCompare"), QStringLiteral("candidate1")}),
            page("recipes-remove", {QStringLiteral("recipe1"), QStringLiteral("recipeRemove")}),
            importing("recipes-import", QStringLiteral("offer0")),
            importing("recipes-import-bad", QStringLiteral("offer1")),
            importing("recipes-import-signed", QStringLiteral("offer2")),
            offering("recipes-offered"),
            offering("recipes-inbox", QStringLiteral("offer0")),
            offering("recipes-inbox-older", QStringLiteral("offer1"))};
}

// A scanner that is set up, and a wrong film reel. They come last: they leave Start blocked.
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
