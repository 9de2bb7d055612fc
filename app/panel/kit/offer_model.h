// SPDX-License-Identifier: Apache-2.0
// A list of items to choose from, such as files and places, with their details.
#pragma once

#include "app/panel/kit/row_model.h"

#include <QString>

namespace campanel::panel {

struct OfferRow {
    Q_GADGET
    Q_PROPERTY(QString title MEMBER title)
    Q_PROPERTY(QString note MEMBER note)
    Q_PROPERTY(QString detail MEMBER detail)
    Q_PROPERTY(bool usable MEMBER usable)

public:
    QString title;
    QString note;       // short, below the title
    QString detail;     // the consequence of choosing it, or why it cannot be chosen
    bool usable = true; // when false, `detail` is the reason

    bool operator==(const OfferRow&) const = default;
};

using OfferModel = RowModel<OfferRow, &OfferRow::title>;

} // namespace campanel::panel
