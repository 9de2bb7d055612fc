// SPDX-License-Identifier: Apache-2.0
// The approved windows of a recipe in its file, in a signed one and in the library.
#include "app/store/recipes/recipe_json.h"
#include "app/store/recipes/recipe_library.h"
#include "app/store/recipes/signed_recipe.h"
#include "tests/support/test_program.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace test_recipe_windows {

using namespace campanel;
using namespace campanel::store;
using namespace Qt::StringLiterals;
using Kind = FileError::Kind;
using profile::Field;

namespace {

program::Recipe withWindows()
{
    program::Recipe recipe;
    recipe.windows[Field::Rate] = {55, 70};
    recipe.windows[Field::K1] = {2, 4.5};
    return recipe;
}

FileError errorOf(QByteArray json, const char* text, const char* other)
{
    if (!json.contains(text))
        qFatal("%s is not in the file", text);
    const auto read = fromJson(json.replace(text, other), {});
    return read ? FileError{Kind::NotFound, {}, {}, {}, {}, 0} : read.error();
}

} // namespace

class TestRecipeWindows : public QObject {
    Q_OBJECT

private slots:
    // A recipe without windows can be read by an older reader.
    void theyTrip()
    {
        QVERIFY(!toJson(program::Recipe()).contains("windows"));
        const program::Recipe recipe = withWindows();
        const QByteArray json = toJson(recipe);
        QCOMPARE(QJsonDocument::fromJson(json).object()[u"format_version"_s].toInt(), 6);
        const auto read = fromJson(json, {});
        QVERIFY(read.has_value());
        QVERIFY(read->windows == recipe.windows);
    }

    void eachKindKeepsThem()
    {
        for (const program::KindInfo& kind : program::kinds()) {
            program::Recipe recipe = program::defaultRecipe(kind.kind);
            for (const Field field : kind.programFields) {
                if (program::canHaveWindow(recipe, field))
                    recipe.windows[field] = {profile::info(field).min, profile::info(field).max};
            }
            const auto read = fromJson(toJson(recipe), {});
            QVERIFY(read.has_value());
            QVERIFY(read->windows == recipe.windows);
        }
    }

    void badOnesAreRefused()
    {
        const QByteArray json = toJson(withWindows());
        const FileError upsideDown = errorOf(json, "\"max\": 70", "\"max\": 54.9");
        QCOMPARE(upsideDown.kind, Kind::OutOfRange);
        QCOMPARE(upsideDown.key, u"windows.rate_bags_per_min.max"_s);
        const FileError beyond = errorOf(json, "\"max\": 70", "\"max\": 1e9");
        QCOMPARE(beyond.kind, Kind::OutOfRange);
        QCOMPARE(errorOf(json, "\"max\": 70", "\"max\": \"70\"").kind, Kind::WrongType);
        QCOMPARE(errorOf(json, "\"max\": 70", "\"most\": 70").kind, Kind::MissingKey);
        QCOMPARE(errorOf(json, "\"max\": 70", "\"max\": 70, \"to\": 1").key,
                 u"windows.rate_bags_per_min.to"_s);
        const FileError machine = errorOf(json, "\"k1\": {", "\"knife_radius_mm\": {");
        QCOMPARE(machine.kind, Kind::UnknownKey);
    }

    void aSignedOneKeepsThem()
    {
        const auto key = newSigningKey(u"Plant"_s);
        QVERIFY(key);
        const auto publicKey = publicKeyIn(publicKeyFile(*key));
        const QByteArray json = signRecipe(withWindows(), 1'790'000'000'000, 7, *key);
        const auto read = verifyRecipe(json, {}, {*publicKey});
        QVERIFY(read.has_value());
        QVERIFY(read->recipe.windows == withWindows().windows);
    }

    // Other windows are another version, of which the earlier one stays.
    void theLibraryKeepsThem()
    {
        const std::unique_ptr<Database> database = Database::inMemory();
        RecipeLibrary library(*database);
        program::Recipe recipe;
        QCOMPARE(library.save(recipe, u"Ana"_s, 1)->version, 1);
        recipe.windows = withWindows().windows;
        QCOMPARE(library.save(recipe, u"Ana"_s, 2)->version, 2);
        QCOMPARE(library.save(recipe, u"Ana"_s, 3)->version, 2);
        const auto newest = library.newest();
        QVERIFY(newest && newest->size() == 1);
        QVERIFY(newest->first().recipe.windows == recipe.windows);
        const auto versions = library.versions(newest->first().recipeId);
        QVERIFY(versions && versions->size() == 2);
        QVERIFY(versions->last().recipe.windows.empty());
    }
};

CAMPANEL_TEST(TestRecipeWindows)

} // namespace test_recipe_windows

#include "test_recipe_windows.moc"
