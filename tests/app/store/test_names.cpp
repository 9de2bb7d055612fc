// SPDX-License-Identifier: Apache-2.0
// One rule for the names of recipes and users, for the program, the database, files and what earlier versions
// kept.
#include "app/store/database/names.h"
#include "app/store/recipes/recipe_json.h"
#include "app/store/recipes/recipe_keys.h"
#include "app/store/recipes/recipe_library.h"
#include "app/store/users/user_store.h"
#include "tests/support/earlier_schema.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

namespace test_names {

using namespace campanel::store;
namespace program = campanel::program;
namespace test = campanel::test;
using namespace Qt::StringLiterals;

namespace {

program::Recipe recipe(const QString& name, double lengthMm = 310)
{
    program::Recipe made;
    made.name = name.toStdString();
    made.cutter().bagLengthMm = lengthMm;
    return made;
}

QStringList recipeNames(Database& database)
{
    QStringList names;
    const auto newest = RecipeLibrary(database).newest().value_or(QList<RecipeVersion>());
    for (const RecipeVersion& each : newest)
        names << QString::fromStdString(each.recipe.name);
    names.sort();
    return names;
}

} // namespace

class TestNames : public QObject {
    Q_OBJECT

private slots:
    void oneName_data()
    {
        QTest::addColumn<QString>("left");
        QTest::addColumn<QString>("right");
        QTest::newRow("capitals") << u"Biscuit"_s << u"BISCUIT"_s;
        QTest::newRow("capitals beyond ASCII") << u"Tüte"_s << u"TÜTE"_s;
        QTest::newRow("Greek") << u"ΣΟΚΟΛΑΤΑ"_s << u"σοκολατα"_s;
        QTest::newRow("Cyrillic") << u"Печенье"_s << u"ПЕЧЕНЬЕ"_s;
        QTest::newRow("composed and not") << u"T\u00fcte"_s << u"Tu\u0308te"_s;
        QTest::newRow("composed, capitals") << u"T\u00dcTE"_s << u"tu\u0308te"_s;
        QTest::newRow("Hangul") << u"\ud55c"_s << u"\u1112\u1161\u11ab"_s;
        QTest::newRow("space at the end") << u"Biscuit"_s << u"Biscuit "_s;
        QTest::newRow("wide space at the beginning") << u"Biscuit"_s << u"\u3000Biscuit"_s;
        QTest::newRow("two spaces") << u"Biscuit 250"_s << u"Biscuit  250"_s;
        QTest::newRow("space that does not break") << u"Biscuit 250"_s << u"Biscuit\u00a0250"_s;
    }

    void oneName()
    {
        QFETCH(QString, left);
        QFETCH(QString, right);
        QVERIFY(isSameName(left, right));
        const auto database = Database::inMemory();
        RecipeLibrary library(*database);
        const auto first = library.save(recipe(left), {}, 1);
        const auto second = library.save(recipe(right, 320), {}, 2);
        QVERIFY(first && second);
        QCOMPARE(second->recipeId, first->recipeId);
        QCOMPARE(recipeNames(*database), QStringList{keptName(right)});
        QVERIFY(*library.has(second->recipe));
        QVERIFY(addUser(*database, left, UserLevel::Service, u"hash"_s));
        QVERIFY(!addUser(*database, right, UserLevel::Operator, u"hash"_s));
        const auto other = library.save(recipe(u"Other"_s), {}, 3);
        QVERIFY(!library.rename(other->recipeId, left));
    }

    void otherNames()
    {
        for (const auto& [left, right] :
             {std::pair(u"Tute"_s, u"Tüte"_s), {u"A"_s, u"Α"_s}, {u"饼干"_s, u"餅乾"_s}})
            QVERIFY2(!isSameName(left, right), qPrintable(left));
        QVERIFY(keptName(u" \t\u3000 "_s).isEmpty());
    }

    void hiddenCharacters_data()
    {
        QTest::addColumn<char32_t>("character");
        for (const char32_t character :
             {0x00U,   0x07U,   0x09U,   0x0aU,   0x0dU,   0x7fU,   0x85U,   0xadU,   0x034fU,  0x115fU,
              0x180eU, 0x200bU, 0x200cU, 0x200dU, 0x200eU, 0x200fU, 0x2028U, 0x2029U, 0x202aU,  0x202eU,
              0x2060U, 0x2066U, 0x2069U, 0x2800U, 0x3164U, 0xfe0fU, 0xfeffU, 0xffa0U, 0xe0041U, 0xe0100U})
            QTest::addRow("U+%04X", character) << static_cast<char32_t>(character);
    }

    void hiddenCharacters()
    {
        QFETCH(char32_t, character);
        const QString name = u"Bis"_s + QStringView(QChar::fromUcs4(character)).toString() + u"cuit"_s;
        QVERIFY(hiddenCharacter(name) == character);
        QVERIFY(isSameName(name, u"Biscuit"_s));
        QVERIFY(!isSignerName(name));
        const auto database = Database::inMemory();
        QVERIFY(!addUser(*database, name, UserLevel::Service, u"hash"_s));
        const auto read = fromJson(toJson(recipe(name)), u"outside.json"_s);
        QVERIFY(!read);
        QCOMPARE(static_cast<int>(read.error().kind), static_cast<int>(FileError::Kind::HiddenCharacter));
        QVERIFY(
            FileErrorText::describe(read.error())
                .contains(u"U+%1"_s.arg(QString::number(character, 16).toUpper().rightJustified(4, u'0'))));
        // A recipe that this panel kept is read.
        QCOMPARE(fromJson(toJson(recipe(name)), {}, Names::Repair)->name, "Biscuit");
    }

    void namesOfFilesAreBroughtIntoForm()
    {
        QCOMPARE(fromJson(toJson(recipe(u" Tu\u0308te "_s)), {})->name, "T\xc3\xbcte");
        for (const QString& empty : {u""_s, u"  "_s, u"\u3000"_s}) {
            QVERIFY(!fromJson(toJson(recipe(empty)), {}));
            QCOMPARE(fromJson(toJson(recipe(empty)), {}, Names::Repair)->name, "?");
        }
    }

    // The database of the version before had one key for letters of ASCII alone.
    void namesOfAnEarlierVersion()
    {
        const QTemporaryDir folder;
        {
            const auto database = *Database::open(folder.path(), test::earlierSchema<&mainDatabase, 7>());
            int id = 0;
            for (const QString& name :
                 {u"TÜTE"_s, u"Tüte"_s, u"Biscuit "_s, u"Biscuit"_s, u"Cake\u200b"_s, u""_s}) {
                QVERIFY(database->execute(u"INSERT INTO recipe (id, name) VALUES (?, ?)"_s, {++id, name}));
                QVERIFY(database->execute(
                    u"INSERT INTO recipe_version VALUES (?, 1, ?, '', 'rotary_cutter', ?, 0)"_s,
                    {id, id, toJson(recipe(name, 300 + id))}));
            }
            for (const QString& name : {u"Jörg"_s, u"JÖRG"_s})
                QVERIFY(
                    database->execute(u"INSERT INTO user (name, level, pin) VALUES (?, 3, 'x')"_s, {name}));
        }
        for (int opening = 0; opening < 2; ++opening) {
            const auto database = *Database::open(folder.path());
            QCOMPARE(recipeNames(*database), QStringList({u"?"_s, u"Biscuit"_s, u"Biscuit (2)"_s, u"Cake"_s,
                                                          u"TÜTE"_s, u"Tüte (2)"_s}));
            const auto people = *users(*database);
            QCOMPARE(people.size(), 2);
            QVERIFY(people[0].name == u"JÖRG (2)"_s || people[1].name == u"JÖRG (2)"_s);
            // Said once.
            QCOMPARE(database->opening().renamed.size(), opening == 0 ? 5 : 0);
            QCOMPARE(database->opening().migratedFrom, opening == 0 ? 7 : 0);
        }
    }

    // A number takes the end of a name that has the longest length.
    void longNamesStayShortEnough()
    {
        const QTemporaryDir folder;
        const QString longest = QString(10, u'饼') + u"Ü"_s; // 32 bytes
        {
            const auto database = *Database::open(folder.path(), test::earlierSchema<&mainDatabase, 7>());
            for (const QString& name : {longest, longest.toLower()})
                QVERIFY(database->execute(u"INSERT INTO recipe (name) VALUES (?)"_s, {name}));
        }
        const auto database = *Database::open(folder.path());
        QCOMPARE(database->opening().renamed.size(), 1);
        const QString renamed = database->opening().renamed.first().after;
        QVERIFY2(renamed.endsWith(u" (2)"_s) && renamed.toUtf8().size() <= 32, qPrintable(renamed));
    }
};

CAMPANEL_TEST(TestNames)

} // namespace test_names

#include "test_names.moc"
