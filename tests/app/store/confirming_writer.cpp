// SPDX-License-Identifier: Apache-2.0
// Writes recipes, audit rows, alarms, stops, copies and the working copy endlessly, and prints each confirmed
// one; it is killed at any moment.
#include "app/store/logs/alarm_log.h"
#include "app/store/logs/audit_log.h"
#include "app/store/logs/stop_log.h"
#include "app/store/recipes/recipe_file.h"
#include "app/store/recipes/recipe_library.h"
#include "tests/support/test_program.h"

#include <QCoreApplication>
#include <QDir>

#include <cstdio>

namespace confirming_writer {

using namespace campanel;

namespace {

void confirm(const char* what, qint64 number)
{
    std::printf("%s %lld\n", what, static_cast<long long>(number));
    std::fflush(stdout);
}

} // namespace

static int confirmingWriter(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const QString folder = QCoreApplication::arguments().value(1);
    auto opened = store::Database::open(folder);
    if (!opened)
        return EXIT_FAILURE;
    store::Database& database = **opened;
    const auto start = store::AlarmLog::begin(database);
    if (!start)
        return EXIT_FAILURE;
    qint64 alarm = start->lastId;
    const auto stops = store::StopLog::begin(database);
    if (!stops)
        return EXIT_FAILURE;
    qint64 lastInterval = stops->last ? stops->last->id : 0;
    for (int round = 0;; ++round) {
        program::Recipe recipe;
        recipe.name = "Killed";
        recipe.cutter().bagLengthMm = 200 + round % 97;
        const auto saved = store::RecipeLibrary(database).save(recipe, QStringLiteral("writer"), round);
        if (!saved)
            return EXIT_FAILURE;
        confirm("recipe", saved->version);
        const auto row = store::appendAudit(database, {round,
                                                       QStringLiteral("writer"),
                                                       3,
                                                       QStringLiteral("recipe.save"),
                                                       QStringLiteral("Killed"),
                                                       {},
                                                       {},
                                                       {},
                                                       QStringLiteral("done")});
        if (!row)
            return EXIT_FAILURE;
        confirm("audit", row->sequence);
        store::AlarmRow raised;
        raised.id = ++alarm;
        raised.code = QStringLiteral("C-01");
        raised.raisedMs = round;
        if (!store::AlarmLog::write(database, {{raised}, {}, {}}))
            return EXIT_FAILURE;
        confirm("alarm", alarm);
        store::StateInterval interval;
        interval.id = ++lastInterval;
        interval.stop = interval.id;
        interval.beginMs = round;
        interval.durationMs = 1;
        store::StopRow stop;
        stop.id = interval.id;
        stop.reason = QStringLiteral("cleaning");
        if (!store::StopLog::write(database, {{interval}, {stop}}))
            return EXIT_FAILURE;
        confirm("interval", interval.id);
        recipe.version = saved->version;
        if (!store::writeRecipe(recipe, QDir(folder).filePath(QStringLiteral("working_copy.json"))))
            return EXIT_FAILURE;
        confirm("file", saved->version);
        if (round % 16 == 5) {
            if (!database.makeCopy())
                return EXIT_FAILURE;
            confirm("copy", round);
        }
    }
}

CAMPANEL_PROCESS("confirming_writer", confirmingWriter)

} // namespace confirming_writer
