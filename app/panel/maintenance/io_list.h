// SPDX-License-Identifier: Apache-2.0
// The controller's inputs and outputs, updated while they are watched: what the status and the packing line
// report, and the levels of the pins where the controller has them.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/controller/io_pins.h"
#include "app/panel/kit/row_model.h"
#include "app/panel/kit/watched.h"

#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;

namespace Io {
Q_NAMESPACE
QML_ELEMENT
enum class Side { Input, Output, Fault, Warning };
Q_ENUM_NS(Side)
enum class Lamp { None, Off, On, Warning, Bad }; // Warning, Bad: on, in the color of the alarm
Q_ENUM_NS(Lamp)
} // namespace Io

struct IoRow {
    Q_GADGET
    Q_PROPERTY(QString name MEMBER name)
    Q_PROPERTY(QString value MEMBER value)
    Q_PROPERTY(QString purpose MEMBER purpose)
    Q_PROPERTY(int output MEMBER output)
    Q_PROPERTY(campanel::panel::Io::Side side MEMBER side)
    Q_PROPERTY(campanel::panel::Io::Lamp lamp MEMBER lamp)

public:
    Io::Side side = Io::Side::Input;
    QString name{};
    QString value{}; // empty for a bit, which has only a lamp
    Io::Lamp lamp = Io::Lamp::None;
    QString purpose{}; // what a pin does, in a sentence
    int output = -1;   // the bit of an output that can be tried

    bool operator==(const IoRow&) const = default;
};

class IoList : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Inputs and outputs belong to Maintenance")
    // True when all rows are older than a second, or without a connection.
    Q_PROPERTY(bool stale READ stale NOTIFY staleChanged FINAL)
    // True when the controller reports the levels of its pins and has cam switches.
    Q_PROPERTY(bool hasPins READ hasPins NOTIFY hasPinsChanged FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)

public:
    using Side = Io::Side;
    using Lamp = Io::Lamp;
    using Row = IoRow;
    using Rows = RowModel<IoRow, &IoRow::name>;

    // The controller must outlive the object.
    IoList(Controller& controller, QObject* parent);

    [[nodiscard]] bool stale() const { return m_isStale; }
    [[nodiscard]] bool hasPins() const { return m_pins.present(); }
    [[nodiscard]] Rows* rows() { return &m_rows; }

    void retranslate() { refresh(); }

signals:
    void staleChanged();
    void hasPinsChanged();

private:
    void refresh();
    void showRows();
    void addAxis(QList<Row>& rows, const modbus::StatusBlock& status) const;
    void addLine(QList<Row>& rows);
    void addPins(QList<Row>& rows, const modbus::IoStatus& pins) const;
    static void addPin(QList<Row>& rows, const Row& pin, std::optional<bool> level, const QString& purpose,
                       Lamp lit);
    void addDrives(QList<Row>& rows, const modbus::IoStatus& pins) const;
    void addBits(QList<Row>& rows, const modbus::StatusBlock& status) const;

    Controller& m_controller;
    IoPins m_pins;
    Rows m_rows{this};
    bool m_isStale = true;
    double m_marks = 0; // at the last update
    double m_products = 0;
};

} // namespace campanel::panel
