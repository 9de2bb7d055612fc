// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/difference_model.h"

namespace campanel::panel {

void DifferenceModel::setRows(QList<DifferenceRow> rows)
{
    if (rows == m_rows)
        return;
    const bool otherCount = rows.size() != m_rows.size();
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
    if (otherCount)
        emit countChanged();
}

int DifferenceModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant DifferenceModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const DifferenceRow& row = m_rows[index.row()];
    switch (role) {
    case NameRole:
        return row.name;
    case ActiveTextRole:
        return row.activeText;
    case EditedTextRole:
        return row.editedText;
    default:
        return {};
    }
}

QHash<int, QByteArray> DifferenceModel::roleNames() const
{
    return {{NameRole, "name"}, {ActiveTextRole, "activeText"}, {EditedTextRole, "editedText"}};
}

} // namespace campanel::panel
