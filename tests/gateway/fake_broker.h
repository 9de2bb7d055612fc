// SPDX-License-Identifier: Apache-2.0
// A broker that records what a node sends, and answers barriers when a test wants it.
#pragma once

#include "gateway/broker.h"
#include "gateway/payload.h"

#include <QList>
#include <QStringList>

namespace campanel::test {

class FakeBroker : public gateway::Broker {
public:
    struct Message {
        QString topic;
        gateway::Payload payload;
        int qos = 0;
    };

    void publish(const gateway::Publication& publication) override
    {
        const auto payload = gateway::decodedPayload(publication.payload);
        if (!payload)
            qFatal("a node publishes what is no payload");
        messages.append({publication.topic, *payload, publication.qos});
    }
    void subscribe(const QString& topic) override { topics << topic; }
    void requestBarrier() override { ++barriers; }
    void leave(int pauseMs) override { leaves << pauseMs; }
    void drop() override { ++drops; }

    // Returns the messages of a type, such as "NBIRTH".
    [[nodiscard]] QList<Message> ofType(const char* type) const
    {
        QList<Message> found;
        for (const Message& message : messages) {
            if (message.topic.section(u'/', 2, 2) == QLatin1String(type))
                found << message;
        }
        return found;
    }

    QList<Message> messages;
    QStringList topics;
    int barriers = 0;
    QList<int> leaves;
    int drops = 0;
};

// Returns the metric of a payload by its name or, without one, by its alias; one without a type when it is
// not there.
inline gateway::PayloadMetric metricIn(const gateway::Payload& payload, plant::Metric metric)
{
    for (const gateway::PayloadMetric& each : payload.metrics) {
        if (each.alias == static_cast<std::uint64_t>(metric))
            return each;
    }
    return {};
}

inline gateway::PayloadMetric metricIn(const gateway::Payload& payload, const QString& name)
{
    for (const gateway::PayloadMetric& each : payload.metrics) {
        if (each.name == name)
            return each;
    }
    return {};
}

} // namespace campanel::test
