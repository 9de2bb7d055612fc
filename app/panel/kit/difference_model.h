// SPDX-License-Identifier: Apache-2.0
// The changes of a download: one row for each number that differs between controller and editor.
#pragma once

#include "app/panel/kit/row_model.h"

#include <QString>

namespace campanel::panel {

struct DifferenceRow {
    Q_GADGET
    Q_PROPERTY(QString name MEMBER name)
    Q_PROPERTY(QString activeText MEMBER activeText)
    Q_PROPERTY(QString editedText MEMBER editedText)

public:
    QString name;
    QString activeText;
    QString editedText;

    bool operator==(const DifferenceRow&) const = default;
};

using DifferenceModel = RowModel<DifferenceRow, &DifferenceRow::name>;

} // namespace campanel::panel
