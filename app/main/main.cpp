// SPDX-License-Identifier: Apache-2.0
// The panel's executable: reads the options and puts the parts together.
#include "app/link/threaded_link.h"
#include "app/main/baselines.h"
#include "app/main/capture.h"
#include "app/main/fonts.h"
#include "app/main/memory.h"
#include "app/main/options.h"
#include "app/main/panel.h"
#include "app/main/qml_modules.h"
#include "app/main/self_test.h"

#include <QGuiApplication>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

namespace {

using namespace campanel;

// Captures and the self-test need no display. The platform is chosen before there is an application to ask.
void chooseOffscreen(std::span<char*> arguments)
{
    const auto needsNoDisplay = [](std::string_view argument) {
        return argument == "--self-test" || argument.starts_with("--capture") || argument == "--help" ||
               argument == "-h" || argument == "--version" || argument == "-v";
    };
    if (std::any_of(arguments.begin() + 1, arguments.end(), needsNoDisplay))
        qputenv("QT_QPA_PLATFORM", "offscreen");
}

// Says which packages are missing.
bool hasFonts()
{
    const QStringList missing = panel::missingFonts();
    for (const QString& sentence : missing)
        std::fprintf(stderr, "campanel: %s\n", qPrintable(sentence));
    return missing.isEmpty();
}

// Out of the event loop, to put the panel together anew from what is on the disk.
constexpr int restartCode = 1000;

int capture(const panel::Options& options)
{
    return options.baselineFolder.isEmpty()
               ? panel::capture(options.captureFolder, options.selection)
               : panel::compareWithBaselines(options.captureFolder, options.baselineFolder,
                                             options.isUpdatingBaselines);
}

int runPanel(const panel::Options& options)
{
    link::ThreadedLink link(nullptr);
    panel::Panel panel(link, {});
    hasFonts(); // reads all fonts while the QML is being loaded; without them the panel still works
    if (options.connection)
        panel.settings().overrideConnection(*options.connection);
    if (!options.language.isEmpty())
        panel.settings().overrideLanguage(options.language);
    if (!options.theme.isEmpty())
        panel.settings().overrideTheme(options.theme);
    if (!panel.load(options.size))
        return EXIT_FAILURE;
    if (options.isFullScreen)
        panel.window().showFullScreen();
    else
        panel.window().show();
    QGuiApplication::setQuitOnLastWindowClosed(true);
    QObject::connect(&panel, &panel::Panel::restartWanted, [] {
        QGuiApplication::setQuitOnLastWindowClosed(false); // the next one is about to open
        QGuiApplication::exit(restartCode);
    });
    QObject::connect(
        &panel.window(), &QQuickWindow::frameSwapped, &panel,
        [&panel, isAnnounced = options.isFirstFrameAnnounced] {
            if (isAnnounced) {
                std::puts("first frame");
                std::fflush(stdout);
            }
            panel.settings().offerFirstStart();
            panel.open();
        },
        Qt::ConnectionType(Qt::AutoConnection | Qt::SingleShotConnection));
    return QGuiApplication::exec();
}

} // namespace

int main(int argc, char* argv[])
{
    panel::keepMemoryFlat();
    chooseOffscreen({argv, static_cast<std::size_t>(argc)});
    QGuiApplication application(argc, argv);
    QGuiApplication::setApplicationName(QStringLiteral("campanel"));
    QGuiApplication::setOrganizationName(QStringLiteral("campanel"));
    QGuiApplication::setApplicationVersion(QStringLiteral(CAMPANEL_VERSION));
    const panel::Options options = panel::readOptions(application);

    panel::applyFonts();
    if (!options.captureFolder.isEmpty())
        return hasFonts() ? capture(options) : EXIT_FAILURE;
    if (options.isSelfTest)
        return hasFonts() ? panel::selfTest(options.selection) : EXIT_FAILURE;
    int code = restartCode;
    while (code == restartCode)
        code = runPanel(options);
    return code;
}
