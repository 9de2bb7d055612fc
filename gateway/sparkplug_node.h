// SPDX-License-Identifier: Apache-2.0
// A Sparkplug B edge node: births, data, deaths, and the values that wait. Values and events come in by
// calls, messages go out to the Broker. No socket, no thread, and clocks that a test can set.
#pragma once

#include "app/plant/local_messages.h"
#include "gateway/back_off.h"
#include "gateway/broker.h"
#include "gateway/log_limit.h"
#include "gateway/payload.h"
#include "gateway/primary_host.h"
#include "gateway/value_ring.h"

#include <QString>

#include <array>
#include <chrono>
#include <deque>
#include <functional>

namespace campanel::gateway {

struct NodeNames {
    QString group;
    QString node;
    QString primaryHost = {}; // empty: none
    QString instance;         // a random text of this process
};

struct NodeClocks {
    std::function<std::chrono::steady_clock::time_point()> steady = &std::chrono::steady_clock::now;
    std::function<std::int64_t()> wallMs; // since 1970 UTC; it may jump
};

// The events that somebody else must hear of.
struct NodeEvents {
    std::function<void(const plant::CommandMessage&)> commandRefused;
    std::function<void()> panelStale; // its next message must have all values
    std::function<void(LogKind, const QString& sentence)> report;
};

class SparkplugNode {
public:
    // The panel is silent for this time before its values are no longer true; it sends every half second.
    static constexpr std::chrono::milliseconds staleAfter{1500};
    // The values in one message, and the ones that may be under way to the broker.
    static constexpr std::size_t maxBatch = 250;
    static constexpr std::size_t maxUnderWay = 5000;
    // The pause between two births: a flood of rebirths must not become one of births.
    static constexpr std::chrono::milliseconds birthPause{500};
    // The pause between two questions whether all has arrived, and the longest time for an answer.
    static constexpr std::chrono::milliseconds barrierPause{1000};
    static constexpr std::chrono::milliseconds barrierLimit{10'000};
    static constexpr int leavePauseMs = 1000;
    // The pauses of the one of two nodes with the same name that has to leave: the first one, and the
    // longest.
    static constexpr int twinPauseMs = 10'000;
    static constexpr int maxTwinPauseMs = 60'000;
    // A twin has to answer this node's birth by its own within this time: a birth alone may be forged.
    static constexpr std::chrono::milliseconds twinAnswerLimit{5000};
    // Without a twin for this time the pauses are short again.
    static constexpr std::chrono::minutes twinMemory{15};

    SparkplugNode(NodeNames names, Broker& broker, NodeClocks clocks, NodeEvents events,
                  std::size_t ringCapacity = ValueRing::standardCapacity);

    // The panel.
    void takeValues(const plant::ValueMessage& message);
    void panelLost();

    // The broker. deathFor() is the last will of the next connection.
    [[nodiscard]] Publication deathFor(int bdSeq) const;
    void brokerOpened(int bdSeq);
    void brokerClosed();
    void takeMessage(const QString& topic, const QByteArray& bytes);
    void barrierPassed();

    // Does what is due; call it every 100 ms or so.
    void tick();
    // Says goodbye: publishes the death certificate, and leaves.
    void end();

    [[nodiscard]] bool isBorn() const { return m_isBorn; }
    [[nodiscard]] std::size_t waiting() const { return m_ring.size(); }
    [[nodiscard]] std::int64_t dropped() const { return m_ring.dropped(); }

private:
    struct Current {
        plant::MetricValue value;
        std::int64_t timestampMs = 0;
        // The newest sample is historical, so that a host does not show it as the present value.
        bool isLiveDue = false;
    };

    [[nodiscard]] QString topic(const char* type) const;
    [[nodiscard]] Current& current(plant::Metric metric) { return m_current[plant::metricIndex(metric)]; }
    void set(plant::Metric metric, const plant::MetricValue& value, std::int64_t timestampMs);
    void setPanelPresent(bool isPresent);
    void handOver();
    void birth();
    void birthWhenAllowed();
    void flush();
    void publishSamples(const std::deque<Sample>& samples, bool isHistorical);
    void publishLive();
    void requestBarrierWhenDue();
    void takeCommand(const QByteArray& bytes);
    void takeTwin(const QByteArray& bytes);
    [[nodiscard]] bool hasAnswered(const QString& twin);
    void leaveTwin(const QString& sentence);
    void takeHostState(PrimaryHost::Change change);
    [[nodiscard]] PayloadMetric wireMetric(const Sample& sample) const;
    void publish(const char* type, const Payload& payload, int qos = 0);
    [[nodiscard]] std::chrono::steady_clock::time_point now() const { return m_clocks.steady(); }

    NodeNames m_names;
    Broker& m_broker;
    NodeClocks m_clocks;
    NodeEvents m_events;
    PrimaryHost m_host;
    ValueRing m_ring;
    std::array<Current, plant::metricCount> m_current;
    std::deque<Sample> m_fresh;    // of this event, not handed over yet
    std::deque<Sample> m_underWay; // published; it is not known if the broker has them
    std::size_t m_asked = 0;       // the first ones of these, which the barrier is for
    bool m_isBarrierOut = false;
    std::chrono::steady_clock::time_point m_barrierAt{};
    std::chrono::steady_clock::time_point m_panelAt{};
    std::chrono::steady_clock::time_point m_birthAt{};
    QString m_twin; // the lower instance that was asked for its birth at this time
    std::chrono::steady_clock::time_point m_twinAskedAt{};
    std::chrono::steady_clock::time_point m_twinLeftAt{};
    BackOff m_twinPauses{twinPauseMs};
    bool m_isPanelPresent = false;
    bool m_isConnected = false;
    bool m_isBorn = false;
    bool m_isBirthDue = false;
    bool m_isLiveDue = false; // for a metric at least
    int m_bdSeq = 0;
    int m_seq = 0;
};

} // namespace campanel::gateway
