// SPDX-License-Identifier: Apache-2.0
#include "gateway/sparkplug_node.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::gateway {

namespace {

using plant::Metric;
using plant::MetricRow;
using plant::MetricValue;

const QString rebirthName = u"Node Control/Rebirth"_s;
constexpr int seqCount = 256;
// The commands of one message that are reported; the panel limits them further.
constexpr qsizetype maxCommands = 20;

QString nameOf(const MetricRow& row)
{
    return QString::fromLatin1(row.name.data(), static_cast<qsizetype>(row.name.size()));
}

QString textOf(const MetricValue& value)
{
    return std::visit(
        [](const auto& held) -> QString {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, std::monostate>)
                return u"null"_s;
            else if constexpr (std::is_same_v<Held, bool>)
                return held ? u"true"_s : u"false"_s;
            else if constexpr (std::is_same_v<Held, QString>)
                return held;
            else
                return QString::number(held);
        },
        value);
}

QString instanceIn(const Payload& birth)
{
    const QString name = nameOf(plant::metricRow(Metric::Instance));
    for (const PayloadMetric& metric : birth.metrics) {
        if (const auto* text = std::get_if<QString>(&metric.value); text && metric.name == name)
            return *text;
    }
    return {};
}

PayloadMetric bdSeqMetric(int bdSeq, std::int64_t timestampMs)
{
    return {.name = u"bdSeq"_s,
            .timestampMs = timestampMs,
            .type = static_cast<std::uint32_t>(plant::MetricType::Int64),
            .value = std::int64_t(bdSeq)};
}

} // namespace

SparkplugNode::SparkplugNode(NodeNames names, Broker& broker, NodeClocks clocks, NodeEvents events,
                             std::size_t ringCapacity)
    : m_names(std::move(names))
    , m_broker(broker)
    , m_clocks(std::move(clocks))
    , m_events(std::move(events))
    , m_host(m_names.primaryHost)
    , m_ring(ringCapacity)
{
    const std::int64_t startMs = m_clocks.wallMs();
    for (Current& each : m_current)
        each.timestampMs = startMs;
    current(Metric::PanelPresent).value = false;
    current(Metric::ValuesDropped).value = std::int64_t(0);
    current(Metric::Instance).value = m_names.instance;
}

QString SparkplugNode::topic(const char* type) const
{
    return u"spBv1.0/%1/%2/%3"_s.arg(m_names.group, QLatin1String(type), m_names.node);
}

// The panel -------------------------------------------------------------------------------------------------

void SparkplugNode::set(Metric metric, const MetricValue& value, std::int64_t timestampMs)
{
    Current& present = current(metric);
    if (!plant::isChange(plant::metricRow(metric), present.value, value))
        return;
    present.value = value;
    present.timestampMs = timestampMs;
    m_fresh.push_back({metric, value, timestampMs});
}

void SparkplugNode::takeValues(const plant::ValueMessage& message)
{
    const std::int64_t nowMs = m_clocks.wallMs();
    m_panelAt = now();
    setPanelPresent(true);
    for (const plant::MetricReading& reading : message.readings) {
        if (plant::metricRow(reading.metric).owner == plant::MetricOwner::Panel)
            set(reading.metric, reading.value, nowMs - reading.ageMs);
    }
    handOver();
}

void SparkplugNode::panelLost()
{
    setPanelPresent(false);
    handOver();
}

// Without the panel its values are no longer known.
void SparkplugNode::setPanelPresent(bool isPresent)
{
    if (isPresent == m_isPanelPresent)
        return;
    m_isPanelPresent = isPresent;
    const std::int64_t nowMs = m_clocks.wallMs();
    set(Metric::PanelPresent, isPresent, nowMs);
    if (isPresent)
        return;
    for (const MetricRow& row : plant::metricTable) {
        if (row.owner == plant::MetricOwner::Panel)
            set(row.metric, {}, nowMs);
    }
}

// Sends the new samples, or puts them behind those that wait.
void SparkplugNode::handOver()
{
    if (m_fresh.empty())
        return;
    const std::deque<Sample> samples = std::exchange(m_fresh, {});
    if (m_isBorn && m_ring.isEmpty() && m_underWay.size() < maxUnderWay) {
        publishSamples(samples, false);
    } else {
        for (const Sample& sample : samples) {
            m_ring.push(sample);
            current(sample.metric).isLiveDue = m_isBorn;
        }
        m_isLiveDue = m_isBorn;
    }
    requestBarrierWhenDue();
}

// Messages --------------------------------------------------------------------------------------------------

PayloadMetric SparkplugNode::wireMetric(const Sample& sample) const
{
    return {.alias = static_cast<std::uint64_t>(sample.metric),
            .timestampMs = sample.timestampMs,
            .type = static_cast<std::uint32_t>(plant::metricRow(sample.metric).type),
            .value = sample.value};
}

void SparkplugNode::publish(const char* type, const Payload& payload, int qos)
{
    m_broker.publish({topic(type), encodedPayload(payload), qos});
}

Publication SparkplugNode::deathFor(int bdSeq) const
{
    const std::int64_t nowMs = m_clocks.wallMs();
    return {topic("NDEATH"), encodedPayload({nowMs, {}, {bdSeqMetric(bdSeq, nowMs)}}), 1};
}

void SparkplugNode::birthWhenAllowed()
{
    const bool isAllowed = m_isConnected && m_host.isOnline();
    if (isAllowed && m_isBirthDue && (!m_isBorn || now() - m_birthAt >= birthPause)) {
        birth();
        flush();
    }
}

void SparkplugNode::birth()
{
    const std::int64_t nowMs = m_clocks.wallMs();
    current(Metric::ValuesDropped).value = dropped();
    Payload payload{nowMs, 0, {bdSeqMetric(m_bdSeq, nowMs)}};
    payload.metrics.append({.name = rebirthName,
                            .timestampMs = nowMs,
                            .type = static_cast<std::uint32_t>(plant::MetricType::Boolean),
                            .value = false});
    for (const MetricRow& row : plant::metricTable) {
        Current& present = current(row.metric);
        present.isLiveDue = false;
        PayloadMetric metric = wireMetric({row.metric, present.value, present.timestampMs});
        metric.name = nameOf(row);
        metric.unit = QString::fromLatin1(row.unit.data(), static_cast<qsizetype>(row.unit.size()));
        payload.metrics << metric;
    }
    publish("NBIRTH", payload);
    m_seq = 1;
    m_isBorn = true;
    m_isBirthDue = false;
    m_isLiveDue = false;
    m_birthAt = now();
}

void SparkplugNode::publishSamples(const std::deque<Sample>& samples, bool isHistorical)
{
    for (std::size_t first = 0; first < samples.size(); first += maxBatch) {
        Payload payload{m_clocks.wallMs(), m_seq, {}};
        const std::size_t end = std::min(first + maxBatch, samples.size());
        for (std::size_t i = first; i < end; ++i) {
            PayloadMetric metric = wireMetric(samples[i]);
            metric.isHistorical = isHistorical;
            payload.metrics << metric;
            m_underWay.push_back(samples[i]);
        }
        publish("NDATA", payload);
        m_seq = (m_seq + 1) % seqCount;
    }
}

// Sends what waits, as far as it may be under way. When nothing waits any more, the present values follow.
void SparkplugNode::flush()
{
    while (m_isBorn && !m_ring.isEmpty() && m_underWay.size() < maxUnderWay) {
        std::deque<Sample> batch;
        while (!m_ring.isEmpty() && batch.size() < maxBatch)
            batch.push_back(m_ring.take());
        publishSamples(batch, true);
    }
    if (m_isBorn && m_ring.isEmpty() && m_isLiveDue)
        publishLive();
    requestBarrierWhenDue();
}

void SparkplugNode::publishLive()
{
    m_isLiveDue = false;
    std::deque<Sample> samples;
    for (const MetricRow& row : plant::metricTable) {
        Current& present = current(row.metric);
        if (std::exchange(present.isLiveDue, false))
            samples.push_back({row.metric, present.value, present.timestampMs});
    }
    publishSamples(samples, false);
}

// The broker ------------------------------------------------------------------------------------------------

void SparkplugNode::brokerOpened(int bdSeq)
{
    m_bdSeq = bdSeq;
    m_isConnected = true;
    m_isBorn = false;
    m_isBirthDue = true;
    m_host.forget();
    m_broker.subscribe(topic("NCMD"));
    m_broker.subscribe(topic("NBIRTH")); // of another gateway with this name
    m_broker.subscribe(groupRebirthTopic(m_names.group));
    for (const QString& state : m_host.topics())
        m_broker.subscribe(state);
    birthWhenAllowed();
}

// Sends again all values that may not have arrived.
void SparkplugNode::brokerClosed()
{
    m_isConnected = false;
    m_isBorn = false;
    m_isBarrierOut = false;
    m_ring.putBack(std::exchange(m_underWay, {}));
}

void SparkplugNode::requestBarrierWhenDue()
{
    const bool isMuch = m_underWay.size() >= maxUnderWay / 2;
    if (!m_isConnected || m_isBarrierOut || m_underWay.empty() ||
        (!isMuch && now() - m_barrierAt < barrierPause))
        return;
    m_isBarrierOut = true;
    m_barrierAt = now();
    m_asked = m_underWay.size();
    m_broker.requestBarrier();
}

void SparkplugNode::barrierPassed()
{
    if (!m_isBarrierOut)
        return;
    m_isBarrierOut = false;
    m_underWay.erase(m_underWay.begin(), m_underWay.begin() + static_cast<std::ptrdiff_t>(m_asked));
    flush();
}

void SparkplugNode::tick()
{
    if (m_isPanelPresent && now() - m_panelAt > staleAfter) {
        m_events.report(LogKind::PanelStale, u"The panel does not answer; its values are unknown."_s);
        panelLost();
        m_events.panelStale();
    }
    birthWhenAllowed();
    if (m_isBorn) {
        set(Metric::ValuesDropped, dropped(), m_clocks.wallMs());
        handOver();
    }
    if (m_isBarrierOut && now() - m_barrierAt > barrierLimit) {
        m_isBarrierOut = false;
        m_events.report(LogKind::SlowBroker,
                        u"The broker does not handle what it gets; the connection is dropped."_s);
        m_broker.drop();
    }
    requestBarrierWhenDue();
}

void SparkplugNode::end()
{
    if (m_isBorn)
        m_broker.publish(deathFor(m_bdSeq));
    m_isBorn = false;
    m_broker.leave(0);
}

void SparkplugNode::takeMessage(const QString& topic, const QByteArray& bytes)
{
    if (topic == this->topic("NCMD"))
        takeCommand(bytes);
    else if (topic == this->topic("NBIRTH"))
        takeTwin(bytes);
    else if (topic == groupRebirthTopic(m_names.group))
        m_isBirthDue = true; // in the next tick
    else
        takeHostState(m_host.take(topic, bytes));
}

// Only a rebirth is answered.
void SparkplugNode::takeCommand(const QByteArray& bytes)
{
    const auto payload = decodedPayload(bytes);
    if (!payload) {
        m_events.report(LogKind::NotACommand,
                        u"A command of %1 bytes is not understood."_s.arg(bytes.size()));
        return;
    }
    for (const PayloadMetric& metric :
         payload->metrics.first(std::min(payload->metrics.size(), maxCommands))) {
        if (metric.name == rebirthName && metric.value == MetricValue(true)) {
            m_isBirthDue = true;
            continue;
        }
        const bool isOurs = metric.alias && *metric.alias >= 1 && *metric.alias <= plant::metricCount;
        const QString ofAlias = isOurs ? nameOf(plant::metricTable[*metric.alias - 1])
                                       : u"alias %1"_s.arg(metric.alias.value_or(0));
        m_events.commandRefused({metric.name.isEmpty() ? ofAlias : metric.name, textOf(metric.value)});
    }
    birthWhenAllowed();
}

// Decides between two gateways with one name: the one with the lower instance stays. It answers the birth of
// the other one by its own; so a birth that comes once, forged or late, silences nobody.
void SparkplugNode::takeTwin(const QByteArray& bytes)
{
    const auto birth = decodedPayload(bytes);
    const QString instance = birth ? instanceIn(*birth) : QString();
    if (instance == m_names.instance || !m_isBorn)
        return;
    const QString twin =
        u"Another program publishes as node \"%1\" of the group \"%2\"; "_s.arg(m_names.node, m_names.group);
    if (instance.isEmpty()) {
        m_events.report(LogKind::Twin, twin + u"give one of them another name."_s);
    } else if (m_names.instance < instance) {
        m_events.report(LogKind::Twin, twin + u"this one stays. Give the other one another name."_s);
        m_isBirthDue = true;
    } else if (hasAnswered(instance)) {
        leaveTwin(twin);
    } else {
        m_events.report(LogKind::Twin, twin + u"this one asks whether it is a gateway."_s);
        m_isBirthDue = true;
    }
}

// Returns true for the second birth of a twin, after this node's own one. The first one is remembered.
bool SparkplugNode::hasAnswered(const QString& twin)
{
    const bool isOfAsked = twin == m_twin && now() - m_twinAskedAt <= twinAnswerLimit;
    if (isOfAsked)
        return m_birthAt > m_twinAskedAt;
    m_twin = twin;
    m_twinAskedAt = now();
    return false;
}

void SparkplugNode::leaveTwin(const QString& sentence)
{
    if (now() - m_twinLeftAt > twinMemory)
        m_twinPauses.reset();
    const int pauseMs = m_twinPauses.next(maxTwinPauseMs);
    m_twinLeftAt = now();
    m_twin.clear();
    m_events.report(LogKind::TwinLeft,
                    sentence +
                        u"this one leaves for %1 s. Set gateway.node to another name."_s.arg(pauseMs / 1000));
    m_isBorn = false; // without a death: it would be that of the other one
    m_broker.leave(pauseMs);
}

void SparkplugNode::takeHostState(PrimaryHost::Change change)
{
    if (change == PrimaryHost::Change::Online) {
        m_events.report(LogKind::HostOnline, u"The primary host is online."_s);
        birthWhenAllowed();
    } else if (change == PrimaryHost::Change::Offline) {
        m_events.report(LogKind::HostOffline, u"The primary host is offline; values wait for it."_s);
        if (m_isBorn)
            m_broker.publish(deathFor(m_bdSeq));
        m_isBorn = false;
        m_isBirthDue = true;
        m_broker.leave(leavePauseMs);
    }
}

} // namespace campanel::gateway
