// SPDX-License-Identifier: Apache-2.0
// The step table behind the curves, one row of the controller's table per row.
#pragma once

#include <QAbstractListModel>
#include <QtQml/qqmlregistration.h>

namespace campanel::machine {

class TableModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The table belongs to the Editor")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role {
        RowRole = Qt::UserRole + 1,
        TimeTextRole,
        FrequencyTextRole,
        PulsesTextRole,
        TicksTextRole,
        SegmentRole
    };

    using QAbstractListModel::QAbstractListModel;

    [[nodiscard]] int count() const { return 0; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();
};

} // namespace campanel::machine
