// SPDX-License-Identifier: Apache-2.0
// The panel's own classes without its window: changes the bag length and downloads endlessly, and prints the
// confirmed programs; it is killed at any moment. Arguments: folder, port.
#include "app/link/threaded_link.h"
#include "app/panel/access/access.h"
#include "app/panel/audit/audit_trail.h"
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/library/recipes.h"
#include "app/panel/maintenance/maintenance.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"
#include "tests/e2e/confirmed_facts.h"
#include "tests/support/stored_recipe.h"
#include "tests/support/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QTimer>

namespace downloading_panel {

using namespace campanel;
using panel::Editor;

namespace {

constexpr std::chrono::milliseconds rest{20};
constexpr double shortestMm = 200;
constexpr double longestMm = 230;
constexpr double rateBagsPerMin = 180;

} // namespace

static int downloadingPanel(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const QString folder = QCoreApplication::arguments().value(1);
    link::ThreadedLink link(nullptr);
    panel::Settings settings(QDir(folder).filePath(QStringLiteral("settings.ini")), nullptr);
    panel::Controller machine(link, settings, nullptr);
    Editor editor(machine, test::withStoredRecipe(folder), nullptr);
    panel::DatabaseService records(folder, nullptr);
    panel::Recipes recipes(machine, editor, records, folder, nullptr);
    panel::Maintenance maintenance(machine, settings, folder, nullptr);
    panel::Access access(records, machine, settings, nullptr);
    panel::AuditTrail trail(records, {machine, editor, settings, maintenance, access}, nullptr);

    QObject::connect(&recipes, &panel::Recipes::noted, &trail, &panel::AuditTrail::note);
    test::sayConfirmed(recipes, trail, editor);
    bool isUnderWay = false;
    QObject::connect(&editor, &Editor::downloadEnded, [&] { isUnderWay = false; });
    QObject::connect(&editor, &Editor::downloadBegun, [&] { isUnderWay = true; });
    QTimer next;
    next.callOnTimeout(&application, [&] {
        if (!machine.isConnected() || isUnderWay)
            return;
        const double lengthMm = editor.bagLength()->value();
        editor.bagLength()->set(lengthMm < shortestMm || lengthMm >= longestMm ? shortestMm : lengthMm + 1);
        editor.rate()->set(rateBagsPerMin);
        editor.download();
    });
    next.start(rest);
    QObject::connect(&machine, &panel::Controller::commandsChanged, &application, [&] {
        if (machine.canStart())
            machine.start();
    });

    link::ConnectionSettings wanted;
    wanted.simulated = false;
    wanted.port = QCoreApplication::arguments().value(2);
    records.open();
    access.open();
    trail.open();
    link.connectTo(wanted);
    return QCoreApplication::exec();
}

CAMPANEL_PROCESS("downloading_panel", downloadingPanel)

} // namespace downloading_panel
