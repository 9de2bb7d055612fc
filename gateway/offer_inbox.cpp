// SPDX-License-Identifier: Apache-2.0
#include "gateway/offer_inbox.h"

#include "app/store/files/files.h"
#include "app/store/recipes/signed_recipe.h"
#include "app/store/signed_order.h"

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::gateway {

QString OfferInbox::recipeTopic(const QString& group)
{
    return u"campanel/%1/recipes/"_s.arg(group);
}

QString OfferInbox::orderTopic(const QString& group, const QString& node)
{
    return u"campanel/%1/orders/%2/"_s.arg(group, node);
}

OfferInbox::OfferInbox(Kind kind, const QString& folder, Broker& broker, InboxEvents events,
                       QString keyFolder)
    : m_kind(kind)
    , m_folder(folder)
    , m_keyFolder(std::move(keyFolder))
    , m_broker(broker)
    , m_events(std::move(events))
{
}

// Offers that were withdrawn while the broker was away do not come again.
void OfferInbox::brokerOpened()
{
    m_hasOpened = true;
    m_keys = store::signerKeys(m_keyFolder);
    m_offers.clear();
    m_due.clear();
    m_isClearDue = true;
    m_broker.subscribe(m_folder + u'+');
}

bool OfferInbox::take(const QString& topic, const QByteArray& file)
{
    if (!topic.startsWith(m_folder))
        return false;
    const QString name = topic.sliced(m_folder.size());
    if (name.isEmpty() || name.size() > plant::maxTextLength)
        return true;
    const auto present = m_offers.constFind(name);
    const QByteArray kept = file.left(plant::maxOfferBytes + 1);
    if (kept.isEmpty() || (present != m_offers.constEnd() && present->file == kept)) {
        if (kept.isEmpty())
            remove(name);
        return true;
    }
    Offer offer = offerOf(kept);
    if (present != m_offers.constEnd()) {
        report(u"The offer %1 is replaced by another one with its name."_s, name);
        remove(name);
    }
    if (!makeRoom(name, offer))
        return true;
    offer.order = ++m_arrivals;
    m_offers.insert(name, offer);
    setDue(name);
    return true;
}

OfferInbox::Offer OfferInbox::offerOf(const QByteArray& file) const
{
    if (m_kind == Kind::Order) {
        if (const auto order = store::verifyOrder(file, {}, m_keys))
            return {file, true, order->order.text, order->signedMs, 0};
    } else if (const auto recipe = store::verifyRecipe(file, {}, m_keys)) {
        return {file, true, QString::fromStdString(recipe->recipe.name), recipe->recipe.version, 0};
    }
    return {file, false, {}, 0, 0};
}

bool OfferInbox::makeRoom(const QString& name, const Offer& offer)
{
    if (offer.isTrusted) {
        const auto other = std::find_if(m_offers.begin(), m_offers.end(), [&offer](const Offer& each) {
            return each.isTrusted && each.subject == offer.subject;
        });
        if (other != m_offers.end() && other->version > offer.version) {
            report(u"The offer %1 is not passed on: a newer one of its recipe or order is offered."_s, name);
            return false;
        }
        if (other != m_offers.end()) {
            report(u"The offer %1 is replaced by another one of its recipe or order."_s, other.key());
            remove(other.key());
        }
    }
    const qsizetype untrusted =
        std::ranges::count_if(m_offers, [](const Offer& each) { return !each.isTrusted; });
    if (!offer.isTrusted && untrusted >= maxUntrusted)
        removeOldest(false,
                     u"The offer %1 is left out: newer ones are not signed by a trusted key either."_s);
    else if (m_offers.size() >= plant::maxOffers)
        removeOldest(untrusted == 0, u"The offer %1 is left out: there are too many."_s);
    return true;
}

void OfferInbox::removeOldest(bool isTrusted, const QString& reason)
{
    QString oldest;
    for (auto offer = m_offers.cbegin(); offer != m_offers.cend(); ++offer) {
        if (offer->isTrusted == isTrusted && (oldest.isEmpty() || offer->order < m_offers[oldest].order))
            oldest = offer.key();
    }
    report(reason, oldest);
    remove(oldest);
}

void OfferInbox::remove(QString name)
{
    if (m_offers.remove(name) > 0)
        setDue(name);
}

// Appends the name: what leaves is said before what takes its place. So many changes are said by all offers.
void OfferInbox::setDue(const QString& name)
{
    constexpr qsizetype maxDue = 4 * plant::maxOffers;
    m_due.removeAll(name);
    m_due << name;
    if (m_due.size() <= maxDue)
        return;
    m_isClearDue = true;
    m_due = m_offers.keys();
}

void OfferInbox::report(const QString& sentence, const QString& name) const
{
    m_events.report(LogKind::Offer, sentence.arg(store::oneLine(name)));
}

// A gateway that was just started does not know what is offered.
void OfferInbox::panelConnected()
{
    m_isClearDue = m_hasOpened;
    m_due = m_offers.keys();
}

void OfferInbox::tick()
{
    if (m_isClearDue && !m_events.offer({{}, {}, m_kind}))
        return;
    m_isClearDue = false;
    while (!m_due.isEmpty() && m_events.offer({m_due.first(), m_offers.value(m_due.first()).file, m_kind}))
        m_due.removeFirst();
}

} // namespace campanel::gateway
