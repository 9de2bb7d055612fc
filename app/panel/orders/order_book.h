// SPDX-License-Identifier: Apache-2.0
// The orders of one controller: the one that it counts, matched by its number, and the queue. Changes are
// collected for the log. Values only: no clock, no thread.
#pragma once

#include "app/link/link_values.h"
#include "app/store/logs/order_log.h"

#include <limits>
#include <map>
#include <optional>

namespace campanel::panel {

class OrderBook {
public:
    static constexpr qsizetype maxQueued = 20;

    struct Now {
        qint64 utcMs = 0;
        bool isClockDoubtful = false;
    };
    // The controller's program.
    struct Program {
        QString recipe; // empty: none
        int version = 0;
        qint64 tableCrc = 0;
        double bagLengthMm = 0;
    };

    // Continues with the last order of this controller, and the first time with the queue. Changes must be
    // written before.
    void begin(const store::OrderLog::Start& start, const QString& controller);
    [[nodiscard]] bool isBegun() const { return m_isBegun; }

    // Applies what the controller reports. An order that nobody at this panel has started is entered too.
    // `filmMm` is the position of the film, of which only the changes count; NaN: unknown.
    void note(const modbus::OrderStatus& status, const Program& program, double filmMm, const Now& now);

    // Returns the order that the controller counts, or the last one; empty: it has had none.
    [[nodiscard]] const std::optional<store::OrderRow>& last() const { return m_last; }
    [[nodiscard]] bool isUnderWay() const { return m_last && !m_last->isOver(); }
    [[nodiscard]] const QList<store::OrderRow>& queue() const { return m_queue; }

    void insert(qsizetype place, const store::OrderRow& order);
    void remove(qsizetype at);
    void raise(qsizetype at); // by one place
    // Sets under which number the controller will get a queued order, and by whom. It is written before the
    // command is sent: after a crash between the two the order is found again.
    void announce(qsizetype at, int number, const QString& by);
    void withdraw(int number); // it was refused
    void setCheckedBy(const QString& name);

    // Returns the changes to write, and clears them.
    [[nodiscard]] store::OrderChanges takeChanges();
    // Puts changes that could not be written back.
    void putBack(const store::OrderChanges& changes);
    // Returns true when more than the counts has changed.
    [[nodiscard]] bool hasNews() const { return m_hasNews; }
    [[nodiscard]] bool hasChanges() const { return m_isQueueChanged || !m_changed.empty(); }

private:
    [[nodiscard]] qsizetype announced(const modbus::OrderStatus& status) const;
    [[nodiscard]] bool isLast(const modbus::OrderStatus& status) const;
    void start(const modbus::OrderStatus& status, const Program& program, const Now& now);
    void update(const modbus::OrderStatus& status, const Program& program, double filmMm, const Now& now);
    void lose(const Now& now);
    void keepLast(bool isNews);
    void changeQueue();

    bool m_isBegun = false;
    QString m_controller;
    qint64 m_lastId = 0;
    std::optional<store::OrderRow> m_last;
    double m_filmMm = std::numeric_limits<double>::quiet_NaN(); // at the last report
    QList<store::OrderRow> m_queue;
    std::map<qint64, store::OrderRow> m_changed; // by id
    bool m_isQueueChanged = false;
    bool m_hasNews = false;
};

} // namespace campanel::panel
