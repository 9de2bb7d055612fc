// SPDX-License-Identifier: Apache-2.0
// Named figures as a list: name, value, and a mark for unusual values.
#pragma once

#include "app/panel/kit/row_model.h"

#include <QString>

namespace campanel::panel {

struct FigureRow {
    Q_GADGET
    Q_PROPERTY(QString label MEMBER label)
    Q_PROPERTY(QString value MEMBER value)
    Q_PROPERTY(bool notable MEMBER isNotable)

public:
    QString label;
    QString value;
    bool isNotable = false;

    bool operator==(const FigureRow&) const = default;
};

using FigureModel = RowModel<FigureRow, &FigureRow::label>;

} // namespace campanel::panel
