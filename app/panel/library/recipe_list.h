// SPDX-License-Identifier: Apache-2.0
// The recipes of the panel as a list, filtered by a search.
#pragma once

#include "app/panel/kit/row_model.h"
#include "app/panel/recipe/curve_shape.h"

#include <QString>

namespace campanel::panel {

struct RecipeRow {
    Q_GADGET
    Q_PROPERTY(QString name MEMBER name)
    Q_PROPERTY(int version MEMBER version)
    Q_PROPERTY(QString summary MEMBER summary)
    Q_PROPERTY(QString savedText MEMBER savedText)
    Q_PROPERTY(bool isOpen MEMBER isOpen)
    Q_PROPERTY(bool isActive MEMBER isActive)
    Q_PROPERTY(QList<QPointF> shape MEMBER shape)

public:
    qint64 id = 0;
    QString name;
    int version = 0;
    QString summary;       // "250.0 mm · 60.0 bags/min"
    QString savedText;     // time and author
    bool isOpen = false;   // being edited
    bool isActive = false; // active in the controller
    CurveShape shape;

    bool operator==(const RecipeRow&) const = default;
};

using RecipeList = RowModel<RecipeRow, &RecipeRow::id>;

} // namespace campanel::panel
