// SPDX-License-Identifier: Apache-2.0
// `Orders.entry` in QML: the form of a new order. It changes nothing before Orders.add() takes it.
#pragma once

#include "app/panel/kit/value.h"
#include "app/store/logs/order_log.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class OrderEntry : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Orders.entry is the only one")
    Q_PROPERTY(campanel::panel::Value* quantity READ quantity CONSTANT FINAL)
    // So many bags before the end comes the message.
    Q_PROPERTY(campanel::panel::Value* messageBefore READ messageBefore CONSTANT FINAL)
    Q_PROPERTY(QString text READ text WRITE setText NOTIFY changed FINAL)
    Q_PROPERTY(QString lot READ lot WRITE setLot NOTIFY changed FINAL)
    Q_PROPERTY(QString recipe READ recipe WRITE setRecipe NOTIFY changed FINAL) // empty: any
    Q_PROPERTY(QString checkedBy READ checkedBy WRITE setCheckedBy NOTIFY changed FINAL)
    Q_PROPERTY(int action READ action WRITE setAction NOTIFY changed FINAL) // an Action
    // True once something was entered.
    Q_PROPERTY(bool touched READ touched NOTIFY changed FINAL)
    // Why it is no order yet; empty: it is one.
    Q_PROPERTY(QString problem READ problem NOTIFY changed FINAL)

public:
    enum Action { None, Message, Stop };
    Q_ENUM(Action)

    explicit OrderEntry(QObject* parent);

    // Empties the form, for this recipe.
    Q_INVOKABLE void begin(const QString& recipe);
    // Return why this cannot be the lot, the order or a name; empty: it can.
    [[nodiscard]] Q_INVOKABLE QString lotProblem(const QString& lot) const;
    [[nodiscard]] Q_INVOKABLE QString textProblem(const QString& text) const;

    [[nodiscard]] Value* quantity() { return &m_quantity; }
    [[nodiscard]] Value* messageBefore() { return &m_messageBefore; }
    [[nodiscard]] QString text() const { return m_order.text; }
    void setText(const QString& text);
    [[nodiscard]] QString lot() const { return m_order.lot; }
    void setLot(const QString& lot);
    [[nodiscard]] QString recipe() const { return m_order.recipe; }
    void setRecipe(const QString& recipe);
    [[nodiscard]] QString checkedBy() const { return m_order.checkedBy; }
    void setCheckedBy(const QString& name);
    [[nodiscard]] int action() const { return static_cast<int>(m_order.action); }
    void setAction(int action);
    [[nodiscard]] bool touched() const;
    [[nodiscard]] QString problem() const;
    [[nodiscard]] const store::OrderRow& order() const { return m_order; }

signals:
    void changed();

private:
    void update();

    Value m_quantity{this};
    Value m_messageBefore{this};
    store::OrderRow m_order;
    store::OrderRow m_first; // at the begin
};

} // namespace campanel::panel
