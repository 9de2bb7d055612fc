// SPDX-License-Identifier: Apache-2.0
// The changes of a download: one row for each number that differs between controller and editor.
#pragma once

#include <QAbstractListModel>
#include <QList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

struct DifferenceRow {
    QString name;
    QString activeText;
    QString editedText;

    bool operator==(const DifferenceRow&) const = default;
};

class DifferenceModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Differences belong to the Editor")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role { NameRole = Qt::UserRole + 1, ActiveTextRole, EditedTextRole };

    using QAbstractListModel::QAbstractListModel;

    void setRows(QList<DifferenceRow> rows);
    [[nodiscard]] const QList<DifferenceRow>& rows() const { return m_rows; }
    [[nodiscard]] int count() const { return static_cast<int>(m_rows.size()); }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    QList<DifferenceRow> m_rows;
};

} // namespace campanel::panel
