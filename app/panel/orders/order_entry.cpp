// SPDX-License-Identifier: Apache-2.0
#include "app/panel/orders/order_entry.h"

#include "app/link/link_values.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/order_words.h"

#include <algorithm>

namespace campanel::panel {

using store::OrderRow;

namespace {

constexpr qint64 usualMessageBefore = 20; // bags

} // namespace

OrderEntry::OrderEntry(QObject* parent)
    : QObject(parent)
{
    for (Value* value : {&m_quantity, &m_messageBefore})
        value->setNeededLevel(Level::Operator);
    connect(&m_quantity, &Value::setRequested, this, [this](double bags) {
        m_order.quantity = static_cast<qint64>(bags);
        update();
    });
    connect(&m_messageBefore, &Value::setRequested, this, [this](double bags) {
        m_order.messageBefore = static_cast<qint64>(bags);
        update();
    });
    LanguageNotifier::follow(this, [this] { update(); });
    begin({});
}

void OrderEntry::begin(const QString& recipe)
{
    m_order = {};
    m_order.recipe = recipe;
    m_order.messageBefore = usualMessageBefore;
    m_first = m_order;
    update();
}

void OrderEntry::update()
{
    const auto show = [](Value& value, const QString& label, qint64 bags) {
        value.show({.label = label,
                    .unit = tr("bags"),
                    .text = bags > 0 ? OrderWords::count(bags) : Format::unknownText(),
                    .minimum = 1,
                    .maximum = modbus::maxOrderQuantity,
                    .defaultValue = static_cast<double>(std::max<qint64>(bags, 1)),
                    .value = static_cast<double>(bags)});
    };
    show(m_quantity, tr("Quantity"), m_order.quantity);
    show(m_messageBefore, tr("Message before the end"), m_order.messageBefore);
    emit changed();
}

QString OrderEntry::lotProblem(const QString& lot) const
{
    return OrderWords::lotRefusal(lot.trimmed());
}

QString OrderEntry::textProblem(const QString& text) const
{
    return OrderWords::textRefusal(text.trimmed());
}

void OrderEntry::setText(const QString& text)
{
    m_order.text = text.trimmed();
    update();
}

void OrderEntry::setLot(const QString& lot)
{
    m_order.lot = lot.trimmed();
    update();
}

void OrderEntry::setRecipe(const QString& recipe)
{
    m_order.recipe = recipe;
    update();
}

void OrderEntry::setCheckedBy(const QString& name)
{
    m_order.checkedBy = name.trimmed();
    update();
}

void OrderEntry::setAction(int action)
{
    m_order.action = static_cast<OrderRow::Action>(std::clamp<int>(action, None, Stop));
    update();
}

bool OrderEntry::touched() const
{
    return m_order != m_first;
}

QString OrderEntry::problem() const
{
    for (const QString& problem :
         {textProblem(m_order.text), lotProblem(m_order.lot), textProblem(m_order.checkedBy)}) {
        if (!problem.isEmpty())
            return problem;
    }
    return m_order.quantity > 0 ? QString() : tr("Enter how many good bags to make.");
}

} // namespace campanel::panel
