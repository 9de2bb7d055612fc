// SPDX-License-Identifier: Apache-2.0
// campanelctl order: the order that the controller counts, started, read and ended; and those in a panel's
// database.
#include "app/cli/commands.h"
#include "app/cli/database_file.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/report.h"
#include "app/cli/signed_file.h"
#include "app/panel/words/order_words.h"
#include "app/store/logs/order_log.h"
#include "app/store/signed_order.h"
#include "modbus/map/order_status.h"

#include <algorithm>
#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

// The store knows no registers.
static_assert(store::maxOrderedBags == modbus::maxOrderQuantity);

using modbus::OrderAction;
using modbus::OrderState;

// The order that speaks to the controller, or what is wrong with the options.
struct NewOrder {
    std::uint32_t quantity = 0;
    OrderAction action = OrderAction::Stop;
    std::string lot;
};

// As the option takes it.
QString actionKey(OrderAction action)
{
    return QString::fromStdString(modbus::enumName(action)).toLower();
}

tl::expected<NewOrder, Failure> orderOf(const Invocation& call)
{
    NewOrder order;
    bool isNumber = false;
    order.quantity = call.value(u"quantity"_s).toUInt(&isNumber);
    if (!isNumber || order.quantity == 0 || order.quantity > modbus::maxOrderQuantity)
        return fail(ExitCode::Usage,
                    u"--quantity takes a whole number of bags, 1 to %1."_s.arg(modbus::maxOrderQuantity));
    const QString lot = call.value(u"lot"_s).trimmed();
    order.lot = lot.toStdString();
    if (lot.isEmpty() || order.lot.size() > 2 * modbus::orderLotRegisters)
        return fail(ExitCode::Usage,
                    u"--lot takes a text of 1 to %1 bytes."_s.arg(2 * modbus::orderLotRegisters));
    if (std::ranges::any_of(lot, [](QChar character) { return !character.isPrint(); }))
        return fail(ExitCode::Usage, u"--lot takes one line of printable characters."_s);
    QStringList actions;
    for (const OrderAction action : {OrderAction::None, OrderAction::Message, OrderAction::Stop}) {
        actions << actionKey(action);
        if (call.value(u"action"_s) == actions.last()) {
            order.action = action;
            return order;
        }
    }
    return fail(ExitCode::Usage, u"--action takes one of: %1."_s.arg(actions.join(u", "_s)));
}

tl::expected<modbus::OrderStatus, Failure> read(LinkSession& session)
{
    if (session.identity().mapMinor < modbus::orderMapMinor)
        return fail(
            ExitCode::Refused,
            u"This controller counts no orders: its register map is 1.%1, orders need 1.%2."_s.arg(
                QString::number(session.identity().mapMinor), QString::number(modbus::orderMapMinor)));
    const auto registers =
        session.client().readProven(modbus::orderStatusAddress, modbus::orderStatusRegisters);
    if (!registers)
        return fail(registers.error());
    return modbus::decodeOrderStatus(*registers);
}

// The keys that tell of an order are null where the controller has none.
QJsonObject objectOf(const modbus::OrderStatus& status)
{
    const bool isKnown = status.state.has_value() && *status.state != OrderState::None;
    const auto count = [isKnown](auto value) {
        return isKnown ? QJsonValue(static_cast<qint64>(value)) : QJsonValue();
    };
    return {{u"state"_s, status.state ? QJsonValue(QString::fromStdString(modbus::enumName(*status.state)))
                                      : QJsonValue()},
            {u"number"_s, count(status.number)},
            {u"lot"_s, isKnown ? QJsonValue(QString::fromStdString(status.lot)) : QJsonValue()},
            {u"action"_s, isKnown && status.action ? QJsonValue(actionKey(*status.action)) : QJsonValue()},
            {u"quantity"_s, count(status.quantity)},
            {u"good"_s, count(status.good)},
            {u"rejected"_s, count(status.rejected)},
            {u"empty"_s, count(status.empty)},
            {u"on_the_way"_s, count(status.onTheWay)},
            {u"cut"_s, count(status.cut)},
            {u"survives_power_cut"_s, status.isKept}};
}

Outcome start(const Invocation& call)
{
    const auto order = orderOf(call);
    if (!order)
        return tl::unexpected(order.error());
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    const auto before = read(*session);
    if (!before)
        return tl::unexpected(before.error());
    // The number tells an order from the one before it.
    const bool isLast = before->number == std::numeric_limits<std::uint16_t>::max();
    const auto number = static_cast<std::uint16_t>(isLast ? 1 : before->number + 1);
    if (const Outcome given =
            session->command(modbus::Command::OrderStart, {number, static_cast<std::uint16_t>(order->action),
                                                           order->quantity, order->lot});
        !given)
        return given;
    return call.deliver(
        formatted(QJsonObject{{u"number"_s, number}, {u"quantity"_s, static_cast<qint64>(order->quantity)}},
                  call.format()));
}

Outcome print(const Invocation& call, LinkSession& session)
{
    const auto order = read(session);
    if (!order)
        return tl::unexpected(order.error());
    return call.deliver(formatted(objectOf(*order), call.format()));
}

Outcome status(const Invocation& call)
{
    auto session = LinkSession::open(call);
    return session ? print(call, *session) : tl::unexpected(session.error());
}

Outcome end(const Invocation& call)
{
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    const auto order = read(*session);
    if (!order)
        return tl::unexpected(order.error());
    if (const Outcome given = session->command(modbus::Command::OrderEnd, {order->number}); !given)
        return given;
    return print(call, *session);
}

QJsonValue utcOf(qint64 timeMs)
{
    return timeMs == 0 ? QJsonValue()
                       : QJsonValue(QDateTime::fromMSecsSinceEpoch(timeMs).toUTC().toString(Qt::ISODate));
}

// The keys are the headings of the panel's CSV.
QJsonObject objectOf(const store::OrderRow& order)
{
    return {{u"number"_s, order.number},
            {u"controller"_s, order.controller},
            {u"order"_s, order.text},
            {u"lot"_s, order.lot},
            {u"recipe"_s, order.recipe},
            {u"version"_s, order.version},
            {u"table_crc"_s, order.tableCrc == 0
                                 ? QJsonValue()
                                 : QJsonValue(crcText(static_cast<std::uint32_t>(order.tableCrc)))},
            {u"quantity"_s, order.quantity},
            {u"action"_s, store::nameOf(order.action)},
            {u"message_before"_s, order.messageBefore},
            {u"state"_s, store::nameOf(order.state)},
            {u"good"_s, order.good},
            {u"rejected"_s, order.rejected},
            {u"empty"_s, order.empty},
            {u"cut"_s, order.cut},
            {u"started_utc"_s, utcOf(order.startedMs)},
            {u"ended_utc"_s, utcOf(order.endedMs)},
            {u"started_by"_s, order.startedBy},
            {u"checked_by"_s, order.checkedBy}};
}

// Prints the orders of a panel's database, newest first, behind those that wait.
Outcome list(const Invocation& call, const QString& path)
{
    const QTemporaryDir unpacked;
    const auto database = openDatabaseFile(path, unpacked);
    if (!database)
        return tl::unexpected(database.error());
    const auto version = (*database)->version();
    if (version && *version < store::OrderLog::since)
        return fail(ExitCode::File, u"%1 is of a version of CamPanel that kept no orders."_s.arg(path));
    const auto orders = store::orderTable().read(**database, u"ORDER BY id < 0 DESC, id DESC"_s);
    if (!orders)
        return fail(ExitCode::File,
                    u"The orders of %1 cannot be read: %2."_s.arg(path, orders.error().detail));
    if (call.format() == u"csv") {
        store::CsvTable<store::OrderRow> csv(store::orderTable().csvColumns());
        for (const store::OrderRow& order : *orders)
            csv.add(order);
        return call.deliver(csv.bytes());
    }
    QJsonArray rows;
    for (const store::OrderRow& order : *orders)
        rows << objectOf(order);
    if (call.format() == u"json")
        return call.deliver(formatted(QJsonObject{{u"orders"_s, rows}}, call.format()));
    return call.deliver(
        rowsText(rows, {u"state"_s, u"order"_s, u"lot"_s, u"recipe"_s, u"quantity"_s, u"good"_s,
                        u"rejected"_s, u"empty"_s, u"started_utc"_s, u"ended_utc"_s}));
}

// Prints the file of an order that a machine's panel offers to its operator.
Outcome sign(const Invocation& call)
{
    const auto made = orderOf(call);
    if (!made)
        return tl::unexpected(made.error());
    store::OrderRow order;
    order.quantity = made->quantity;
    order.lot = QString::fromStdString(made->lot);
    order.action = static_cast<store::OrderRow::Action>(made->action); // the same numbers
    order.text = call.value(u"order"_s).trimmed();
    order.recipe = call.value(u"recipe"_s).trimmed();
    bool isNumber = false;
    order.messageBefore = call.value(u"message-before"_s).toLongLong(&isNumber);
    if (!isNumber || order.messageBefore < 0 || order.messageBefore > modbus::maxOrderQuantity)
        return fail(ExitCode::Usage, u"--message-before takes a whole number of bags."_s);
    const QString machine = call.value(u"machine"_s).trimmed();
    if (order.text.isEmpty() || machine.isEmpty())
        return fail(ExitCode::Usage,
                    u"--order takes the plant's number of the order, --machine the name of the machine."_s);
    for (const QString& text : {order.text, order.recipe}) {
        if (const QString refusal = panel::OrderWords::textRefusal(text); !refusal.isEmpty())
            return fail(ExitCode::Usage, refusal);
    }
    const auto key = secretKeyOf(call);
    if (!key)
        return tl::unexpected(key.error());
    return call.deliver(store::signOrder(order, machine, QDateTime::currentMSecsSinceEpoch(), *key));
}

Outcome verify(const Invocation& call, const QString& path)
{
    const auto keys = publicKeysOf(call);
    if (!keys)
        return tl::unexpected(keys.error());
    const auto bytes = store::readBytes(path);
    if (!bytes)
        return fail(bytes.error());
    const auto valid = store::verifyOrder(*bytes, path, *keys);
    if (!valid)
        return fail(ExitCode::Refused, store::FileErrorText::describe(valid.error()));
    return call.deliver(formatted(QJsonObject{{u"order"_s, valid->order.text},
                                              {u"lot"_s, valid->order.lot},
                                              {u"recipe"_s, valid->order.recipe},
                                              {u"quantity"_s, valid->order.quantity},
                                              {u"action"_s, store::nameOf(valid->order.action)},
                                              {u"message_before"_s, valid->order.messageBefore},
                                              {u"machine"_s, valid->machine},
                                              {u"signed_by"_s, valid->signer},
                                              {u"signed_utc"_s, utcOf(valid->signedMs)}},
                                  u"json"_s));
}

} // namespace

Outcome runOrder(const Invocation& call)
{
    const QStringList words = call.arguments();
    if (words == QStringList{u"start"_s})
        return start(call);
    if (words == QStringList{u"status"_s})
        return status(call);
    if (words == QStringList{u"end"_s})
        return end(call);
    if (words.size() == 2 && words.first() == u"list")
        return list(call, words.last());
    if (words == QStringList{u"sign"_s})
        return sign(call);
    if (words.size() == 2 && words.first() == u"verify")
        return verify(call, words.last());
    return fail(ExitCode::Usage,
                u"Name what to do: campanelctl order start, status, end, list FILE, sign or verify FILE."_s);
}

} // namespace campanel::cli
