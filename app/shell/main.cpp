// SPDX-License-Identifier: Apache-2.0
// The panel's executable: reads the options and creates the parts.
#include "app/link/threaded_link.h"
#include "app/shell/card.h"
#include "app/shell/clock_state.h"
#include "app/shell/configuration.h"
#include "app/shell/data_disk.h"
#include "app/shell/folder_wait.h"
#include "app/shell/fonts.h"
#include "app/shell/kiosk.h"
#include "app/shell/memory.h"
#include "app/shell/options.h"
#include "app/shell/panel.h"
#include "app/shell/qml_modules.h"
#include "app/shell/renderer.h"
#include "app/shell/self_test.h"
#include "app/shell/service_watchdog.h"
#include "app/shell/termination_signals.h"

#include <QFile>
#include <QGuiApplication>
#include <QLoggingCategory>
#include <QStandardPaths>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <span>
#include <string>
#include <string_view>

namespace {

using namespace campanel;

using Arguments = std::span<char*>;

// Returns true for an option that is needed before the application exists.
bool isGiven(Arguments arguments, std::string_view option)
{
    return std::find(arguments.begin() + 1, arguments.end(), option) != arguments.end();
}

QString valueOf(Arguments arguments, const std::string& option)
{
    for (std::size_t i = 1; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        if (argument == option && i + 1 < arguments.size())
            return QFile::decodeName(arguments[i + 1]);
        if (argument.starts_with(option + '='))
            return QFile::decodeName(arguments[i] + option.size() + 1);
    }
    return {};
}

// Returns true for captures and the self-test, which need neither a display nor the machine's configuration.
bool isOffscreen(Arguments arguments)
{
    return std::any_of(arguments.begin() + 1, arguments.end(), [](std::string_view argument) {
        return argument == "--self-test" || argument == "--help" || argument == "-h" ||
               argument == "--version" || argument == "-v";
    });
}

// Returns the folder beside the configuration file with the public keys of those who sign recipes.
QString keyFolderOf(Arguments arguments)
{
    const QString named = valueOf(arguments, "--config");
    const QFileInfo file(named.isEmpty() ? shell::configurationFile() : named);
    return file.absoluteDir().filePath(QStringLiteral("recipe-keys"));
}

shell::ReadConfiguration configurationOf(Arguments arguments)
{
    const QString named = valueOf(arguments, "--config");
    shell::ReadConfiguration read =
        shell::readConfiguration(named.isEmpty() ? shell::configurationFile() : named);
    for (const QString& complaint : read.complaints)
        std::fprintf(stderr, "campanel: %s\n", qPrintable(complaint));
    if (!named.isEmpty() && !QFile::exists(named))
        std::fprintf(stderr, "campanel: %s: there is no such file.\n", qPrintable(named));
    QLoggingCategory::setFilterRules(read.values.text("log.rules"));
    return read;
}

constexpr std::chrono::seconds screenAwaited{30};

// Returns false without a screen. A platform set by an environment variable stays.
bool prepareScreen(const QString& wanted)
{
    if (!qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        return true;
    const shell::ScreenPlaces places;
    const shell::ScreenChoice choice =
        shell::waitForScreen(shell::screenAccess(wanted), places, screenAwaited);
    std::fprintf(stderr, "campanel: %s\n", qPrintable(choice.reason));
    if (choice.platform.isEmpty())
        return false;
    qputenv("QT_QPA_PLATFORM", choice.platform.toLatin1());
    if (qEnvironmentVariableIsEmpty("QT_QPA_EGLFS_INTEGRATION"))
        qputenv("QT_QPA_EGLFS_INTEGRATION", "eglfs_kms");
    shell::noteScreenTried(choice.platform, places);
    return true;
}

// Reports missing packages.
bool hasFonts()
{
    const QStringList missing = shell::missingFonts();
    for (const QString& sentence : missing)
        std::fprintf(stderr, "campanel: %s\n", qPrintable(sentence));
    return missing.isEmpty();
}

// The exit code of the event loop to rebuild the panel from the data on the disk.
constexpr int restartCode = 1000;

// Where the boot of the image leaves what the machine builder put on the card.
const QString builderFolder = QStringLiteral("/var/lib/campanel/made-ready");

int runPanel(const shell::Options& options, const shell::ReadConfiguration& read, const QString& keyFolder,
             const shell::ServiceManager& manager)
{
    const panel::SettingValues& configuration = read.values;
    link::ThreadedLink link(nullptr);
    const QString diskLost = shell::diskLost();
    shell::Panel panel(link, {{}, {}, configuration, keyFolder, diskLost, builderFolder, read.complaints});
    panel.records().setClockState([] { return shell::clockState(); });
    panel.update().setPlaces(panel::UpdatePlaces::ofService());
    panel.touchCalibration().setPlaces(panel::TouchPlaces::ofService());
    if (options.connection)
        panel.settings().overrideConnection(*options.connection);
    panel.settings().setSimulatorArguments(options.simulatorArguments);
    if (!options.language.isEmpty())
        panel.settings().overrideValue("display.language", options.language);
    if (!options.theme.isEmpty())
        panel.settings().overrideValue("display.theme", options.theme);
    if (!panel.load(options.size.value_or(panel::sizeIn(configuration.text("display.size")))))
        return EXIT_FAILURE;
    const shell::ServiceWatchdog watchdog(manager, link, panel.window());
    if (diskLost.isEmpty()) // else the panel was set up, and the machine's configuration applies
        panel.settings().offerFirstStart(panel.wasSetUp());
    panel.open();
    if (options.isFullScreen || options.isKiosk || configuration.isTrue("display.fullscreen"))
        panel.window().showFullScreen();
    else
        panel.window().show();
    QGuiApplication::setQuitOnLastWindowClosed(true);
    QObject::connect(&panel, &shell::Panel::restartWanted, [] {
        QGuiApplication::setQuitOnLastWindowClosed(false); // the next one is about to open
        QGuiApplication::exit(restartCode);
    });
    QObject::connect(
        &panel.window(), &QQuickWindow::frameSwapped, &panel,
        [&options] {
            if (options.isKiosk)
                shell::noteScreenWorks({});
            if (options.isFirstFrameAnnounced) {
                std::puts("first frame");
                std::fflush(stdout);
            }
        },
        Qt::ConnectionType(Qt::AutoConnection | Qt::SingleShotConnection));
    return QGuiApplication::exec();
}

} // namespace

int main(int argc, char* argv[])
{
    shell::keepMemoryFlat();
    const Arguments arguments(argv, static_cast<std::size_t>(argc));
    if (const QString card = valueOf(arguments, "--check-card"); !card.isEmpty())
        return shell::printCard(card);
    shell::ReadConfiguration configuration;
    if (isOffscreen(arguments))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    else
        configuration = configurationOf(arguments);
    if (!isOffscreen(arguments) && isGiven(arguments, "--kiosk") &&
        !prepareScreen(configuration.values.text("kiosk.screen")))
        return EXIT_FAILURE;
    const shell::ServiceManager manager;
    QGuiApplication application(argc, argv);
    QGuiApplication::setApplicationName(QStringLiteral("campanel"));
    QGuiApplication::setOrganizationName(QStringLiteral("campanel"));
    QGuiApplication::setApplicationVersion(QStringLiteral(CAMPANEL_VERSION));
    const shell::Options options = shell::readOptions(application);

    shell::applyFonts();
    if (options.isSelfTest)
        return hasFonts() ? shell::selfTest() : EXIT_FAILURE;
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    // Reads the fonts while the QML is loading; the panel works without them.
    const std::future<bool> fonts = std::async(std::launch::async, &hasFonts);
    shell::chooseRenderer();
    const auto lock = shell::waitForFolder(folder, options.language.isEmpty()
                                                       ? configuration.values.text("display.language")
                                                       : options.language);
    if (!lock)
        return EXIT_FAILURE;
    const shell::TerminationSignals terminationSignals;
    int code = restartCode;
    while (code == restartCode)
        code = runPanel(options, configuration, keyFolderOf(arguments), manager);
    manager.notify("STOPPING=1");
    return code;
}
