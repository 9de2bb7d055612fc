// SPDX-License-Identifier: Apache-2.0
// A plant on this computer: mosquitto on the loopback interface, mosquitto_sub as a host, the panel's end of
// the local socket, and campanel-gateway between them.
#pragma once

#include "app/panel/plant/plant_server.h"
#include "gateway/payload.h"

#include <QList>
#include <QMap>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>
#include <QTimer>

#include <array>

namespace campanel::test {

// Returns a port of 127.0.0.1 that nobody uses.
[[nodiscard]] int freePort();

class Mosquitto {
public:
    // Starts it; `more` are further lines of its configuration.
    explicit Mosquitto(const QByteArray& more = {});
    ~Mosquitto();
    Mosquitto(const Mosquitto&) = delete;
    Mosquitto& operator=(const Mosquitto&) = delete;

    // Returns false when the program is not installed.
    [[nodiscard]] static bool isInstalled();
    [[nodiscard]] int port() const { return m_port; }
    void kill();
    void start(); // again, on the same port
    // Publishes by mosquitto_pub.
    void publish(const QString& topic, const QByteArray& bytes, bool isRetained = false) const;

private:
    QTemporaryDir m_folder;
    int m_port;
    QProcess m_process;
};

// A message as mosquitto_sub has received it.
struct HostMessage {
    QString type; // NBIRTH, NDATA, NDEATH
    QString node;
    gateway::Payload payload;
    double timeS = 0; // when it came, since 1970 UTC
};

class Host {
public:
    // Subscribes to all messages of the group "Hall"; returns when the broker has confirmed that.
    explicit Host(const Mosquitto& broker);
    ~Host();
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    // Returns what came so far.
    [[nodiscard]] const QList<HostMessage>& messages();
    [[nodiscard]] QList<HostMessage> ofType(const QString& type, const QString& node = QStringLiteral("P1"));
    // Returns the samples of a metric in births (`hasBirths`) and data of a node.
    [[nodiscard]] QList<gateway::PayloadMetric> samplesOf(plant::Metric metric, bool hasBirths = false,
                                                          const QString& node = QStringLiteral("P1"));
    // Returns the first gap in the sequence numbers as a sentence; empty: there is none.
    [[nodiscard]] QString gap(const QString& node = QStringLiteral("P1"));

private:
    void read();

    QProcess m_process;
    QList<HostMessage> m_messages;
};

// The panel's end of the socket, with a machine that the test plays.
class PanelStandIn : public QObject {
public:
    explicit PanelStandIn(const QString& path);

    void set(plant::Metric metric, const plant::MetricValue& value);
    // Sets the bag counter to from, from + 1, ... to, each as one message, and lets the gateway keep up.
    void countBags(int from, int to);
    void hang() { m_aliveTimer.stop(); }
    void recover() { m_aliveTimer.start(); }
    [[nodiscard]] bool hasGateway() const { return m_server.hasClients(); }

    QList<plant::CommandMessage> commands;
    QMap<QString, QByteArray> offers; // as the panel has them now
    int offerMessages = 0;

private:
    panel::PlantServer m_server{this};
    QTimer m_aliveTimer;
    std::array<plant::MetricValue, plant::metricCount> m_values;
};

// Folder, configuration, panel and gateway of one machine.
class Machine {
    QTemporaryDir m_folder;

public:
    // `lines` are further lines of [gateway], such as "primary_host = \"scada\"".
    Machine(int port, const QByteArray& lines = {}, const QString& node = QStringLiteral("P1"));
    ~Machine();
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;

    void startGateway();
    void killGateway(); // like kill -9
    void endGateway();  // as the service manager does
    // Returns what it has written to the log so far.
    [[nodiscard]] QString log();
    [[nodiscard]] bool isGatewayRunning() const { return m_gateway.state() == QProcess::Running; }
    [[nodiscard]] QString file(const QString& name) const { return m_folder.filePath(name); }

    PanelStandIn panel{file(QStringLiteral("panel.socket"))};

private:
    QProcess m_gateway;
    QString m_log;
};

} // namespace campanel::test
