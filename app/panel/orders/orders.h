// SPDX-License-Identifier: Apache-2.0
// `Orders` in QML: the order that the controller counts, the queue of those that wait, and their history. The
// controller counts and ends an order also while no panel is connected; the panel keeps texts and people.
#pragma once

#include "app/panel/kit/singleton.h"
#include "app/panel/kit/watched.h"
#include "app/panel/orders/order_book.h"
#include "app/panel/orders/order_entry.h"
#include "app/panel/orders/order_offers.h"
#include "app/panel/orders/order_rows.h"
#include "app/panel/records/buffered_writer.h"
#include "app/panel/records/paged_log.h"
#include "app/store/logs/audit_log.h"

#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <optional>

namespace campanel::panel {

class Controller;

class Orders : public campanel::panel::Watched, public Singleton<Orders> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // True with a packing machine, whose bags a controller can count.
    Q_PROPERTY(bool offered READ offered NOTIFY changed FINAL)
    // Why this controller counts no orders; empty: it does.
    Q_PROPERTY(QString tooOldText READ tooOldText NOTIFY changed FINAL)
    // The order that the controller counts, or the last one.
    Q_PROPERTY(campanel::panel::OrderListRow current READ current NOTIFY changed FINAL)
    // False while its counts are older than some seconds.
    Q_PROPERTY(bool fresh READ fresh NOTIFY changed FINAL)
    // The time at which it ends at the present rate, "14:35"; empty: the machine stands, or there is none.
    Q_PROPERTY(QString endText READ endText NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* queue READ queueRows CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::PagedLogBase* history READ history CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::OrderEntry* entry READ entry CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::OrderOffers* offers READ offers CONSTANT FINAL)
    // Why the last request was not carried out; empty: it was.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)
    // The recipe of the order whose start was refused because the controller has another one; empty: none.
    Q_PROPERTY(QString wantedRecipe READ wantedRecipe NOTIFY changed FINAL)
    // For the banner: an order is complete, or soon; empty: nothing to say.
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged FINAL)

public:
    using WallClock = std::function<qint64()>; // milliseconds since 1970 UTC
    using History = PagedLog<OrderRows, &OrderListRow::order>;

    // All arguments must outlive the object. The log begins when the records are opened.
    Orders(Controller& controller, DatabaseService& records, QObject* parent);

    void setWallClock(WallClock clock) { m_wallClock = std::move(clock); }

    [[nodiscard]] bool offered() const;
    [[nodiscard]] QString tooOldText() const;
    [[nodiscard]] OrderListRow current() const;
    [[nodiscard]] bool fresh() const;
    [[nodiscard]] link::SteadyTime readAt() const { return m_readAt; }
    [[nodiscard]] QString endText() const;
    [[nodiscard]] RowModelBase* queueRows() { return &m_queue; }
    [[nodiscard]] const OrderRows& queue() const { return m_queue; }
    [[nodiscard]] History* history() { return &m_history; }
    [[nodiscard]] OrderEntry* entry() { return &m_entry; }
    [[nodiscard]] OrderOffers* offers() { return &m_offers; }
    [[nodiscard]] QString message() const { return m_message; }
    [[nodiscard]] QString wantedRecipe() const { return m_message.isEmpty() ? QString() : m_wantedRecipe; }
    [[nodiscard]] QString notice() const { return m_notice; }
    [[nodiscard]] const OrderBook& book() const { return m_book; }
    // Returns true while the controller has not answered a start or an end.
    [[nodiscard]] bool busy() const { return m_isSending; }

    // All of these are for operators; what cannot be done says so in `message`.
    // Adds the order of the form to the queue. Returns false when it was not added.
    Q_INVOKABLE bool add();
    // Adds the order of the form before all others and starts it.
    Q_INVOKABLE bool addAndStart();
    // Adds an order that the plant offers to the queue.
    Q_INVOKABLE void addOffered(int row);
    Q_INVOKABLE void start(int row);
    Q_INVOKABLE void end();
    Q_INVOKABLE void remove(int row);
    Q_INVOKABLE void raise(int row); // by one place
    // Sets who has checked the first bag of the current order.
    Q_INVOKABLE void setCheckedBy(const QString& name);

    Q_INVOKABLE void clearMessage();
    Q_INVOKABLE void dismissNotice();

    // Reads and writes what is due; runs every second.
    void check();

signals:
    void changed();
    void noticeChanged();
    // Emitted when the controller has begun to count an order, or has ended one.
    void turned();
    // Emitted for the audit trail.
    void noted(const campanel::store::AuditEntry& entry);

private:
    [[nodiscard]] OrderBook::Now now() const;
    [[nodiscard]] OrderBook::Program program() const;
    [[nodiscard]] QString startRefusal(const store::OrderRow& order) const;
    // Shows that refusal. Returns true without one.
    [[nodiscard]] bool canBegin(const store::OrderRow& order);
    [[nodiscard]] bool isForOther(const store::OrderRow& order) const;
    [[nodiscard]] bool isRowOfQueue(int row) const;
    [[nodiscard]] bool takeEntry(qsizetype place);
    // Adds the order unless `problem` or the queue refuses, and says so. Returns true when it was added.
    [[nodiscard]] bool insert(qsizetype place, const store::OrderRow& order, QString problem,
                              const QString& signer = {});
    void followConnection();
    void begin(const QString& controller);
    void read();
    void takeRead(const link::ReadOutcome& outcome);
    void noteChange(const OrderListRow& before);
    void send(const store::OrderRow& order);
    void takeOutcome(const store::AuditEntry& entry, const link::CommandOutcome& outcome);
    void write();
    void update();
    void showMessage(const QString& text);
    void showNotice(const QString& text);

    Controller& m_controller;
    DatabaseService& m_records;
    OrderBook m_book;
    BufferedWriter<OrderBook, store::OrderLog> m_writer;
    OrderRows m_queue{this};
    History m_history;
    OrderEntry m_entry{this};
    OrderOffers m_offers;
    WallClock m_wallClock;
    QTimer m_timer;
    QString m_controllerId;
    qint64 m_newestMs = 0;
    bool m_isBeginning = false;
    bool m_isAsked = false;
    bool m_isSending = false;
    std::optional<modbus::OrderStatus> m_status; // of the connected controller
    link::SteadyTime m_readAt{};
    link::SteadyTime m_writtenAt{};
    qint64 m_announcedEnd = 0; // the order whose message has come
    QString m_message;
    QString m_wantedRecipe;
    QString m_notice;
};

} // namespace campanel::panel
