// SPDX-License-Identifier: Apache-2.0
#include "app/panel/library/recipe_list.h"

#include <algorithm>

namespace campanel::panel {

void RecipeList::setRows(QList<RecipeRow> rows)
{
    if (rows == m_rows)
        return;
    const bool isSameOrder = std::ranges::equal(rows, m_rows, {}, &RecipeRow::id, &RecipeRow::id);
    if (!isSameOrder)
        beginResetModel();
    m_rows = std::move(rows);
    if (isSameOrder) {
        emit dataChanged(index(0), index(rowCount() - 1));
    } else {
        endResetModel();
        emit countChanged();
    }
}

int RecipeList::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

QVariant RecipeList::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const RecipeRow& row = m_rows[index.row()];
    switch (role) {
    case NameRole:
        return row.name;
    case VersionRole:
        return row.version;
    case SummaryRole:
        return row.summary;
    case SavedTextRole:
        return row.savedText;
    case OpenRole:
        return row.isOpen;
    case ActiveRole:
        return row.isActive;
    default:
        return {};
    }
}

QHash<int, QByteArray> RecipeList::roleNames() const
{
    return {{NameRole, "name"},           {VersionRole, "version"}, {SummaryRole, "summary"},
            {SavedTextRole, "savedText"}, {OpenRole, "isOpen"},     {ActiveRole, "isActive"}};
}

} // namespace campanel::panel
