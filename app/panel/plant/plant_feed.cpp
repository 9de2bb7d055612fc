// SPDX-License-Identifier: Apache-2.0
#include "app/panel/plant/plant_feed.h"

#include "app/panel/audit/audit_trail.h"
#include "app/store/files/files.h"

#include <QLoggingCategory>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

Q_LOGGING_CATEGORY(plantLog, "campanel.plant")

} // namespace

PlantFeed::PlantFeed(const PlantSources& sources, AuditTrail& trail, QObject* parent)
    : QObject(parent)
    , m_trail(trail)
    , m_values(sources, nullptr)
{
    m_sendTimer.setSingleShot(true);
    m_sendTimer.setInterval(0);
    m_aliveTimer.setInterval(plant::alivePeriodMs);
    m_minuteTimer.setSingleShot(true);
    m_minuteTimer.setInterval(periodAfter(0));
    connect(&m_values, &PlantValues::changed, this, &PlantFeed::noteChange);
    connect(&m_sendTimer, &QTimer::timeout, this, [this] { send(false); });
    connect(&m_aliveTimer, &QTimer::timeout, this, [this] { send(true); });
    connect(&m_minuteTimer, &QTimer::timeout, this, &PlantFeed::endMinute);
    connect(&m_server, &PlantServer::clientConnected, this, &PlantFeed::startAnew);
    connect(&m_server, &PlantServer::commandReceived, this, &PlantFeed::noteCommand);
    connect(&m_server, &PlantServer::offerReceived, this, &PlantFeed::offerReceived);
    connect(&m_server, &PlantServer::gatewayChanged, this, &PlantFeed::gatewayChanged);
}

PlantFeed::~PlantFeed()
{
    endMinute();
}

void PlantFeed::open(const QString& socketPath)
{
    const QString problem = m_server.listen(socketPath);
    if (problem.isEmpty())
        m_aliveTimer.start();
    else
        qCWarning(plantLog, "the gateway cannot reach the panel: %s: %s", qPrintable(socketPath),
                  qPrintable(problem));
}

void PlantFeed::startAnew()
{
    m_sent.clear();
    send(false);
}

void PlantFeed::noteChange()
{
    if (m_server.hasClients())
        m_sendTimer.start();
}

void PlantFeed::send(bool isPeriodOver)
{
    m_sendTimer.stop();
    if (!m_server.hasClients())
        return;
    const QList<plant::MetricReading> now = m_values.readings();
    plant::ValueMessage message;
    for (qsizetype i = 0; i < now.size(); ++i) {
        if (m_sent.isEmpty() || m_sent[i].value != now[i].value)
            message.readings << now[i];
    }
    m_sent = now;
    if (isPeriodOver || !message.readings.isEmpty())
        m_server.send(message);
}

void PlantFeed::noteCommand(const plant::CommandMessage& command)
{
    if (!m_minuteTimer.isActive())
        m_minuteTimer.start();
    if (m_rows >= maxRowsPerMinute) {
        ++m_withoutRow;
        return;
    }
    ++m_rows;
    addRow(command.metric, command.value);
}

void PlantFeed::endMinute()
{
    if (m_withoutRow > 0)
        addRow(u"+%1"_s.arg(m_withoutRow), {});
    m_minuteTimer.setInterval(periodAfter(m_withoutRow));
    m_rows = 0;
    m_withoutRow = 0;
}

void PlantFeed::addRow(const QString& object, const QString& value)
{
    m_trail.noteOutside({.what = u"network.command"_s,
                         .object = store::oneLine(object),
                         .after = store::oneLine(value),
                         .outcome = u"refused"_s});
}

} // namespace campanel::panel
