// SPDX-License-Identifier: Apache-2.0
// The serial ports of this computer, as a list for QML.
#pragma once

#include <QAbstractListModel>
#include <QList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

struct PortRow {
    QString name;        // "/dev/ttyUSB0"
    QString description; // description of the adapter
    QString problem;     // reason why it cannot be used, empty when it can
};

class PortModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Ports belong to Settings")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role { NameRole = Qt::UserRole + 1, DescriptionRole, ProblemRole };

    using QAbstractListModel::QAbstractListModel;

    void setRows(QList<PortRow> rows);
    [[nodiscard]] int count() const { return static_cast<int>(m_rows.size()); }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    QList<PortRow> m_rows;
};

} // namespace campanel::panel
