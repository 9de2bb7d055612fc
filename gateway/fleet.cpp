// SPDX-License-Identifier: Apache-2.0
#include "gateway/fleet.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::gateway {

namespace {

using plant::Metric;

constexpr qsizetype topicLevels = 4; // spBv1.0/GROUP/TYPE/NODE

// Returns true for the birth of a gateway of CamPanel.
bool isOfCamPanel(const Payload& birth)
{
    const auto& row = plant::metricRow(Metric::RecipeCrc);
    return std::ranges::any_of(birth.metrics, [&row](const PayloadMetric& metric) {
        return metric.alias == static_cast<std::uint64_t>(row.metric) &&
               metric.name == QLatin1String(row.name.data(), static_cast<qsizetype>(row.name.size()));
    });
}

std::int64_t bdSeqOf(const Payload& payload)
{
    for (const PayloadMetric& metric : payload.metrics) {
        if (const auto* number = std::get_if<std::int64_t>(&metric.value); number && metric.name == u"bdSeq")
            return *number;
    }
    return -1;
}

} // namespace

QStringList Fleet::topics() const
{
    QStringList all;
    for (const char* type : {"NBIRTH", "NDATA", "NDEATH"})
        all << u"spBv1.0/%1/%2/+"_s.arg(m_group, QLatin1String(type));
    return all;
}

void Fleet::take(const QString& topic, const QByteArray& bytes)
{
    const QStringList levels = topic.split(u'/');
    const auto payload = decodedPayload(bytes);
    if (levels.size() != topicLevels || levels[1] != m_group || !payload)
        return;
    const QString& node = levels[3];
    if (levels[2] == u"NBIRTH")
        return takeBirth(node, *payload);
    const auto machine = m_machines.find(node);
    if (machine == m_machines.end())
        return;
    if (levels[2] == u"NDATA")
        takeValues(*machine, *payload);
    else if (bdSeqOf(*payload) == machine->bdSeq) // not the late one of an earlier connection
        machine->isOnline = false;
}

void Fleet::takeBirth(const QString& node, const Payload& birth)
{
    if (!isOfCamPanel(birth))
        return;
    FleetMachine machine;
    machine.node = node;
    machine.isOnline = true;
    machine.bdSeq = bdSeqOf(birth);
    takeValues(machine, birth);
    m_machines.insert(node, machine);
}

void Fleet::takeValues(FleetMachine& machine, const Payload& payload)
{
    for (const PayloadMetric& metric : payload.metrics) {
        if (!metric.alias || *metric.alias < 1 || *metric.alias > plant::metricCount || metric.isHistorical)
            continue;
        const auto& row = plant::metricTable[*metric.alias - 1];
        if (!plant::isOfType(metric.value, row.type))
            continue;
        machine.values[plant::metricIndex(row.metric)] = metric.value;
        if (row.metric == Metric::RecipeCrc)
            machine.crcSinceMs = metric.timestampMs;
    }
}

} // namespace campanel::gateway
