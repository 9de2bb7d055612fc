// SPDX-License-Identifier: Apache-2.0
// Sends the values of the machine to the gateway, and writes the commands that came from the network into the
// audit trail. No command is carried out; offered recipes are passed on.
#pragma once

#include "app/panel/plant/plant_server.h"
#include "app/panel/plant/plant_values.h"

#include <QObject>
#include <QTimer>

namespace campanel::panel {

class AuditTrail;

class PlantFeed : public QObject {
    Q_OBJECT

public:
    // The rows that commands may add to the audit trail in a minute; the others are counted in one row. The
    // trail is for what people changed: after a minute with more commands an hour counts as one.
    static constexpr int maxRowsPerMinute = 10;
    [[nodiscard]] static constexpr std::chrono::minutes periodAfter(int withoutRow)
    {
        return std::chrono::minutes(withoutRow > 0 ? 60 : 1);
    }

    // All arguments must outlive the object.
    PlantFeed(const PlantSources& sources, AuditTrail& trail, QObject* parent);
    // Writes the count of commands that have no row yet.
    ~PlantFeed() override;

    // Starts to listen. Without this call nothing is sent and no value is gathered.
    void open(const QString& socketPath);

signals:
    // Emitted for a recipe or an order that the plant offers or withdraws.
    void offerReceived(const campanel::plant::OfferMessage& offer);
    // Emitted with the version of a gateway that has connected; empty: none is connected any more.
    void gatewayChanged(const QString& version);

private:
    // Sends all values in the next message.
    void startAnew();
    void noteChange();
    // Sends the changed values; without any only when the period is over.
    void send(bool isPeriodOver);
    void noteCommand(const plant::CommandMessage& command);
    void endMinute();
    void addRow(const QString& object, const QString& value);

    AuditTrail& m_trail;
    PlantValues m_values;
    PlantServer m_server{this};
    QTimer m_sendTimer; // runs out when the event loop has handled what came in together
    QTimer m_aliveTimer;
    QTimer m_minuteTimer;
    QList<plant::MetricReading> m_sent; // the last readings; empty: all are to be sent
    int m_rows = 0;                     // in this period
    int m_withoutRow = 0;
};

} // namespace campanel::panel
