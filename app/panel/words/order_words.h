// SPDX-License-Identifier: Apache-2.0
// Orders as translated text: states, actions, and why an entry is refused.
#pragma once

#include "app/store/logs/order_log.h"

#include <QCoreApplication>
#include <QDateTime>

namespace campanel::panel {

class OrderWords {
    Q_DECLARE_TR_FUNCTIONS(OrderWords)

public:
    static constexpr int maxTextLength = 80; // characters of the order's text

    [[nodiscard]] static QString state(store::OrderRow::State state);
    [[nodiscard]] static QString count(qint64 bags);
    [[nodiscard]] static QString action(store::OrderRow::Action action, qint64 messageBefore);
    // Returns order and lot, "4711 · L17", else the number in the controller.
    [[nodiscard]] static QString title(const store::OrderRow& order);
    // Returns "1,240 of 5,000".
    [[nodiscard]] static QString progress(const store::OrderRow& order);
    // Returns "Biscuit 250 · v3"; empty: any recipe.
    [[nodiscard]] static QString recipe(const store::OrderRow& order);
    // Returns "14:05 to 15:20 · Biscuit 250 · v3 · started by Ann · first bag checked by Bo", as far as it is
    // known.
    [[nodiscard]] static QString facts(const store::OrderRow& order, const QDate& today);
    // Return why an order cannot have this lot or this text; empty: it can.
    [[nodiscard]] static QString lotRefusal(const QString& lot);
    [[nodiscard]] static QString textRefusal(const QString& text);
    // Returns why the controller counts no orders with this version of the map.
    [[nodiscard]] static QString tooOld(int mapMajor, int mapMinor);
};

} // namespace campanel::panel
