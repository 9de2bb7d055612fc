// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/figure_model.h"

namespace campanel::panel {

void FigureModel::setRows(QList<FigureRow> rows)
{
    if (rows == m_rows)
        return;
    const bool isSameLength = rows.size() == m_rows.size();
    if (!isSameLength)
        beginResetModel();
    m_rows = std::move(rows);
    if (isSameLength)
        emit dataChanged(index(0), index(rowCount() - 1));
    else
        endResetModel();
}

int FigureModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

QVariant FigureModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const FigureRow& row = m_rows[index.row()];
    switch (role) {
    case LabelRole:
        return row.label;
    case ValueRole:
        return row.value;
    case NotableRole:
        return row.isNotable;
    default:
        return {};
    }
}

QHash<int, QByteArray> FigureModel::roleNames() const
{
    return {{LabelRole, "label"}, {ValueRole, "value"}, {NotableRole, "notable"}};
}

} // namespace campanel::panel
