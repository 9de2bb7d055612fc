// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/law_model.h"

namespace campanel::panel {

void LawModel::setRows(QList<LawRow> rows)
{
    if (rows.size() != m_rows.size()) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
        emit countChanged();
        return;
    }
    // Only changed rows are updated, so that the scroll position stays.
    for (qsizetype row = 0; row < rows.size(); ++row) {
        if (m_rows[row] == rows[row])
            continue;
        m_rows[row] = rows[row];
        const QModelIndex changed = index(static_cast<int>(row));
        emit dataChanged(changed, changed);
    }
}

int LawModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant LawModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const LawRow& row = m_rows[index.row()];
    switch (role) {
    case LawIdRole:
        return row.lawId;
    case NameRole:
        return row.name;
    case StrengthRole:
        return row.strength;
    case WeaknessRole:
        return row.weakness;
    case PeakRpmTextRole:
        return row.peakRpmText;
    case PeakAccelerationTextRole:
        return row.peakAccelerationText;
    case PeakFrequencyTextRole:
        return row.peakFrequencyText;
    case PeakJerkTextRole:
        return row.peakJerkText;
    case CurrentRole:
        return row.current;
    case UsableRole:
        return row.usable;
    case ComparedRole:
        return row.compared;
    default:
        return {};
    }
}

QHash<int, QByteArray> LawModel::roleNames() const
{
    return {{LawIdRole, "lawId"},
            {NameRole, "name"},
            {StrengthRole, "strength"},
            {WeaknessRole, "weakness"},
            {PeakRpmTextRole, "peakRpmText"},
            {PeakAccelerationTextRole, "peakAccelerationText"},
            {PeakFrequencyTextRole, "peakFrequencyText"},
            {PeakJerkTextRole, "peakJerkText"},
            {CurrentRole, "current"},
            {UsableRole, "usable"},
            {ComparedRole, "compared"}};
}

} // namespace campanel::panel
