// SPDX-License-Identifier: Apache-2.0
#include "gateway/offer_inbox.h"

using namespace Qt::StringLiterals;

namespace campanel::gateway {

OfferInbox::OfferInbox(const QString& group, Broker& broker, InboxEvents events)
    : m_folder(u"campanel/%1/recipes/"_s.arg(group))
    , m_broker(broker)
    , m_events(std::move(events))
{
}

// Offers that were withdrawn while the broker was away do not come again.
void OfferInbox::brokerOpened()
{
    m_hasOpened = true;
    m_offers.clear();
    m_reported.clear();
    m_events.offer({});
    m_broker.subscribe(m_folder + u'+');
}

bool OfferInbox::take(const QString& topic, const QByteArray& file)
{
    if (!topic.startsWith(m_folder))
        return false;
    const QString name = topic.sliced(m_folder.size());
    if (name.isEmpty() || name.size() > plant::maxTextLength)
        return true;
    if (file.isEmpty()) {
        if (m_offers.remove(name) > 0)
            m_events.offer({name, {}});
        return true;
    }
    if (!m_offers.contains(name) && m_offers.size() >= plant::maxOffers) {
        if (m_reported.size() < plant::maxOffers && !m_reported.contains(name)) {
            m_reported.insert(name);
            m_events.report(
                u"%1 recipes are offered already; %2 is not passed on."_s.arg(plant::maxOffers).arg(name));
        }
        return true;
    }
    const QByteArray kept = file.left(plant::maxOfferBytes + 1);
    if (m_offers.value(name) == kept)
        return true;
    m_offers.insert(name, kept);
    m_events.offer({name, kept});
    return true;
}

// A gateway that was just started does not know what is offered.
void OfferInbox::panelConnected() const
{
    if (!m_hasOpened)
        return;
    m_events.offer({});
    for (auto offer = m_offers.begin(); offer != m_offers.end(); ++offer)
        m_events.offer({offer.key(), offer.value()});
}

} // namespace campanel::gateway
