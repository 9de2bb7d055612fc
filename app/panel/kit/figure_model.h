// SPDX-License-Identifier: Apache-2.0
// Named figures as a list: name, value, and a mark for unusual values.
#pragma once

#include <QAbstractListModel>
#include <QList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

struct FigureRow {
    QString label;
    QString value;
    bool isNotable = false;

    bool operator==(const FigureRow&) const = default;
};

class FigureModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Figures belong to what counts them")

public:
    enum Role { LabelRole = Qt::UserRole + 1, ValueRole, NotableRole };

    using QAbstractListModel::QAbstractListModel;

    void setRows(QList<FigureRow> rows);
    [[nodiscard]] const QList<FigureRow>& rows() const { return m_rows; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

private:
    QList<FigureRow> m_rows;
};

} // namespace campanel::panel
