// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/table_model.h"

#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/table_text.h"

namespace campanel::panel {

TableModel::TableModel(QObject* parent)
    : QAbstractListModel(parent)
{
    LanguageNotifier::follow(this, [this] { setImage(m_image); });
}

void TableModel::setImage(std::shared_ptr<const program::ProgramImage> image)
{
    beginResetModel();
    m_image = std::move(image);
    m_startS = m_image ? TableText(*m_image).startsS() : std::vector<double>();
    endResetModel();
    emit columnsChanged();
}

int TableModel::count() const
{
    return static_cast<int>(m_startS.size());
}

QString TableModel::name() const
{
    return m_image ? TableText(*m_image).name() : QString();
}

QStringList TableModel::columns() const
{
    return m_image ? TableText(*m_image).columns() : QStringList();
}

QStringList TableModel::summary() const
{
    return m_image ? TableText(*m_image).summary() : QStringList();
}

int TableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : count();
}

QVariant TableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || role != CellsRole)
        return {};
    const auto row = static_cast<std::size_t>(index.row());
    return TableText(*m_image).cells(row, m_startS[row]);
}

QHash<int, QByteArray> TableModel::roleNames() const
{
    return {{CellsRole, "cells"}};
}

} // namespace campanel::panel
