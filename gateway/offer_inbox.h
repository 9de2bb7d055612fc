// SPDX-License-Identifier: Apache-2.0
// The recipes or orders that the plant offers, as retained messages of the broker. They are passed on to the
// panel, which checks signature and content again; a person there accepts. The signature decides here whose
// offers have a place: anybody who reaches the broker may fill it with others.
#pragma once

#include "app/plant/local_messages.h"
#include "app/store/recipes/recipe_keys.h"
#include "gateway/broker.h"
#include "gateway/log_limit.h"

#include <QMap>

#include <functional>

namespace campanel::gateway {

struct InboxEvents {
    std::function<bool(const plant::OfferMessage&)> offer; // for the panel; false: it has no room now
    std::function<void(LogKind, const QString& sentence)> report;
};

class OfferInbox {
public:
    // The places of offers without the signature of a trusted key: their reasons can be read on the panel.
    static constexpr qsizetype maxUntrusted = 4;

    using Kind = plant::OfferMessage::Kind;

    // `folder` is the topic above the offers; see recipeTopic() and orderTopic(). `keyFolder` has the public
    // keys of the signers that the panel trusts.
    OfferInbox(Kind kind, const QString& folder, Broker& broker, InboxEvents events, QString keyFolder = {});

    // Return the topics above the offers: of recipes to a group, of orders to a machine.
    [[nodiscard]] static QString recipeTopic(const QString& group);
    [[nodiscard]] static QString orderTopic(const QString& group, const QString& node);

    // Subscribes; the broker sends all offers anew.
    void brokerOpened();
    // Returns true for a message on a topic of the offers. An empty one withdraws its offer.
    [[nodiscard]] bool take(const QString& topic, const QByteArray& file);
    // Sends all offers to a panel that has connected.
    void panelConnected();
    // Sends what has changed, as far as the panel has room: of many offers with one name only the newest.
    void tick();

private:
    struct Offer {
        QByteArray file; // a large one is cut
        bool isTrusted = false;
        QString subject;      // of a trusted one: the recipe, or the text of the order
        qint64 version = 0; // of the recipe, or the time of the order's signature
        qint64 order = 0;   // of its arrival
    };

    [[nodiscard]] Offer offerOf(const QByteArray& file) const;
    // Frees a place for the offer. Returns false when a newer version of its recipe is offered.
    [[nodiscard]] bool makeRoom(const QString& name, const Offer& offer);
    // Removes the oldest offer with or without trust.
    void removeOldest(bool isTrusted, const QString& reason);
    void remove(QString name); // by value: it may be the key of what goes
    void setDue(const QString& name);
    void report(const QString& sentence, const QString& name) const;

    Kind m_kind;
    bool m_hasOpened = false; // the broker, once
    QString m_folder;         // topic of the offers, with the last slash
    QString m_keyFolder;
    QList<store::SignerKey> m_keys; // at the time of the last connection
    Broker& m_broker;
    InboxEvents m_events;
    QMap<QString, Offer> m_offers; // by name
    qint64 m_arrivals = 0;
    bool m_isClearDue = false;
    QStringList m_due; // names that the panel has to hear of
};

} // namespace campanel::gateway
