// SPDX-License-Identifier: Apache-2.0
// The log of orders in the database, with those that wait in the queue. Times are milliseconds since 1970
// UTC. Call it in the thread that owns the database.
#pragma once

#include "app/store/logs/table.h"

#include <QList>
#include <QString>

#include <optional>

namespace campanel::store {

struct OrderRow {
    // Stored by number. Lost: the controller no longer knows the order; the counts are those read last.
    enum class State { Queued, Active, Complete, Ended, Lost };
    // The run does this at the quantity. Message: it goes on, and the panel says so before.
    enum class Action { None, Message, Stop };

    // Ascending in order of start. Negative while the order waits: -1 is the next one.
    qint64 id = 0;
    int number = 0;       // in the controller; 0: not given to it
    QString controller{}; // its unique id, as hexadecimal digits
    QString text{};
    QString lot{};
    QString recipe{}; // empty: any
    int version = 0;
    qint64 tableCrc = 0; // of the program at the start; 0: none
    qint64 quantity = 0; // good bags
    Action action = Action::Stop;
    qint64 messageBefore = 0; // bags, with Message
    State state = State::Queued;
    qint64 good = 0;
    qint64 rejected = 0;
    qint64 empty = 0;
    qint64 cut = 0;
    qint64 filmMm = 0; // fed meanwhile, mm
    qint64 startedMs = 0;
    qint64 endedMs = 0; // when the panel saw the end; 0: not yet
    QString startedBy{};
    QString checkedBy{};          // the first bag
    bool isClockDoubtful = false; // started while the clock was not set

    [[nodiscard]] bool isOver() const { return state > State::Active; }
    bool operator==(const OrderRow&) const = default;
};

[[nodiscard]] const Table<OrderRow>& orderTable();
// Return the stable words of the log: "under_way", "stop" ...
[[nodiscard]] QString nameOf(OrderRow::State state);
[[nodiscard]] QString nameOf(OrderRow::Action action);

// The changes of one transaction.
struct OrderChanges {
    QList<OrderRow> started;              // new ones, and written ones that have changed
    std::optional<QList<OrderRow>> queue; // the whole queue, in its order

    [[nodiscard]] bool isEmpty() const { return started.isEmpty() && !queue; }
};

class OrderLog {
public:
    static constexpr qint64 capacity = 10'000;
    static constexpr qint64 keptYears = 5;
    static constexpr int since = 10; // version of the schema

    struct Start {
        QList<OrderRow> queue;        // in its order
        std::optional<OrderRow> last; // the newest one of the controller
        qint64 lastId = 0;            // of all controllers
        qint64 newestMs = 0;          // see newestRecordMs()
    };

    // An empty controller stands for any.
    [[nodiscard]] static tl::expected<Start, StoreError> begin(Database& database, const QString& controller);
    // Writes all changes or none, then deletes what is over and beyond the capacity or the years.
    [[nodiscard]] static tl::expected<void, StoreError> write(Database& database, const OrderChanges& changes,
                                                              qint64 capacity = OrderLog::capacity);
    // Returns true when an order with this text waits or was started, as far as the log goes back.
    [[nodiscard]] static tl::expected<bool, StoreError> knows(Database& database, const QString& text);
    // Returns the orders that were under way in a span of time, in order of their start.
    [[nodiscard]] static Table<OrderRow>::Rows between(Database& database, qint64 fromMs, qint64 toMs);
};

} // namespace campanel::store
