// SPDX-License-Identifier: Apache-2.0
// The controller's inputs and outputs, updated while they are watched. The controller counts the edges at its
// pins and sends the counts, not the levels; the list contains nothing else.
#pragma once

#include "app/link/link_values.h"

#include <QAbstractListModel>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;

class IoList : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Inputs and outputs belong to the Service")
    // True while the list is displayed; otherwise nothing is updated.
    Q_PROPERTY(bool watched READ watched WRITE setWatched NOTIFY watchedChanged FINAL)
    // True when all rows are older than a second, or without a connection.
    Q_PROPERTY(bool stale READ stale NOTIFY staleChanged FINAL)

public:
    enum class Side { Input, Output, Fault, Warning };
    Q_ENUM(Side)
    enum class Lamp { None, Off, On, Bad }; // Bad: on, and needs attention
    Q_ENUM(Lamp)
    enum Role { NameRole = Qt::UserRole + 1, ValueRole, SideRole, LampRole };

    struct Row {
        Side side = Side::Input;
        QString name;
        QString value; // empty for a bit, which has only a lamp
        Lamp lamp = Lamp::None;

        bool operator==(const Row&) const = default;
    };

    // The machine must outlive the object.
    IoList(Controller& machine, QObject* parent);

    [[nodiscard]] bool watched() const { return m_timer.isActive(); }
    void setWatched(bool isWatched);
    [[nodiscard]] bool stale() const { return m_isStale; }
    [[nodiscard]] const QList<Row>& rows() const { return m_rows; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

    void retranslate() { look(); }

signals:
    void watchedChanged();
    void staleChanged();

private:
    void look();
    void addAxis(QList<Row>& rows, const modbus::StatusBlock& status) const;
    void addLine(QList<Row>& rows);
    void addBits(QList<Row>& rows, const modbus::StatusBlock& status) const;

    Controller& m_machine;
    QTimer m_timer;
    QList<Row> m_rows;
    bool m_isStale = true;
    double m_marks = 0; // at the last update
    double m_products = 0;
};

} // namespace campanel::panel
