// SPDX-License-Identifier: Apache-2.0
// The broker as the node uses it. MqttLine is the real one; tests have their own.
#pragma once

#include <QByteArray>
#include <QString>

namespace campanel::gateway {

// Returns the topic on which any message asks all machines of a group for a birth. Sparkplug has no such
// question; without it a machine that has nothing to say is not found.
[[nodiscard]] inline QString groupRebirthTopic(const QString& group)
{
    return QStringLiteral("campanel/%1/rebirth").arg(group);
}

struct Publication {
    QString topic;
    QByteArray payload;
    int qos = 0;
};

class Broker {
public:
    virtual ~Broker() = default;

    virtual void publish(const Publication& publication) = 0;
    virtual void subscribe(const QString& topic) = 0;
    // Asks the broker for an answer that it can only give after it has handled all that was sent before. The
    // node hears of it by SparkplugNode::barrierPassed().
    virtual void requestBarrier() = 0;
    // Ends the connection in order: the broker does not send the death certificate. Another one follows
    // after the pause.
    virtual void leave(int pauseMs) = 0;
    // Drops the connection like a failure: the broker sends the death certificate.
    virtual void drop() = 0;
};

} // namespace campanel::gateway
