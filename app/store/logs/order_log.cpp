// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/order_log.h"

#include "app/store/database/clock_mark.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

using Written = tl::expected<void, StoreError>;

constexpr qint64 msPerYear = 31'557'600'000; // 365.25 days

void csvState(CsvWriter& csv, const QVariant& value)
{
    csv.text(nameOf(static_cast<OrderRow::State>(value.toInt())));
}

void csvAction(CsvWriter& csv, const QVariant& value)
{
    csv.text(nameOf(static_cast<OrderRow::Action>(value.toInt())));
}

void csvCrc(CsvWriter& csv, const QVariant& value)
{
    value == 0 ? csv.empty() : csv.text(u"%1"_s.arg(value.toLongLong(), 8, 16, QChar(u'0')));
}

Written writeQueue(Database& database, const QList<OrderRow>& queue)
{
    if (const auto gone = database.execute(u"DELETE FROM production_order WHERE id < 0"_s); !gone)
        return tl::unexpected(gone.error());
    for (qsizetype place = 0; place < queue.size(); ++place) {
        OrderRow row = queue[place];
        row.id = -(place + 1);
        if (const Written done = orderTable().insert(database, row); !done)
            return done;
    }
    return {};
}

// A doubtful clock deletes nothing: the newest start that is not marked counts as the present.
Written forgetOldest(Database& database, qint64 capacity)
{
    const auto gone = database.execute(uR"(DELETE FROM production_order WHERE id > 0 AND state > 1 AND
            (id <= (SELECT max(id) FROM production_order) - ? OR
             started_ms < (SELECT max(started_ms) FROM production_order WHERE clock_doubtful = 0) - ?))"_s,
                                       {capacity, OrderLog::keptYears * msPerYear});
    return gone ? Written() : tl::unexpected(gone.error());
}

} // namespace

QString nameOf(OrderRow::State state)
{
    switch (state) {
    case OrderRow::State::Queued:
        return u"queued"_s;
    case OrderRow::State::Active:
        return u"under_way"_s;
    case OrderRow::State::Complete:
        return u"complete"_s;
    case OrderRow::State::Ended:
        return u"ended"_s;
    case OrderRow::State::Lost:
        break;
    }
    return u"lost"_s;
}

QString nameOf(OrderRow::Action action)
{
    switch (action) {
    case OrderRow::Action::None:
        return u"none"_s;
    case OrderRow::Action::Message:
        return u"message"_s;
    case OrderRow::Action::Stop:
        break;
    }
    return u"stop"_s;
}

const Table<OrderRow>& orderTable()
{
    using Row = OrderRow;
    static const Table<Row> table{
        u"production_order"_s,
        OrderLog::since,
        {{.name = u"id"_s, .member = &Row::id},
         {.name = u"number"_s, .member = &Row::number, .sought = Sought::Number},
         {.name = u"controller"_s, .member = &Row::controller},
         {.name = u"order_text"_s,
          .member = &Row::text,
          .heading = u"order"_s,
          .sought = Sought::Name | Sought::Word},
         {.name = u"lot"_s, .member = &Row::lot, .sought = Sought::Name | Sought::Word},
         {.name = u"recipe"_s, .member = &Row::recipe, .sought = Sought::Word},
         {.name = u"version"_s, .member = &Row::version},
         {.name = u"table_crc"_s, .member = &Row::tableCrc, .form = csvCrc},
         {.name = u"quantity"_s, .member = &Row::quantity},
         {.name = u"action"_s, .member = &Row::action, .form = csvAction},
         {.name = u"message_before"_s, .member = &Row::messageBefore},
         {.name = u"state"_s, .member = &Row::state, .form = csvState},
         {.name = u"good"_s, .member = &Row::good},
         {.name = u"rejected"_s, .member = &Row::rejected},
         {.name = u"empty"_s, .member = &Row::empty},
         {.name = u"cut"_s, .member = &Row::cut},
         {.name = u"film_mm"_s, .member = &Row::filmMm, .since = 11},
         {.name = u"started_ms"_s,
          .member = &Row::startedMs,
          .heading = u"started_utc"_s,
          .form = csvUtc,
          .sought = Sought::Time},
         {.name = u"ended_ms"_s, .member = &Row::endedMs, .heading = u"ended_utc"_s, .form = csvUtc},
         {.name = u"started_by"_s, .member = &Row::startedBy, .sought = Sought::Word},
         {.name = u"checked_by"_s, .member = &Row::checkedBy, .sought = Sought::Word},
         {.name = u"clock_doubtful"_s,
          .member = &Row::isClockDoubtful,
          .heading = u"clock"_s,
          .form = csvClock}}};
    return table;
}

tl::expected<OrderLog::Start, StoreError> OrderLog::begin(Database& database, const QString& controller)
{
    const auto queue = orderTable().read(database, u"WHERE id < 0 ORDER BY id DESC"_s);
    if (!queue)
        return tl::unexpected(queue.error());
    const auto last =
        orderTable().read(database, u"WHERE id > 0 AND (? = '' OR controller = ?) ORDER BY id DESC LIMIT 1"_s,
                          {controller, controller});
    if (!last)
        return tl::unexpected(last.error());
    auto newest = database.execute(u"SELECT coalesce(max(id), 0) FROM production_order WHERE id > 0"_s);
    if (!newest)
        return tl::unexpected(newest.error());
    const auto newestMs = newestRecordMs(database);
    if (!newestMs)
        return tl::unexpected(newestMs.error());
    Start start;
    start.queue = *queue;
    if (!last->isEmpty())
        start.last = last->first();
    start.lastId = newest->next() ? newest->value(0).toLongLong() : 0;
    start.newestMs = *newestMs;
    return start;
}

tl::expected<void, StoreError> OrderLog::write(Database& database, const OrderChanges& changes,
                                               qint64 capacity)
{
    return database.transaction([&]() -> Written {
        for (const OrderRow& row : changes.started) {
            if (const Written done = orderTable().write(database, row); !done)
                return done;
        }
        if (changes.queue) {
            if (const Written done = writeQueue(database, *changes.queue); !done)
                return done;
        }
        return changes.started.isEmpty() ? Written() : forgetOldest(database, capacity);
    });
}

tl::expected<bool, StoreError> OrderLog::knows(Database& database, const QString& text)
{
    auto found = database.execute(u"SELECT 1 FROM production_order WHERE order_text = ? LIMIT 1"_s, {text});
    if (!found)
        return tl::unexpected(found.error());
    return found->next();
}

Table<OrderRow>::Rows OrderLog::between(Database& database, qint64 fromMs, qint64 toMs)
{
    return orderTable().read(
        database, u"WHERE id > 0 AND started_ms < ? AND (ended_ms = 0 OR ended_ms >= ?) ORDER BY id"_s,
        {toMs, fromMs});
}

} // namespace campanel::store
