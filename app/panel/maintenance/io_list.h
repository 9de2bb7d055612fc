// SPDX-License-Identifier: Apache-2.0
// What the controller tells of its inputs and outputs, live, while somebody looks. It counts what comes in at
// its pins and tells the counts, not the levels; nothing else is shown.
#pragma once

#include "app/link/link_values.h"

#include <QAbstractListModel>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

namespace campanel::machine {

class Machine;

class IoList : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Inputs and outputs belong to the Service")
    // While it is false nothing is updated.
    Q_PROPERTY(bool watched READ watched WRITE setWatched NOTIFY watchedChanged FINAL)
    // All rows are older than a second, or of no connection.
    Q_PROPERTY(bool stale READ stale NOTIFY staleChanged FINAL)

public:
    enum class Side { Input, Output, Fault, Warning };
    Q_ENUM(Side)
    enum class Lamp { None, Off, On, Bad }; // Bad: on, and worth a look
    Q_ENUM(Lamp)
    enum Role { NameRole = Qt::UserRole + 1, ValueRole, SideRole, LampRole };

    struct Row {
        Side side = Side::Input;
        QString name;
        QString value; // empty for a bit: its lamp is all
        Lamp lamp = Lamp::None;

        bool operator==(const Row&) const = default;
    };

    // The machine must outlive it.
    IoList(Machine& machine, QObject* parent);

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

    Machine& m_machine;
    QTimer m_timer;
    QList<Row> m_rows;
    bool m_isStale = true;
    double m_marks = 0; // at the last look
    double m_products = 0;
};

} // namespace campanel::machine
