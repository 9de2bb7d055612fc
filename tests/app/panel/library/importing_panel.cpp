// SPDX-License-Identifier: Apache-2.0
// A panel for test_killed_imports: importing_panel FOLDER. The plant offers the next version of a signed
// recipe again and again, and it is imported; "offered 5" and "imported 5" are printed. It is killed at any
// moment.
#include "app/panel/access/access.h"
#include "app/panel/audit/audit_trail.h"
#include "app/panel/library/recipes.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTest>

#include <cstdio>

namespace importing_panel {

using namespace campanel;

static int importingPanel(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const QDir folder(QCoreApplication::arguments().at(1));
    test::PanelRig rig;
    panel::Editor editor(rig.machine, test::withStoredRecipe(folder.path()), nullptr);
    panel::DatabaseService records(folder.path(), nullptr);
    panel::Access access(records, rig.machine, rig.settings, nullptr);
    panel::AuditTrail trail(records, {rig.machine, editor, rig.settings, rig.maintenance, access}, nullptr);
    panel::Recipes recipes(rig.machine, editor, records, folder.path(), nullptr);
    QObject::connect(&recipes, &panel::Recipes::noted, &trail, &panel::AuditTrail::note);
    int version = 0; // the newest confirmed one
    QObject::connect(&trail, &panel::AuditTrail::appended, &trail, [&version](const store::AuditRow& row) {
        static const QLatin1StringView start("version ");
        if (row.entry.object == u"Biscuit 250" && row.entry.readBack.startsWith(start))
            version = row.entry.readBack.mid(start.size()).section(u',', 0, 0).toInt();
    });
    records.open();
    if (!QTest::qWaitFor([&] { return recipes.ready() && recipes.total() == 1; }))
        return EXIT_FAILURE;

    const auto key = store::newSigningKey(QStringLiteral("Plant"));
    QFile keyFile(folder.filePath(QStringLiteral("keys/plant.json")));
    if (!key || !folder.mkpath(QStringLiteral("keys")) || !keyFile.open(QIODevice::WriteOnly) ||
        keyFile.write(store::publicKeyFile(*key)) < 0 || !keyFile.flush())
        return EXIT_FAILURE;
    recipes.files()->setKeyFolder(folder.filePath(QStringLiteral("keys")));

    for (int next = recipes.list()->rows().first().version + 1;; ++next) {
        program::Recipe recipe = editor.storedRecipe();
        recipe.version = next;
        recipe.cutter().bagLengthMm = 249 + next % 16; // version 1, the example, has 250
        const QByteArray offer = store::signRecipe(recipe, 1'790'000'000'000, 1, *key);
        recipes.files()->takeOffer({QStringLiteral("Biscuit"), offer});
        const auto* files = recipes.files()->files();
        const auto isOffered = [&] {
            const panel::OfferRow row = files->rows().value(0);
            return row.usable && row.detail.contains(QStringLiteral("version %1 ").arg(next));
        };
        if (!QTest::qWaitFor(isOffered)) {
            const panel::OfferRow row = files->rows().value(0);
            qWarning("not offered: %s %s", qPrintable(row.note), qPrintable(row.detail));
            return EXIT_FAILURE;
        }
        std::printf("offered %d\n", next);
        std::fflush(stdout);
        recipes.files()->take(0);
        if (!QTest::qWaitFor([&] { return version == next; }))
            return EXIT_FAILURE;
        std::printf("imported %d\n", next);
        std::fflush(stdout);
    }
}

CAMPANEL_PROCESS("importing_panel", importingPanel)

} // namespace importing_panel
