// SPDX-License-Identifier: Apache-2.0
#include "app/panel/kit/offer_model.h"

namespace campanel::panel {

void OfferModel::setRows(QList<OfferRow> rows)
{
    if (rows == m_rows)
        return; // the scroll position stays
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
    emit countChanged();
}

int OfferModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant OfferModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const OfferRow& row = m_rows[index.row()];
    switch (role) {
    case TitleRole:
        return row.title;
    case NoteRole:
        return row.note;
    case DetailRole:
        return row.detail;
    case UsableRole:
        return row.usable;
    default:
        return {};
    }
}

QHash<int, QByteArray> OfferModel::roleNames() const
{
    return {{TitleRole, "title"}, {NoteRole, "note"}, {DetailRole, "detail"}, {UsableRole, "usable"}};
}

} // namespace campanel::panel
