// SPDX-License-Identifier: Apache-2.0
// campanel-gateway: publishes the values of one panel on the plant's network, by MQTT Sparkplug B. It carries
// nothing the other way but refused commands, for the audit trail, and offers, for a person.
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
// The commands that the panel hears of in this time, for its audit trail.
constexpr int maxCommandsInTick = 10;
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

// Panel, node and broker together.
class Gateway {
public:
    Gateway(const gateway::GatewaySettings& settings, const Arguments& arguments)
        : m_settings(settings)
        , m_instance(QUuid::createUuid().toString(QUuid::Id128))
        , m_line(settings, u"campanel-%1-%2"_s.arg(settings.node, m_instance.left(8)),
                 arguments.stateFolder + u"/bdseq"_s)
        , m_panel(arguments.panelSocket)
        , m_node({settings.group, settings.node, settings.primaryHost, m_instance}, m_line,
                 {.wallMs = &QDateTime::currentMSecsSinceEpoch},
                 {[this](const plant::CommandMessage& command) { noteCommand(command); },
                  [this] { m_panel.renew(); },
                  [this](LogKind kind, const QString& sentence) { m_log.report(kind, sentence); }})
        , m_recipes(OfferInbox::Kind::Recipe, OfferInbox::recipeTopic(settings.group), m_line, inboxEvents(),
                    keyFolderOf(arguments))
        , m_orders(OfferInbox::Kind::Order, OfferInbox::orderTopic(settings.group, settings.node), m_line,
                   inboxEvents(), keyFolderOf(arguments))
    {
        connectPanel();
        connectBroker();
        QObject::connect(&m_ticks, &QTimer::timeout, &m_context, [this] { tick(); });
    }

    // Runs until a signal.
    int run()
    {
        m_ticks.start(tickPeriod);
        m_line.start([this](int bdSeq) { return m_node.deathFor(bdSeq); });
        m_panel.start();
        const int code = QCoreApplication::exec();
        m_node.end();
        m_log.flush();
        if (!m_line.stop(stopLimitMs))
            std::_Exit(code); // an attempt to connect cannot be ended
        return code;
    }

private:
    using LogKind = gateway::LogKind;
    using OfferInbox = gateway::OfferInbox;

    [[nodiscard]] static QString keyFolderOf(const Arguments& arguments)
    {
        return QFileInfo(arguments.configuration).absoluteDir().filePath(u"recipe-keys"_s);
    }
    [[nodiscard]] gateway::InboxEvents inboxEvents()
    {
        return {[this](const plant::OfferMessage& offer) { return m_panel.send(offer); },
                [this](LogKind kind, const QString& sentence) { m_log.report(kind, sentence); }};
    }
    void noteCommand(const plant::CommandMessage& command)
    {
        m_log.report(LogKind::Command, u"Refused: %1 = %2."_s.arg(store::oneLine(command.metric),
                                                                  store::oneLine(command.value)));
        if (m_commandsInTick++ < maxCommandsInTick)
            m_panel.send(command);
    }
    void connectPanel()
    {
        QObject::connect(&m_panel, &gateway::PanelLine::received, &m_context,
                         [this](const plant::ValueMessage& message) { m_node.takeValues(message); });
        QObject::connect(&m_panel, &gateway::PanelLine::connected, &m_context, [this] {
            m_panel.send(plant::GatewayMessage{QCoreApplication::applicationVersion()});
            for (OfferInbox* inbox : {&m_recipes, &m_orders})
                inbox->panelConnected();
        });
        QObject::connect(&m_panel, &gateway::PanelLine::lost, &m_context, [this] { m_node.panelLost(); });
        QObject::connect(&m_panel, &gateway::PanelLine::reported, &m_context,
                         [this](const QString& sentence) { m_log.report(LogKind::Panel, sentence); });
    }
    void connectBroker()
    {
        QObject::connect(&m_line, &gateway::MqttLine::opened, &m_context, [this](int bdSeq) {
            m_log.report(LogKind::Connected,
                         u"Connected to %1:%2."_s.arg(m_settings.host, QString::number(m_settings.port)));
            m_node.brokerOpened(bdSeq);
            for (OfferInbox* inbox : {&m_recipes, &m_orders})
                inbox->brokerOpened();
        });
        QObject::connect(&m_line, &gateway::MqttLine::closed, &m_context, [this](const QString& reason) {
            if (reason != m_lastReason || m_node.isBorn())
                m_log.report(LogKind::NotConnected, reason);
            m_lastReason = reason;
            m_node.brokerClosed();
        });
        QObject::connect(&m_line, &gateway::MqttLine::received, &m_context,
                         [this](const QString& topic, const QByteArray& bytes) {
                             if (!m_recipes.take(topic, bytes) && !m_orders.take(topic, bytes))
                                 m_node.takeMessage(topic, bytes);
                         });
        QObject::connect(&m_line, &gateway::MqttLine::barrierPassed, &m_context,
                         [this] { m_node.barrierPassed(); });
        QObject::connect(&m_line, &gateway::MqttLine::leftOut, &m_context, [this](qint64 messages) {
            m_leftOut += messages;
            m_log.report(LogKind::LeftOut,
                         u"%1 messages of the broker came too fast since the start and are left out."_s.arg(
                             m_leftOut));
        });
    }
    void tick()
    {
        m_commandsInTick = 0;
        m_node.tick();
        for (OfferInbox* inbox : {&m_recipes, &m_orders})
            inbox->tick();
        m_log.tick();
    }

    const gateway::GatewaySettings m_settings;
    const QString m_instance; // a random text
    gateway::LogLimit m_log{&report};
    gateway::MqttLine m_line;
    gateway::PanelLine m_panel;
    gateway::SparkplugNode m_node;
    OfferInbox m_recipes;
    OfferInbox m_orders;
    QTimer m_ticks;
    QString m_lastReason;
    qint64 m_leftOut = 0;
    int m_commandsInTick = 0;
    QObject m_context; // the last member: what it connects is gone before the others
};

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
    const shell::TerminationSignals terminationSignals;
    return Gateway(read.settings, arguments).run();
}
