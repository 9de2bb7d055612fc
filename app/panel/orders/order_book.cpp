// SPDX-License-Identifier: Apache-2.0
#include "app/panel/orders/order_book.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::panel {

using modbus::OrderState;
using modbus::OrderStatus;
using store::OrderRow;

namespace {

static_assert(static_cast<int>(OrderRow::Action::Message) == static_cast<int>(modbus::OrderAction::Message) &&
              static_cast<int>(OrderRow::Action::Stop) == static_cast<int>(modbus::OrderAction::Stop));

OrderRow::State stateOf(OrderState state)
{
    return state == OrderState::Active     ? OrderRow::State::Active
           : state == OrderState::Complete ? OrderRow::State::Complete
                                           : OrderRow::State::Ended;
}

bool hasCounts(const OrderRow& row, const OrderStatus& status)
{
    return row.quantity == status.quantity && row.good == status.good && row.rejected == status.rejected &&
           row.empty == status.empty && row.cut == status.cut;
}

QString lotOf(const OrderStatus& status)
{
    return QString::fromStdString(status.lot);
}

} // namespace

void OrderBook::begin(const store::OrderLog::Start& start, const QString& controller)
{
    if (!std::exchange(m_isBegun, true))
        m_queue = start.queue;
    m_controller = controller;
    m_lastId = start.lastId;
    m_last = start.last;
}

// An order that is over keeps its counts: with other ones it is a new order under an old number.
bool OrderBook::isLast(const OrderStatus& status) const
{
    if (!m_last || m_last->number != status.number || m_last->controller != m_controller)
        return false;
    switch (m_last->state) {
    case OrderRow::State::Complete:
    case OrderRow::State::Ended:
        return m_last->state == stateOf(*status.state) && hasCounts(*m_last, status);
    case OrderRow::State::Lost:
        return status.cut >= m_last->cut && lotOf(status) == m_last->lot;
    default:
        return status.cut >= m_last->cut;
    }
}

// Returns the place in the queue of the order that the controller got under this number; -1: none.
qsizetype OrderBook::announced(const OrderStatus& status) const
{
    const auto found = std::ranges::find_if(m_queue, [&](const OrderRow& each) {
        return each.number == status.number && each.controller == m_controller &&
               each.quantity == status.quantity && each.lot == lotOf(status);
    });
    return found == m_queue.end() ? -1 : found - m_queue.begin();
}

void OrderBook::note(const OrderStatus& status, const Program& program, double filmMm, const Now& now)
{
    if (!m_isBegun || !status.state)
        return;
    if (*status.state == OrderState::None || status.number == 0)
        return lose(now);
    if (announced(status) >= 0 || !isLast(status)) {
        lose(now);
        start(status, program, now);
        m_filmMm = filmMm;
    }
    update(status, program, filmMm, now);
}

void OrderBook::lose(const Now& now)
{
    if (!isUnderWay() || m_last->controller != m_controller)
        return;
    m_last->state = OrderRow::State::Lost;
    m_last->endedMs = now.utcMs;
    keepLast(true);
}

void OrderBook::start(const OrderStatus& status, const Program& program, const Now& now)
{
    OrderRow row;
    if (const qsizetype at = announced(status); at >= 0) {
        row = m_queue.takeAt(at);
        changeQueue();
    }
    row.id = ++m_lastId;
    row.number = status.number;
    row.controller = m_controller;
    row.recipe = program.recipe;
    row.version = program.version;
    row.tableCrc = program.tableCrc;
    row.state = OrderRow::State::Active;
    row.startedMs = now.utcMs;
    row.isClockDoubtful = now.isClockDoubtful;
    m_last = row;
    keepLast(true);
}

// Film that the panel did not see is counted by the bags that were cut of it.
void OrderBook::update(const OrderStatus& status, const Program& program, double filmMm, const Now& now)
{
    const OrderRow before = *m_last;
    const double seenMm = filmMm - std::exchange(m_filmMm, filmMm);
    if (!before.isOver() && seenMm >= 0)
        m_last->filmMm += std::llround(seenMm);
    else if (!before.isOver() && status.cut > before.cut)
        m_last->filmMm += std::llround(static_cast<double>(status.cut - before.cut) * program.bagLengthMm);
    m_last->state = stateOf(*status.state);
    m_last->lot = lotOf(status);
    m_last->quantity = status.quantity;
    if (status.action)
        m_last->action = static_cast<OrderRow::Action>(*status.action);
    m_last->good = status.good;
    m_last->rejected = status.rejected;
    m_last->empty = status.empty;
    m_last->cut = status.cut;
    if (!m_last->isOver())
        m_last->endedMs = 0;
    else if (m_last->endedMs == 0)
        m_last->endedMs = now.utcMs;
    if (*m_last != before)
        keepLast(m_last->state != before.state);
}

void OrderBook::insert(qsizetype place, const OrderRow& order)
{
    m_queue.insert(place, order);
    changeQueue();
}

void OrderBook::remove(qsizetype at)
{
    m_queue.removeAt(at);
    changeQueue();
}

void OrderBook::raise(qsizetype at)
{
    m_queue.swapItemsAt(at, at - 1);
    changeQueue();
}

void OrderBook::announce(qsizetype at, int number, const QString& by)
{
    OrderRow& order = m_queue[at];
    order.number = number;
    order.controller = m_controller;
    order.startedBy = by;
    changeQueue();
}

void OrderBook::withdraw(int number)
{
    for (OrderRow& order : m_queue) {
        if (order.number != number)
            continue;
        order.number = 0;
        order.controller.clear();
        order.startedBy.clear();
        changeQueue();
    }
}

void OrderBook::setCheckedBy(const QString& name)
{
    if (!m_last)
        return;
    m_last->checkedBy = name;
    keepLast(true);
}

void OrderBook::keepLast(bool isNews)
{
    m_changed.insert_or_assign(m_last->id, *m_last);
    m_hasNews = m_hasNews || isNews;
}

void OrderBook::changeQueue()
{
    m_isQueueChanged = m_hasNews = true;
}

store::OrderChanges OrderBook::takeChanges()
{
    store::OrderChanges changes;
    for (const auto& [id, row] : std::exchange(m_changed, {}))
        changes.started << row;
    if (std::exchange(m_isQueueChanged, false))
        changes.queue = m_queue;
    m_hasNews = false;
    return changes;
}

void OrderBook::putBack(const store::OrderChanges& changes)
{
    for (const OrderRow& row : changes.started)
        m_changed.emplace(row.id, row); // a newer one stays
    m_isQueueChanged = m_isQueueChanged || changes.queue;
    m_hasNews = m_hasNews || !changes.isEmpty();
}

} // namespace campanel::panel
