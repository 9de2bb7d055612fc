// SPDX-License-Identifier: Apache-2.0
// A panel for test_stops_killed: stopping_panel FOLDER STEADY_S WALL_MS. Its machine stands, with a reason,
// while seconds pass quickly; it prints the wall clock when a write has ended. It is killed at any moment.
#include "tests/app/panel/stops/stop_rig.h"
#include "tests/support/test_program.h"

#include <QCoreApplication>

#include <cstdio>

namespace stopping_panel {

using namespace campanel;

static int stoppingPanel(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    test::StopRig rig(arguments.at(1));
    rig.panel.now = link::SteadyTime{std::chrono::seconds(arguments.at(2).toLongLong())};
    rig.wallMs = arguments.at(3).toLongLong();
    rig.panel.connectIdle();
    rig.panel.link.activate(rig.panel.image(), rig.panel.now);
    rig.panel.link.sendStatus(rig.panel.now); // nothing stands before the first program
    if (rig.stops->book().presentStop().reason.isEmpty())
        rig.stops->answer(rig.stops->book().presentStop().id, {QStringLiteral("cleaning"), {}, false});
    rig.settle();
    std::puts("begun");
    std::fflush(stdout);
    while (true) {
        const qint64 before = rig.wallMs;
        rig.pass(61); // writes at least once
        rig.settle();
        std::printf("%lld\n", static_cast<long long>(before));
        std::fflush(stdout);
    }
}

CAMPANEL_PROCESS("stopping_panel", stoppingPanel)

} // namespace stopping_panel
