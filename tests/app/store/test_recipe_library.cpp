// SPDX-License-Identifier: Apache-2.0
// Recipes in the database: versions are kept, numbered without gaps or repeats, and never changed.
#include "app/store/database/clock_mark.h"
#include "app/store/database/names.h"
#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"
#include "app/store/recipes/recipe_library.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

namespace campanel::store::test_recipe_library {

namespace {

program::Recipe recipe(const char* name, double lengthMm, int version = 1)
{
    program::Recipe made;
    made.name = name;
    made.version = version;
    made.cutter().bagLengthMm = lengthMm;
    return made;
}

} // namespace

class TestRecipeLibrary : public QObject {
    Q_OBJECT

    std::unique_ptr<Database> m_database;

    RecipeLibrary library() { return RecipeLibrary(*m_database); }
    RecipeVersion save(const program::Recipe& made, qint64 nowMs = 1000)
    {
        const auto saved = library().save(made, QStringLiteral("Anna"), nowMs);
        if (!saved)
            qFatal("%s", qPrintable(StoreErrorText::describe(saved.error())));
        return *saved;
    }
    QStringList names()
    {
        QStringList found;
        const auto newest = library().newest();
        for (const RecipeVersion& each : *newest)
            found << QStringLiteral("%1 v%2").arg(QString::fromStdString(each.recipe.name)).arg(each.version);
        return found;
    }

private slots:
    void init() { m_database = Database::inMemory(); }

    void keepsWhatWasSavedByWhomAndWhen()
    {
        const RecipeVersion saved = save(recipe("Rusk", 310, 4), 5000);
        const auto newest = library().newest();
        QVERIFY(newest);
        QCOMPARE(newest->size(), 1);
        QCOMPARE(newest->first().recipeId, saved.recipeId);
        QCOMPARE(newest->first().version, 4);
        QCOMPARE(newest->first().savedMs, 5000);
        QCOMPARE(newest->first().savedBy, QStringLiteral("Anna"));
        QCOMPARE(newest->first().recipe.cutter().bagLengthMm, 310.0);
    }

    void marksVersionsOfAClockThatIsNotSet()
    {
        QVERIFY(save(recipe("Rusk", 310), earliestRecordMs - 1).isClockDoubtful);
        QVERIFY(!save(recipe("Rusk", 315, 2), earliestRecordMs).isClockDoubtful);
        QVERIFY(library()
                    .save(recipe("Rusk", 320, 3), {}, earliestRecordMs, ClockState::NotSet)
                    ->isClockDoubtful);
        AlarmRow newer;
        newer.id = 1;
        newer.code = QStringLiteral("C-01");
        newer.raisedMs = earliestRecordMs + 2 * maxSetBackMs;
        AlarmChanges changes;
        changes.rows << newer;
        QVERIFY(AlarmLog::write(*m_database, changes));
        const RecipeVersion behind = save(recipe("Rusk", 325, 4), earliestRecordMs);
        QList<bool> marks;
        const auto versions = library().versions(behind.recipeId);
        QVERIFY(versions);
        for (const RecipeVersion& each : *versions)
            marks << each.isClockDoubtful;
        QCOMPARE(marks, QList<bool>({true, true, false, true}));
        QVERIFY(library().newest()->first().isClockDoubtful);
    }

    void numbersVersionsOnward()
    {
        QCOMPARE(save(recipe("Rusk", 310)).version, 1);
        QCOMPARE(save(recipe("Rusk", 315, 2)).version, 2);
        QCOMPARE(save(recipe("Rusk", 320, 2)).version, 3); // 2 is another program
        QCOMPARE(save(recipe("rusk", 330, 9)).version, 9); // case-insensitive
        QCOMPARE(names(), QStringList{QStringLiteral("rusk v9")});
        const auto versions = library().versions(save(recipe("Rusk", 340)).recipeId);
        QVERIFY(versions);
        QList<std::pair<int, double>> all;
        for (const RecipeVersion& each : *versions)
            all << std::pair(each.version, each.recipe.cutter().bagLengthMm);
        const QList<std::pair<int, double>> expected{{10, 340}, {9, 330}, {3, 320}, {2, 315}, {1, 310}};
        QCOMPARE(all, expected);
    }

    void takesTheSameProgramForNoNewVersion()
    {
        save(recipe("Rusk", 310), 1000);
        program::Recipe same = recipe("Rusk", 310);
        same.machine.knifeRadiusMm = 75; // the machine does not belong to the recipe
        const RecipeVersion saved = save(same, 2000);
        QCOMPARE(saved.version, 1);
        QCOMPARE(saved.savedMs, 1000);
        // A number that the controller already has is kept, however.
        QCOMPARE(save(recipe("Rusk", 310, 5)).version, 5);
    }

    // The last number that a version can have: another program is refused, the recipe stays as it is.
    void theLastVersionIsTheLast()
    {
        save(recipe("Rusk", 310, program::maxVersion));
        QCOMPARE(save(recipe("Rusk", 310, program::maxVersion)).version, program::maxVersion); // the same
        for (const int version : {1, program::maxVersion}) {
            const auto refused = library().save(recipe("Rusk", 320, version), {}, 2000);
            QVERIFY(!refused);
            QCOMPARE(refused.error().kind, StoreError::Kind::LastVersion);
            QVERIFY(StoreErrorText::describe(refused.error()).contains(QStringLiteral("Rusk")));
            QCOMPARE(names(), QStringList{QStringLiteral("Rusk v65535")});
        }
        QCOMPARE(save(recipe("Rusk 2", 320)).version, 1);
    }

    void damagedVersionsHideNoRecipe_data()
    {
        QTest::addColumn<QString>("damage");
        QTest::newRow("no JSON") << QStringLiteral(
            "UPDATE recipe_version SET json = x'7b' WHERE version = 3");
        QTest::newRow("a number that is none") << QStringLiteral(
            "UPDATE recipe_version SET json = replace(json, '\"version\": 3', '\"version\": "
            "65536') WHERE version = 3");
        QTest::newRow("another program") << QStringLiteral(
            "UPDATE recipe_version SET json = replace(json, 'rotary', 'other') WHERE version = 3");
    }

    void damagedVersionsHideNoRecipe()
    {
        QFETCH(QString, damage);
        save(recipe("Cake", 200), 1500);
        for (int version = 1; version <= 3; ++version)
            save(recipe("Rusk", 300 + version, version), version * 1000);
        const auto done = m_database->execute(damage);
        QVERIFY(done && done->numRowsAffected() == 1);
        QCOMPARE(names(), QStringList({QStringLiteral("Rusk v2"), QStringLiteral("Cake v1")}));
        QCOMPARE(library().newest()->first().unreadableVersion, 3);
        QCOMPARE(library().newest()->last().unreadableVersion, 0);
        QCOMPARE(*library().unreadable(), QStringList());
        QVERIFY(m_database->execute(
            QStringLiteral("UPDATE recipe_version SET json = '' WHERE version < 3 AND saved_ms <> 1500")));
        QCOMPARE(*library().unreadable(), QStringList{QStringLiteral("Rusk")});
        QCOMPARE(names(), QStringList{QStringLiteral("Cake v1")});
        QCOMPARE(save(recipe("Rusk", 350, 3)).version, 4); // the number of the damaged one is taken
        QCOMPARE(library().newest()->first().unreadableVersion, 0);
    }

    void renamesDeletesAndBringsBack()
    {
        const qint64 rusk = save(recipe("Rusk", 310), 1000).recipeId;
        const qint64 wafer = save(recipe("Wafer", 90), 2000).recipeId;
        QVERIFY(library().rename(rusk, QStringLiteral("Rusk large")));
        QCOMPARE(names(), QStringList({QStringLiteral("Wafer v1"), QStringLiteral("Rusk large v1")}));
        const auto taken = library().rename(rusk, QStringLiteral("WAFER"));
        QVERIFY(!taken);
        QCOMPARE(taken.error().kind, StoreError::Kind::Refused);
        QVERIFY(library().setDeleted(wafer, true));
        QCOMPARE(names(), QStringList{QStringLiteral("Rusk large v1")});
        QCOMPARE(save(recipe("Wafer", 95, 2), 3000).recipeId, wafer);
        QCOMPARE(names(), QStringList({QStringLiteral("Wafer v2"), QStringLiteral("Rusk large v1")}));
    }

    void ordersNamesByTheirLastDownload()
    {
        const auto note = [this](const QString& what, const QString& name, const QString& after = {},
                                 const QString& outcome = QStringLiteral("done")) {
            const auto added =
                appendAudit(*m_database, {.what = what, .object = name, .after = after, .outcome = outcome});
            QVERIFY(added);
        };
        const QString download = QStringLiteral("program.download");
        note(download, QStringLiteral("Rusk"));
        note(download, QStringLiteral("Wafer"));
        note(download, QStringLiteral("Pouch"), {}, QStringLiteral("failed"));
        note(download, QStringLiteral("RUSK"));
        note(QStringLiteral("recipe.rename"), QStringLiteral("Wafer"), QStringLiteral("Wafer 60"));
        note(QStringLiteral("parameter.write"), QStringLiteral("Rusk"));
        const auto found = library().downloads();
        QVERIFY(found);
        QCOMPARE(*found, (QHash<QString, qint64>{{nameKey(QStringLiteral("Rusk")), 4},
                                                 {nameKey(QStringLiteral("wafer 60")), 2}}));
    }

    void keepsOneMachineForEachKind()
    {
        program::Recipe cutter = recipe("Rusk", 310);
        cutter.machine.knifeRadiusMm = 70;
        const auto first = library().saveMachine(cutter, {}, 1);
        QVERIFY2(first, first ? "" : qPrintable(StoreErrorText::describe(first.error())));
        cutter.machine.knifeRadiusMm = 75;
        QVERIFY(library().saveMachine(cutter, {}, 2));
        QVERIFY(library().saveMachine(program::defaultRecipe(profile::ProgramKind::Press), {}, 3));
        const auto machines = library().machines();
        QVERIFY(machines);
        QCOMPARE(machines->size(), 2);
        double radiusMm = 0;
        for (const MachineData& each : *machines) {
            if (each.recipe.isCutter())
                radiusMm = each.recipe.machine.knifeRadiusMm;
        }
        QCOMPARE(radiusMm, 75.0);
    }
};

CAMPANEL_TEST(TestRecipeLibrary)

} // namespace campanel::store::test_recipe_library

#include "test_recipe_library.moc"
