// SPDX-License-Identifier: Apache-2.0
// The serial ports of this computer, as a list for QML.
#pragma once

#include "app/panel/kit/row_model.h"

#include <QString>

namespace campanel::panel {

struct PortRow {
    Q_GADGET
    Q_PROPERTY(QString name MEMBER name)
    Q_PROPERTY(QString description MEMBER description)
    Q_PROPERTY(QString problem MEMBER problem)

public:
    QString name;        // "/dev/ttyUSB0"
    QString description; // description of the adapter
    QString problem;     // reason why it cannot be used, empty when it can

    bool operator==(const PortRow&) const = default;
};

using PortModel = RowModel<PortRow, &PortRow::name>;

} // namespace campanel::panel
