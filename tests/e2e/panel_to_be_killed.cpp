// SPDX-License-Identifier: Apache-2.0
// A panel for test_after_a_crash: panel_to_be_killed FOLDER PORT [KEY]... Stores everything in the folder,
// taps the keys once the machine is connected, holds the one named "hold:KEY", and prints "page N state S" at
// every change, with " try N" while an output is tried. SIGTERM ends it properly.
#include "app/link/threaded_link.h"
#include "app/shell/fonts.h"
#include "app/shell/termination_signals.h"
#include "tests/looks/touch_driver.h"
#include "tests/support/test_program.h"

#include <QGuiApplication>
#include <QTimer>

#include <cstdio>

namespace panel_to_be_killed {

using namespace campanel;

static int panelToBeKilled(int argc, char** argv)
{
    QGuiApplication application(argc, argv);
    QGuiApplication::setQuitOnLastWindowClosed(false);
    const QStringList arguments = QGuiApplication::arguments();
    const QString& folder = arguments.at(1);
    shell::applyFonts();
    link::ThreadedLink link(nullptr);
    shell::Panel panel(link, {folder + QStringLiteral("/settings.ini"), folder});
    panel::ConnectionChoice choice;
    choice.simulated = false;
    choice.portName = arguments.at(2);
    panel.settings().overrideConnection(choice);
    if (!panel.load({1024, 600}))
        return 1;
    panel.window().show();
    looks::TouchDriver touch(panel);
    touch.settle();
    panel.open();

    QStringList keys = arguments.mid(3);
    QByteArray told;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &panel, [&] {
        while (!keys.isEmpty() &&
               panel.controller().connection() == panel::Controller::Connection::Connected) {
            QString key = keys.takeFirst();
            if (key.startsWith(u"hold:"))
                touch.touch(key.remove(QStringLiteral("hold:")));
            else
                touch.tap(key);
        }
        QByteArray now = "page " + panel.window().property("page").toString().toLatin1() + " state " +
                         QByteArray::number(static_cast<int>(panel.controller().state()));
        if (const int held = panel.maintenance().outputTry()->held(); held >= 0)
            now += " try " + QByteArray::number(held);
        now += '\n';
        if (now == told)
            return;
        told = now;
        std::fputs(now.constData(), stdout);
        std::fflush(stdout);
    });
    timer.start(50);
    const shell::TerminationSignals terminationSignals;
    return QGuiApplication::exec();
}

CAMPANEL_PROCESS("panel_to_be_killed", panelToBeKilled)

} // namespace panel_to_be_killed
