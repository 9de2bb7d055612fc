// SPDX-License-Identifier: Apache-2.0
#include "tests/gateway/plant_bench.h"

#include "tests/support/places.h"

#include <QFile>
#include <QStandardPaths>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

#include <csignal>
#include <sys/prctl.h>

using namespace Qt::StringLiterals;

namespace campanel::test {

namespace {

constexpr int startLimitMs = 20'000;
const QString loopback = u"127.0.0.1"_s;

// Debian installs the broker outside of a user's path.
QString brokerProgram()
{
    const QString found = QStandardPaths::findExecutable(u"mosquitto"_s);
    return found.isEmpty() ? QStandardPaths::findExecutable(u"mosquitto"_s, {u"/usr/sbin"_s}) : found;
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("%s cannot be written", qPrintable(path));
}

// Starts a program that ends with the test, even when that is killed.
void start(QProcess& process, const QString& program, const QStringList& arguments)
{
    process.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGKILL); });
    process.start(program, arguments);
    if (!process.waitForStarted(startLimitMs))
        qFatal("%s: %s", qPrintable(program), qPrintable(process.errorString()));
}

} // namespace

int freePort()
{
    QTcpServer server;
    if (!server.listen(QHostAddress::LocalHost))
        qFatal("no free port");
    return server.serverPort();
}

// Mosquitto -------------------------------------------------------------------------------------------------

bool Mosquitto::isInstalled()
{
    return !brokerProgram().isEmpty() && !QStandardPaths::findExecutable(u"mosquitto_sub"_s).isEmpty();
}

Mosquitto::Mosquitto(const QByteArray& more)
    : m_port(freePort())
{
    // As root it would become another user, who cannot read the test's certificates.
    write(m_folder.filePath(u"mosquitto.conf"_s),
          "user root\nallow_anonymous true\nmax_queued_messages 0\nlistener " + QByteArray::number(m_port) +
              " 127.0.0.1\n" + more);
    start();
}

Mosquitto::~Mosquitto()
{
    kill();
}

void Mosquitto::start()
{
    m_process.setProcessChannelMode(QProcess::MergedChannels);
    test::start(m_process, brokerProgram(), {u"-c"_s, m_folder.filePath(u"mosquitto.conf"_s)});
    for (int tries = 0; tries < startLimitMs / 20; ++tries) {
        QTcpSocket socket;
        socket.connectToHost(loopback, static_cast<quint16>(m_port));
        if (socket.waitForConnected(1000))
            return;
        QTest::qWait(20);
    }
    qFatal("mosquitto does not listen: %s", m_process.readAll().constData());
}

void Mosquitto::kill()
{
    m_process.kill();
    m_process.waitForFinished();
}

void Mosquitto::publish(const QString& topic, const QByteArray& bytes, bool isRetained) const
{
    QProcess publisher;
    QStringList arguments{u"-h"_s,
                          loopback,
                          u"-p"_s,
                          QString::number(m_port),
                          u"-q"_s,
                          u"1"_s,
                          u"-t"_s,
                          topic,
                          bytes.isEmpty() ? u"-n"_s : u"-s"_s};
    if (isRetained)
        arguments << u"-r"_s;
    test::start(publisher, u"mosquitto_pub"_s, arguments);
    publisher.write(bytes);
    publisher.closeWriteChannel();
    if (!publisher.waitForFinished(startLimitMs) || publisher.exitCode() != 0)
        qFatal("mosquitto_pub: %s", publisher.readAllStandardError().constData());
}

// Host ------------------------------------------------------------------------------------------------------

Host::Host(const Mosquitto& broker)
{
    // A topic of its own, retained, comes when all subscriptions are confirmed.
    broker.publish(u"test/ready"_s, "yes", true);
    start(m_process, u"mosquitto_sub"_s,
          {u"-h"_s, loopback, u"-p"_s, QString::number(broker.port()), u"-F"_s, u"%U %t %x"_s, u"-t"_s,
           u"spBv1.0/Hall/#"_s, u"-t"_s, u"test/ready"_s});
    while (!m_process.canReadLine()) {
        if (!m_process.waitForReadyRead(startLimitMs))
            qFatal("mosquitto_sub hears nothing");
    }
    m_process.readLine();
}

Host::~Host()
{
    m_process.kill();
    m_process.waitForFinished();
}

void Host::read()
{
    while (m_process.canReadLine()) {
        // Names of groups and nodes have no blanks here.
        const QList<QByteArray> words = m_process.readLine().trimmed().split(' ');
        const QStringList topic = QString::fromUtf8(words.value(1)).split(u'/');
        if (topic.size() != 4 || topic[2] == u"NCMD") // a test sends those
            continue;
        const auto payload = gateway::decodedPayload(QByteArray::fromHex(words.value(2)));
        if (!payload)
            qFatal("no payload: %s", words.value(2).constData());
        m_messages.append({topic[2], topic[3], *payload, words.value(0).toDouble()});
    }
}

const QList<HostMessage>& Host::messages()
{
    QCoreApplication::processEvents();
    read();
    return m_messages;
}

QList<HostMessage> Host::ofType(const QString& type, const QString& node)
{
    QList<HostMessage> found;
    for (const HostMessage& message : messages()) {
        if (message.type == type && message.node == node)
            found << message;
    }
    return found;
}

QList<gateway::PayloadMetric> Host::samplesOf(plant::Metric metric, bool hasBirths, const QString& node)
{
    QList<gateway::PayloadMetric> samples;
    for (const HostMessage& message : messages()) {
        if (message.node != node || !(message.type == u"NDATA" || (hasBirths && message.type == u"NBIRTH")))
            continue;
        for (const gateway::PayloadMetric& each : message.payload.metrics) {
            if (each.alias == static_cast<std::uint64_t>(metric))
                samples << each;
        }
    }
    return samples;
}

QString Host::gap(const QString& node)
{
    int next = -1;
    for (const HostMessage& message : messages()) {
        if (message.node != node || message.type == u"NDEATH" || !message.payload.seq)
            continue;
        const int seq = *message.payload.seq;
        if (message.type == u"NBIRTH" ? seq != 0 : seq != next)
            return u"%1: %2 %3 instead of %4"_s.arg(node, message.type).arg(seq).arg(next);
        next = (seq + 1) % 256;
    }
    return {};
}

// Panel -----------------------------------------------------------------------------------------------------

PanelStandIn::PanelStandIn(const QString& path)
{
    const QString problem = m_server.listen(path);
    if (!problem.isEmpty())
        qFatal("%s: %s", qPrintable(path), qPrintable(problem));
    connect(&m_server, &panel::PlantServer::clientConnected, this, [this] {
        plant::ValueMessage all;
        for (const plant::MetricRow& row : plant::metricTable) {
            if (row.owner == plant::MetricOwner::Panel)
                all.readings.append({row.metric, m_values[plant::metricIndex(row.metric)], 0});
        }
        m_server.send(all);
    });
    connect(&m_server, &panel::PlantServer::commandReceived, this,
            [this](const plant::CommandMessage& command) { commands << command; });
    connect(&m_server, &panel::PlantServer::offerReceived, this, [this](const plant::OfferMessage& offer) {
        ++offerMessages;
        if (offer.kind != plant::OfferMessage::Kind::Recipe)
            return;
        if (offer.name.isEmpty())
            offers.clear();
        else if (offer.file.isEmpty())
            offers.remove(offer.name);
        else
            offers.insert(offer.name, offer.file);
    });
    connect(&m_aliveTimer, &QTimer::timeout, this, [this] { m_server.send({}); });
    m_aliveTimer.start(plant::alivePeriodMs);
}

void PanelStandIn::set(plant::Metric metric, const plant::MetricValue& value)
{
    m_values[plant::metricIndex(metric)] = value;
    m_server.send({{{metric, value, 0}}});
}

void PanelStandIn::countBags(int from, int to)
{
    constexpr int together = 50; // as many as the gateway's socket holds easily
    for (int bag = from; bag <= to; ++bag) {
        set(plant::Metric::ProdProcessedCount, std::int64_t(bag));
        if (bag % together == 0)
            QTest::qWait(1);
    }
}

// Machine ---------------------------------------------------------------------------------------------------

Machine::Machine(int port, const QByteArray& lines, const QString& node)
{
    write(file(u"campanel.toml"_s), "[gateway]\nhost = \"127.0.0.1\"\nport = " + QByteArray::number(port) +
                                        "\ngroup = \"Hall\"\nnode = \"" + node.toUtf8() + "\"\n" + lines +
                                        '\n');
    m_gateway.setProcessChannelMode(QProcess::MergedChannels);
    startGateway();
}

Machine::~Machine()
{
    killGateway();
}

void Machine::startGateway()
{
    start(m_gateway, programPath("campanel-gateway"),
          {u"--config"_s, file(u"campanel.toml"_s), u"--panel"_s, file(u"panel.socket"_s), u"--state"_s,
           m_folder.path()});
}

void Machine::killGateway()
{
    m_gateway.kill();
    m_gateway.waitForFinished();
}

void Machine::endGateway()
{
    m_gateway.terminate();
    if (!m_gateway.waitForFinished(startLimitMs))
        qFatal("the gateway does not end");
}

QString Machine::log()
{
    m_log += QString::fromUtf8(m_gateway.readAll());
    return m_log;
}

} // namespace campanel::test
