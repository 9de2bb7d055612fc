// SPDX-License-Identifier: Apache-2.0
#include "app/panel/orders/order_offers.h"

#include "app/panel/kit/language_notifier.h"
#include "app/panel/records/database_service.h"
#include "app/panel/words/order_words.h"
#include "app/store/files/files.h"

using namespace Qt::StringLiterals;

namespace campanel::panel {

OrderOffers::OrderOffers(DatabaseService& records, QObject* parent)
    : QObject(parent)
    , m_records(records)
{
    LanguageNotifier::follow(this, [this] { show(); });
}

void OrderOffers::setTrust(const QString& keyFolder, const QString& machine)
{
    m_keyFolder = keyFolder;
    m_machine = machine;
}

void OrderOffers::takeOffer(const plant::OfferMessage& offer)
{
    if (offer.kind != plant::OfferMessage::Kind::Order)
        return;
    plant::applyOffer(m_received, offer, offer.file);
    update();
}

void OrderOffers::update()
{
    if (m_received.isEmpty() && m_checked.isEmpty())
        return;
    m_records.store().run(
        this,
        [received = m_received, folder = m_keyFolder](store::Database& database) {
            const QList<store::SignerKey> keys = store::signerKeys(folder);
            QList<Checked> checked;
            for (const auto& [name, file] : received.asKeyValueRange()) {
                const auto order = store::verifyOrder(file, name, keys);
                const bool isKnown =
                    order && store::OrderLog::knows(database, order->order.text).value_or(false);
                checked << Checked{name, order, isKnown};
            }
            return checked;
        },
        [this](const QList<Checked>& checked) {
            m_checked = checked;
            show();
        });
}

void OrderOffers::show()
{
    QList<OfferRow> rows;
    QStringList titles;
    for (const Checked& offer : std::as_const(m_checked)) {
        rows << row(offer);
        if (rows.last().usable)
            titles << rows.last().title;
    }
    m_rows.setRows(rows);
    m_titles = titles.join(u" · "_s);
    emit changed();
}

QString OrderOffers::refusal(const Checked& offer) const
{
    if (!offer.order)
        return store::FileErrorText::describe(offer.order.error());
    if (offer.order->machine != m_machine)
        return tr("This order is for the machine %1; this one is %2.")
            .arg(store::oneLine(offer.order->machine), m_machine);
    const store::OrderRow& order = offer.order->order;
    for (const QString& problem : {OrderWords::textRefusal(order.text), OrderWords::lotRefusal(order.lot),
                                   OrderWords::textRefusal(order.recipe)}) {
        if (!problem.isEmpty())
            return problem;
    }
    return offer.isKnown ? tr("It waits in the queue, or was started already.") : QString();
}

OfferRow OrderOffers::row(const Checked& offer) const
{
    OfferRow row;
    row.detail = refusal(offer);
    row.usable = row.detail.isEmpty();
    row.title = store::oneLine(offer.name);
    row.note = row.detail;
    if (!offer.order)
        return row;
    const store::OrderRow& order = offer.order->order;
    QStringList parts{tr("%1 bags").arg(OrderWords::count(order.quantity))};
    if (!order.recipe.isEmpty())
        parts << store::oneLine(order.recipe);
    parts << OrderWords::action(order.action, order.messageBefore)
          << tr("signed by %1", "person").arg(offer.order->signer);
    row.title = store::oneLine(OrderWords::title(order));
    if (row.usable)
        row.note = parts.join(u" · "_s);
    return row;
}

std::optional<store::SignedOrder> OrderOffers::orderAt(int row) const
{
    if (row < 0 || row >= m_checked.size() || !refusal(m_checked[row]).isEmpty())
        return {};
    return *m_checked[row].order;
}

} // namespace campanel::panel
