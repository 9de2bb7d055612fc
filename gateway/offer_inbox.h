// SPDX-License-Identifier: Apache-2.0
// The recipes that the plant offers, as retained messages of the broker. They are passed on to the panel
// unread: the panel checks signature and content, and a person there accepts.
#pragma once

#include "app/plant/local_messages.h"
#include "gateway/broker.h"

#include <QMap>
#include <QSet>

#include <functional>

namespace campanel::gateway {

struct InboxEvents {
    std::function<void(const plant::OfferMessage&)> offer; // for the panel
    std::function<void(const QString& sentence)> report;   // for the log
};

class OfferInbox {
public:
    OfferInbox(const QString& group, Broker& broker, InboxEvents events);

    // Subscribes; the broker sends all offers anew.
    void brokerOpened();
    // Returns true for a message on a topic of the offers. An empty one withdraws its offer.
    [[nodiscard]] bool take(const QString& topic, const QByteArray& file);
    // Sends all offers to a panel that has connected.
    void panelConnected() const;

private:
    bool m_hasOpened = false; // the broker, once
    QString m_folder;         // topic of the offers, with the last slash
    Broker& m_broker;
    InboxEvents m_events;
    QMap<QString, QByteArray> m_offers; // by name; a large one is cut
    QSet<QString> m_reported;           // names that found no place
};

} // namespace campanel::gateway
