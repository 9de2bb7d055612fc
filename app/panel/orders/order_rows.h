// SPDX-License-Identifier: Apache-2.0
// An order as QML shows it: the present one, those of the queue, those of the history.
#pragma once

#include "app/panel/kit/row_model.h"
#include "app/panel/words/alarm_words.h"
#include "app/panel/words/order_words.h"

#include <QDate>

namespace campanel::panel {

struct OrderListRow {
    Q_GADGET
    QML_VALUE_TYPE(orderRow)
    // False without an order.
    Q_PROPERTY(bool present READ present FINAL)
    Q_PROPERTY(bool underWay READ underWay FINAL)
    Q_PROPERTY(bool complete READ complete FINAL)
    Q_PROPERTY(QString title READ title FINAL)
    Q_PROPERTY(QString recipe READ recipe FINAL) // "Biscuit 250 · v3"; empty: any
    Q_PROPERTY(QString stateText READ stateText FINAL)
    Q_PROPERTY(QString progress READ progress FINAL) // "1,240 of 5,000"
    Q_PROPERTY(QString quantity READ quantity FINAL)
    Q_PROPERTY(QString actionText READ actionText FINAL)
    // Begin and end, recipe, and who has started the order and checked the first bag.
    Q_PROPERTY(QString facts READ facts FINAL)
    Q_PROPERTY(QString checkedBy READ checkedBy FINAL)
    Q_PROPERTY(QString clockNote READ clockNote FINAL)
    Q_PROPERTY(double fraction READ fraction FINAL)   // of the good bags, 0..1
    Q_PROPERTY(double startedMs READ startedMs FINAL) // since 1970 UTC
    Q_PROPERTY(double endedMs READ endedMs FINAL)     // 0: not yet
    Q_PROPERTY(double good READ good FINAL)
    Q_PROPERTY(double rejected READ rejected FINAL)
    Q_PROPERTY(double empty READ empty FINAL)

public:
    store::OrderRow order;
    QDate today; // times of other days include the date

    [[nodiscard]] qint64 id() const { return order.id; }
    [[nodiscard]] bool present() const { return order.id != 0; }
    [[nodiscard]] bool underWay() const { return order.state == store::OrderRow::State::Active; }
    [[nodiscard]] bool complete() const { return order.state == store::OrderRow::State::Complete; }
    [[nodiscard]] QString title() const { return OrderWords::title(order); }
    [[nodiscard]] QString recipe() const { return OrderWords::recipe(order); }
    [[nodiscard]] QString stateText() const { return OrderWords::state(order.state); }
    [[nodiscard]] QString progress() const { return OrderWords::progress(order); }
    [[nodiscard]] QString quantity() const { return OrderWords::count(order.quantity); }
    [[nodiscard]] QString actionText() const { return OrderWords::action(order.action, order.messageBefore); }
    [[nodiscard]] QString facts() const { return OrderWords::facts(order, today); }
    [[nodiscard]] QString checkedBy() const { return order.checkedBy; }
    [[nodiscard]] QString clockNote() const { return AlarmWords::clockNote(order.isClockDoubtful); }
    [[nodiscard]] double fraction() const
    {
        return order.quantity > 0 ? static_cast<double>(order.good) / static_cast<double>(order.quantity) : 0;
    }
    [[nodiscard]] double startedMs() const { return static_cast<double>(order.startedMs); }
    [[nodiscard]] double endedMs() const { return static_cast<double>(order.endedMs); }
    [[nodiscard]] double good() const { return static_cast<double>(order.good); }
    [[nodiscard]] double rejected() const { return static_cast<double>(order.rejected); }
    [[nodiscard]] double empty() const { return static_cast<double>(order.empty); }

    bool operator==(const OrderListRow&) const = default;
};

using OrderRows = RowModel<OrderListRow, &OrderListRow::id>;

} // namespace campanel::panel
