// SPDX-License-Identifier: Apache-2.0
// The machines of a group, from the messages of their gateways.
#pragma once

#include "gateway/payload.h"

#include <QByteArray>
#include <QList>
#include <QMap>
#include <QString>

#include <array>

namespace campanel::gateway {

struct FleetMachine {
    QString node;
    bool isOnline = false; // its gateway is
    std::array<plant::MetricValue, plant::metricCount> values;
    std::int64_t crcSinceMs = 0; // since 1970 UTC: when the present CRC-32 was first seen
    std::int64_t bdSeq = -1;

    [[nodiscard]] const plant::MetricValue& value(plant::Metric metric) const
    {
        return values[plant::metricIndex(metric)];
    }
};

class Fleet {
public:
    explicit Fleet(QString group)
        : m_group(std::move(group))
    {
    }

    // Returns the topics of all messages of the group that say something about a machine.
    [[nodiscard]] QStringList topics() const;
    // Takes a message. Other programs of the group, and what is no payload, are left out.
    void take(const QString& topic, const QByteArray& bytes);
    // Returns the machines by their names.
    [[nodiscard]] QList<FleetMachine> machines() const { return m_machines.values(); }

private:
    void takeBirth(const QString& node, const Payload& birth);
    static void takeValues(FleetMachine& machine, const Payload& payload);

    QString m_group;
    QMap<QString, FleetMachine> m_machines;
};

} // namespace campanel::gateway
