// SPDX-License-Identifier: Apache-2.0
// campanel-gateway: publishes the values of one panel on the plant's network, by MQTT Sparkplug B. It carries
// nothing the other way but refused commands, for the audit trail, and offered recipes, for a person.
#include "app/plant/socket_path.h"
#include "app/shell/termination_signals.h"
#include "app/store/files/files.h"
#include "gateway/gateway_settings.h"
#include "gateway/log_limit.h"
#include "gateway/mqtt_line.h"
#include "gateway/offer_inbox.h"
#include "gateway/panel_line.h"
#include "gateway/sparkplug_node.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSysInfo>
#include <QTimer>
#include <QUuid>

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace campanel;
using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

constexpr int configurationError = 2;
constexpr auto tickPeriod = 100ms;
// The time for the last messages at the end.
constexpr int stopLimitMs = 2000;

// Writes one line, whatever is in the sentence.
void report(const QString& sentence)
{
    std::fprintf(stderr, "campanel-gateway: %s\n",
                 qPrintable(store::oneLine(sentence, store::maxLineLength)));
}

struct Arguments {
    QString configuration;
    QString panelSocket;
    QString stateFolder;
};

Arguments argumentsOf(const QCoreApplication& application)
{
    const QString service = qEnvironmentVariable("STATE_DIRECTORY");
    QCommandLineParser parser;
    parser.setApplicationDescription(
        u"Publishes the values of a CamPanel machine by MQTT Sparkplug B. It takes no command from the network."_s);
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOptions({
        {u"config"_s, u"Configuration file, section [gateway] (%1)."_s.arg(shell::configurationFile()),
         u"file"_s, shell::configurationFile()},
        {u"panel"_s, u"Local socket of the panel (campanel-gateway.socket in its runtime folder)."_s,
         u"path"_s, plant::panelSocketPath()},
        {u"state"_s, u"Folder for the number of the last connection."_s, u"folder"_s,
         service.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) : service},
    });
    parser.process(application);
    return {parser.value(u"config"_s), parser.value(u"panel"_s), parser.value(u"state"_s)};
}

// Puts panel, node and broker together, and runs until a signal.
int run(const gateway::GatewaySettings& settings, const Arguments& arguments)
{
    using gateway::LogKind;
    const shell::TerminationSignals terminationSignals;
    gateway::LogLimit log(&report);
    const auto note = [&log](LogKind kind, const QString& sentence) { log.report(kind, sentence); };
    const QString instance = QUuid::createUuid().toString(QUuid::Id128);
    constexpr qsizetype digits = 8;
    gateway::MqttLine line(settings, u"campanel-%1-%2"_s.arg(settings.node, instance.left(digits)),
                           arguments.stateFolder + u"/bdseq"_s);
    gateway::PanelLine panel(arguments.panelSocket);
    gateway::SparkplugNode node(
        {settings.group, settings.node, settings.primaryHost, instance}, line,
        {.wallMs = &QDateTime::currentMSecsSinceEpoch},
        {[&](const plant::CommandMessage& command) {
             note(LogKind::Command,
                  u"Refused: %1 = %2."_s.arg(store::oneLine(command.metric), store::oneLine(command.value)));
             panel.send(command);
         },
         [&panel] { panel.renew(); }, note});
    gateway::OfferInbox inbox(
        settings.group, line,
        {[&panel](const plant::OfferMessage& offer) { return panel.send(offer); }, note},
        QFileInfo(arguments.configuration).absoluteDir().filePath(u"recipe-keys"_s));
    QObject context;
    QObject::connect(&panel, &gateway::PanelLine::received, &context,
                     [&node](const plant::ValueMessage& message) { node.takeValues(message); });
    QObject::connect(&panel, &gateway::PanelLine::connected, &context, [&] {
        panel.send(plant::GatewayMessage{QCoreApplication::applicationVersion()});
        inbox.panelConnected();
    });
    QObject::connect(&panel, &gateway::PanelLine::lost, &context, [&node] { node.panelLost(); });
    QObject::connect(&panel, &gateway::PanelLine::reported, &context,
                     [&](const QString& sentence) { note(LogKind::Panel, sentence); });
    QObject::connect(&line, &gateway::MqttLine::opened, &context, [&](int bdSeq) {
        note(LogKind::Connected, u"Connected to %1:%2."_s.arg(settings.host).arg(settings.port));
        node.brokerOpened(bdSeq);
        inbox.brokerOpened();
    });
    QString lastReason;
    qint64 leftOut = 0;
    QObject::connect(&line, &gateway::MqttLine::closed, &context, [&](const QString& reason) {
        if (reason != lastReason || node.isBorn())
            note(LogKind::NotConnected, reason);
        lastReason = reason;
        node.brokerClosed();
    });
    QObject::connect(&line, &gateway::MqttLine::received, &context,
                     [&](const QString& topic, const QByteArray& bytes) {
                         if (!inbox.take(topic, bytes))
                             node.takeMessage(topic, bytes);
                     });
    QObject::connect(&line, &gateway::MqttLine::barrierPassed, &context, [&node] { node.barrierPassed(); });
    QObject::connect(&line, &gateway::MqttLine::leftOut, &context, [&](qint64 messages) {
        leftOut += messages;
        note(LogKind::LeftOut,
             u"%1 messages of the broker came too fast since the start and are left out."_s.arg(leftOut));
    });
    QTimer ticks;
    QObject::connect(&ticks, &QTimer::timeout, &context, [&] {
        node.tick();
        inbox.tick();
        log.tick();
    });
    ticks.start(tickPeriod);
    line.start([&node](int bdSeq) { return node.deathFor(bdSeq); });
    panel.start();
    const int code = QCoreApplication::exec();
    node.end();
    log.flush();
    if (!line.stop(stopLimitMs))
        std::_Exit(code); // an attempt to connect cannot be ended
    return code;
}

} // namespace

int main(int argc, char* argv[])
{
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(u"campanel-gateway"_s);
    QCoreApplication::setOrganizationName(u"campanel"_s);
    QCoreApplication::setApplicationVersion(QStringLiteral(CAMPANEL_VERSION));
    const Arguments arguments = argumentsOf(application);
    const gateway::ReadGatewaySettings read = gateway::gatewaySettings(
        shell::readConfiguration(arguments.configuration), QSysInfo::machineHostName());
    for (const QString& sentence : read.warnings + read.errors)
        report(sentence);
    if (!read.errors.isEmpty())
        return configurationError;
    if (read.settings.host.isEmpty()) {
        report(u"[gateway] in %1 names no broker: nothing is published."_s.arg(arguments.configuration));
        return EXIT_SUCCESS;
    }
    return run(read.settings, arguments);
}
