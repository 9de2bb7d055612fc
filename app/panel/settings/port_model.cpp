// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/port_model.h"

namespace campanel::panel {

void PortModel::setRows(QList<PortRow> rows)
{
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
    emit countChanged();
}

int PortModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant PortModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const PortRow& row = m_rows[index.row()];
    switch (role) {
    case NameRole:
        return row.name;
    case DescriptionRole:
        return row.description;
    case ProblemRole:
        return row.problem;
    default:
        return {};
    }
}

QHash<int, QByteArray> PortModel::roleNames() const
{
    return {{NameRole, "name"}, {DescriptionRole, "description"}, {ProblemRole, "problem"}};
}

} // namespace campanel::panel
