// SPDX-License-Identifier: Apache-2.0
// The command line of the panel; see options.h.
#include "app/shell/options.h"

#include "app/shell/configuration.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QProcess>

#include <cstdio>
#include <cstdlib>

namespace campanel::shell {
namespace {

constexpr int usageError = 2;

[[noreturn]] void refuse(const QString& sentence)
{
    std::fprintf(stderr, "campanel: %s\n", qPrintable(sentence));
    std::exit(usageError);
}

int number(const QCommandLineParser& parser, const QString& option, int lowest, int highest)
{
    bool isNumber = false;
    const int value = parser.value(option).toInt(&isNumber);
    if (!isNumber || value < lowest || value > highest)
        refuse(QStringLiteral("--%1 %2 is not between %3 and %4.")
                   .arg(option, parser.value(option), QString::number(lowest), QString::number(highest)));
    return value;
}

QString valueAmong(const QCommandLineParser& parser, const QString& option, const QStringList& choices)
{
    const QString value = parser.value(option);
    if (parser.isSet(option) && !choices.contains(value))
        refuse(QStringLiteral("--%1 %2 is not one of %3.")
                   .arg(option, value, choices.join(QStringLiteral(", "))));
    return value;
}

QSize sizeFrom(const QString& text)
{
    const QSize size = panel::sizeIn(text);
    constexpr int maxPixels = 9999;
    if (size.isEmpty() || size.width() > maxPixels || size.height() > maxPixels)
        refuse(QStringLiteral("--size %1 is not of the form 1024x600.").arg(text));
    return size;
}

// Refuses line parameters without a port: they would silently have no effect.
void refuseLineParametersWithoutPort(const QCommandLineParser& parser)
{
    for (const char* name : {"baud", "parity", "stop-bits", "unit"}) {
        const QString option = QString::fromLatin1(name);
        if (parser.isSet(option))
            refuse(
                QStringLiteral("--%1 %2 needs a port: add --port /dev/ttyUSB0, or leave --%1 out and set it "
                               "in Settings > Connection.")
                    .arg(option, parser.value(option)));
    }
}

panel::ConnectionChoice connectionFrom(const QCommandLineParser& parser)
{
    panel::ConnectionChoice choice;
    choice.simulated = false;
    choice.portName = parser.value(QStringLiteral("port"));
    choice.baud = valueAmong(parser, QStringLiteral("baud"), panel::choicesOf("connection.baud")).toInt();
    choice.parity = valueAmong(parser, QStringLiteral("parity"), panel::choicesOf("connection.parity"));
    choice.stopBits = number(parser, QStringLiteral("stop-bits"), 1, 2);
    choice.unit = number(parser, QStringLiteral("unit"), 1, 247);
    return choice;
}

} // namespace

Options readOptions(const QCoreApplication& application)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Touchscreen of an electronic-cam machine. Without --port it uses the connection of "
                       "its settings; at first that is the "
                       "simulated controller."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOptions({
        {QStringLiteral("port"), QStringLiteral("Serial port of the controller, for this run."),
         QStringLiteral("path")},
        {QStringLiteral("baud"), QStringLiteral("Baud rate of --port (115200)."), QStringLiteral("rate"),
         QStringLiteral("115200")},
        {QStringLiteral("parity"), QStringLiteral("N, E or O of --port (N)."), QStringLiteral("parity"),
         QStringLiteral("N")},
        {QStringLiteral("stop-bits"), QStringLiteral("1 or 2 of --port (1)."), QStringLiteral("bits"),
         QStringLiteral("1")},
        {QStringLiteral("unit"), QStringLiteral("Modbus unit on --port, 1 to 247 (1)."),
         QStringLiteral("number"), QStringLiteral("1")},
        {QStringLiteral("simulator-arguments"),
         QStringLiteral("Options of the simulated controller, for this run, as in \"--sensor-delay-ms 1\"; "
                        "campanel-controller --help lists them. Without effect on a real one."),
         QStringLiteral("options")},
        {QStringLiteral("language"), QStringLiteral("en or the code of an installed language, for this run."),
         QStringLiteral("language")},
        {QStringLiteral("theme"), QStringLiteral("light, dark or contrast, for this run."),
         QStringLiteral("theme")},
        {QStringLiteral("config"), QStringLiteral("Configuration file (%1).").arg(configurationFile()),
         QStringLiteral("file")},
        {QStringLiteral("check-card"),
         QStringLiteral("Check the files for the card of an image, print a line for each, and end."),
         QStringLiteral("folder")},
        {QStringLiteral("kiosk"),
         QStringLiteral("Without a window system: wait for the screen, then fill it by eglfs or linuxfb.")},
        {QStringLiteral("size"), QStringLiteral("Size of the window (1024x600)."), QStringLiteral("WxH")},
        {QStringLiteral("fullscreen"), QStringLiteral("Fill the screen; touch sizes follow its density.")},
        {QStringLiteral("self-test"),
         QStringLiteral("Compile every page and dialog, open every page, and end.")},
        {QStringLiteral("announce-first-frame"),
         QStringLiteral("Print \"first frame\" when it is on the screen.")},
    });
    parser.process(application);
    if (!parser.positionalArguments().isEmpty())
        refuse(QStringLiteral("\"%1\" is not an option; see --help.")
                   .arg(parser.positionalArguments().constFirst()));

    Options options;
    if (parser.isSet(QStringLiteral("port")))
        options.connection = connectionFrom(parser);
    else
        refuseLineParametersWithoutPort(parser);
    options.simulatorArguments = QProcess::splitCommand(parser.value(QStringLiteral("simulator-arguments")));
    options.language = valueAmong(parser, QStringLiteral("language"),
                                  panel::languageCodes(panel::languagesIn(panel::languageFolders())));
    options.theme = valueAmong(parser, QStringLiteral("theme"), panel::choicesOf("display.theme"));
    if (parser.isSet(QStringLiteral("size")))
        options.size = sizeFrom(parser.value(QStringLiteral("size")));
    options.isKiosk = parser.isSet(QStringLiteral("kiosk"));
    options.isFullScreen = parser.isSet(QStringLiteral("fullscreen"));
    options.isSelfTest = parser.isSet(QStringLiteral("self-test"));
    options.isFirstFrameAnnounced = parser.isSet(QStringLiteral("announce-first-frame"));
    return options;
}

} // namespace campanel::shell
