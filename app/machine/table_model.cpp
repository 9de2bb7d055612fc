// SPDX-License-Identifier: Apache-2.0
#include "app/machine/table_model.h"

namespace campanel::machine {

int TableModel::rowCount(const QModelIndex&) const
{
    return 0;
}

QVariant TableModel::data(const QModelIndex&, int) const
{
    return {};
}

QHash<int, QByteArray> TableModel::roleNames() const
{
    return {{RowRole, "row"},
            {TimeTextRole, "timeText"},
            {FrequencyTextRole, "frequencyText"},
            {PulsesTextRole, "pulsesText"},
            {TicksTextRole, "ticksText"},
            {SegmentRole, "segment"}};
}

} // namespace campanel::machine
