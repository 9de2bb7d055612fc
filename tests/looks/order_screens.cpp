// SPDX-License-Identifier: Apache-2.0
// The screens of orders: on Run, the list of those that wait, the history, and a new one.
#include "tests/looks/screen_lists.h"

#include "app/store/signed_order.h"
#include "tests/looks/test_window.h"

#include <QFile>
#include <QTemporaryDir>

namespace campanel::looks {

namespace {

constexpr modbus::OrderStatus none{
    .state = modbus::OrderState::None, .action = modbus::OrderAction::None, .lot = {}};

// Lets the panel read what the controller counts.
void count(TestWindow& window, const modbus::OrderStatus& order)
{
    window.link().setOrder(order);
    panel::Orders& orders = window.panel().orders();
    orders.setWatched(false);
    orders.setWatched(true);
    window.settle();
}

void add(TestWindow& window, const char* text, const char* lot, double quantity)
{
    panel::OrderEntry& entry = *window.panel().orders().entry();
    entry.begin(QStringLiteral("Biscuit 250"));
    entry.quantity()->set(quantity);
    entry.setText(QString::fromUtf8(text));
    entry.setLot(QString::fromUtf8(lot));
    (void)window.panel().orders().add();
}

// Shows Run with an order of 5000 bags, of which so many are good, and two that wait.
void showOrder(TestWindow& window, std::uint32_t good)
{
    panel::Orders& orders = window.panel().orders();
    window.link().show(DemoLink::Situation::Running);
    window.tap(QStringLiteral("nav_run"));
    window.waitUntil(orders, &panel::Orders::changed,
                     [](const panel::Orders& each) { return each.offered() && each.book().isBegun(); });
    while (orders.queue().count() > 0)
        orders.remove(0);
    count(window, none);
    add(window, "4711", "L17", 5000);
    orders.start(0);
    window.waitUntil(orders, &panel::Orders::changed, [](const panel::Orders& each) { return !each.busy(); });
    modbus::OrderStatus order{.state = modbus::OrderState::Active,
                              .number = 1,
                              .action = modbus::OrderAction::Stop,
                              .isKept = true,
                              .quantity = 5000,
                              .good = good,
                              .rejected = 31,
                              .empty = 12,
                              .cut = good + 31 + 12,
                              .lot = "L17"};
    count(window, order);
    if (good == order.quantity)
        order.state = modbus::OrderState::Complete;
    count(window, order);
    orders.dismissNotice();
    orders.setCheckedBy(QStringLiteral("Bo Lindqvist"));
    add(window, "4712", "L18", 12'000);
    add(window, "4713", "2026-48-B", 800);
    window.settle();
}

// Offers an order that can be taken, and one that is for another machine.
void offer(TestWindow& window)
{
    panel::OrderOffers& offers = *window.panel().orders().offers();
    const QTemporaryDir keys;
    QFile file(keys.filePath(QStringLiteral("anna.json")));
    if (!file.open(QIODevice::WriteOnly) || file.write(store::publicKeyFile(window.signer())) < 0)
        qFatal("no key");
    file.close();
    offers.setTrust(keys.path(), QStringLiteral("Packer 7"));
    const auto add = [&](const char* name, const char* machine, qint64 quantity) {
        const store::OrderRow order{.text = QString::fromLatin1(name),
                                    .lot = QStringLiteral("L19"),
                                    .recipe = QStringLiteral("Biscuit 250"),
                                    .quantity = quantity};
        offers.takeOffer(
            {order.text,
             store::signOrder(order, QString::fromLatin1(machine), 1'790'000'000'000, window.signer()),
             plant::OfferMessage::Kind::Order});
    };
    add("4714", "Packer 7", 20'000);
    add("4715", "Packer 8", 500);
    window.waitUntil(offers, &panel::OrderOffers::changed,
                     [](panel::OrderOffers& each) { return each.rows()->rows().size() == 2; });
}

Screen order(const char* name, std::uint32_t good, const QStringList& taps)
{
    return {QString::fromLatin1(name), [good, taps](TestWindow& window) {
                showOrder(window, good);
                for (const QString& tapped : taps)
                    window.tap(tapped);
            }};
}

} // namespace

void forgetOrders(TestWindow& window)
{
    panel::Orders& orders = window.panel().orders();
    while (orders.queue().count() > 0)
        orders.remove(0);
    orders.offers()->takeOffer({{}, {}, plant::OfferMessage::Kind::Order});
    orders.dismissNotice();
    if (orders.current().present())
        count(window, none);
    orders.setWatched(false);
}

QList<Screen> orderScreens()
{
    const QString strip = QStringLiteral("orderStrip");
    const QString entry = QStringLiteral("ordersNew");
    return {
        order("run-order", 1240, {}),
        order("run-order-complete", 5000, {}),
        order("orders-sheet", 1240, {strip}),
        order("orders-history", 1240, {strip, QStringLiteral("ordersHistory")}),
        order("orders-filter", 1240,
              {strip, QStringLiteral("ordersHistory"), QStringLiteral("ordersFilter")}),
        order("orders-end", 1240, {strip, QStringLiteral("orderEnd")}),
        order("new-order", 5000, {strip, entry}),
        {QStringLiteral("orders-offered"),
         [=](TestWindow& window) {
             showOrder(window, 1240);
             offer(window);
             window.tap(strip);
         }},
        {QStringLiteral("new-order-filled"),
         [=](TestWindow& window) {
             showOrder(window, 5000);
             window.tap(strip);
             window.tap(entry);
             panel::OrderEntry& form = *window.panel().orders().entry();
             form.quantity()->set(12'000);
             form.setText(QStringLiteral("4711/2026 Kaufland"));
             form.setLot(QStringLiteral("L17-2026-48-B"));
             form.setAction(panel::OrderEntry::Message);
             window.settle();
         }},
        order("new-order-lot", 5000, {strip, entry, QStringLiteral("orderLot")}),
        order("new-order-recipe", 5000, {strip, entry, QStringLiteral("orderRecipe")}),
    };
}

} // namespace campanel::looks
