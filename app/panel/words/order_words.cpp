// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/order_words.h"

#include "app/link/link_values.h"
#include "app/panel/kit/format.h"
#include "app/store/database/names.h"

using namespace Qt::StringLiterals;

namespace campanel::panel {

using store::OrderRow;

namespace {

QString minuteOf(qint64 utcMs, const QDate& today)
{
    const QDateTime local = QDateTime::fromMSecsSinceEpoch(utcMs);
    return local.date() == today ? Format::local(local, u"HH:mm"_s) : Format::minute(local);
}

} // namespace

QString OrderWords::state(OrderRow::State state)
{
    switch (state) {
    case OrderRow::State::Queued:
        return tr("Queued");
    case OrderRow::State::Active:
        return tr("Under way");
    case OrderRow::State::Complete:
        return tr("Complete");
    case OrderRow::State::Ended:
        return tr("Ended early");
    case OrderRow::State::Lost:
        break;
    }
    return tr("Lost");
}

QString OrderWords::count(qint64 bags)
{
    QLocale locale = Format().locale();
    locale.setNumberOptions(QLocale::DefaultNumberOptions);
    return locale.toString(bags);
}

QString OrderWords::action(OrderRow::Action action, qint64 messageBefore)
{
    switch (action) {
    case OrderRow::Action::None:
        return tr("The run goes on");
    case OrderRow::Action::Message:
        return tr("Message %1 bags before the end").arg(count(messageBefore));
    case OrderRow::Action::Stop:
        break;
    }
    return tr("The run stops");
}

QString OrderWords::title(const OrderRow& order)
{
    QStringList parts;
    for (const QString& part : {order.text, order.lot}) {
        if (!part.isEmpty())
            parts << part;
    }
    if (!parts.isEmpty())
        return parts.join(u" · "_s);
    return order.number > 0 ? tr("Order %1").arg(order.number) : tr("Order");
}

QString OrderWords::progress(const OrderRow& order)
{
    return tr("%1 of %2", "good bags of an order").arg(count(order.good), count(order.quantity));
}

QString OrderWords::recipe(const OrderRow& order)
{
    return order.version > 0 ? u"%1 · v%2"_s.arg(order.recipe, QString::number(order.version)) : order.recipe;
}

QString OrderWords::facts(const OrderRow& order, const QDate& today)
{
    const QString end = order.endedMs > 0 ? minuteOf(order.endedMs, today) : QString();
    QStringList parts;
    if (order.startedMs > 0) {
        const QString begin = minuteOf(order.startedMs, today);
        parts << (end.isEmpty() ? tr("since %1").arg(begin) : tr("%1 to %2", "times").arg(begin, end));
    }
    if (!order.recipe.isEmpty())
        parts << recipe(order);
    if (order.filmMm > 0)
        parts << tr("%1 m of film").arg(count((order.filmMm + 500) / 1000));
    if (order.startedMs > 0 && !order.startedBy.isEmpty())
        parts << tr("started by %1").arg(order.startedBy);
    if (!order.checkedBy.isEmpty())
        parts << tr("first bag checked by %1").arg(order.checkedBy);
    return parts.join(u" · "_s);
}

QString OrderWords::lotRefusal(const QString& lot)
{
    if (store::hiddenCharacter(lot))
        return tr("The lot has a character that nobody sees. Enter one line of visible characters.");
    constexpr int maxBytes = 2 * modbus::orderLotRegisters;
    const qsizetype bytes = lot.toUtf8().size();
    return bytes <= maxBytes ? QString()
                             : tr("The lot is too long: %1 bytes, at most %2 fit. A letter of another script "
                                  "has two or more.")
                                   .arg(QString::number(bytes), QString::number(maxBytes));
}

QString OrderWords::textRefusal(const QString& text)
{
    if (store::hiddenCharacter(text))
        return tr("The text has a character that nobody sees. Enter one line of visible characters.");
    return text.size() <= maxTextLength
               ? QString()
               : tr("The text is too long: %1 characters, at most %2 fit.")
                     .arg(QString::number(text.size()), QString::number(maxTextLength));
}

QString OrderWords::tooOld(int mapMajor, int mapMinor)
{
    return tr("This controller counts no orders: its register map is %1, orders need %2.")
        .arg(u"%1.%2"_s.arg(QString::number(mapMajor), QString::number(mapMinor)),
             u"%1.%2"_s.arg(QString::number(modbus::mapMajor), QString::number(modbus::orderMapMinor)));
}

} // namespace campanel::panel
