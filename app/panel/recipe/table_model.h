// SPDX-License-Identifier: Apache-2.0
// The table behind the curves, one row of the controller's table per row, in the columns of its kind. Texts
// are created on demand.
#pragma once

#include "app/program/program_image.h"

#include <QAbstractListModel>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <memory>
#include <vector>

namespace campanel::panel {

class TableModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The table belongs to the Editor")
    Q_PROPERTY(int count READ count NOTIFY columnsChanged FINAL)
    Q_PROPERTY(QString name READ name NOTIFY columnsChanged FINAL)
    Q_PROPERTY(QStringList columns READ columns NOTIFY columnsChanged FINAL)
    Q_PROPERTY(QStringList summary READ summary NOTIFY columnsChanged FINAL)

public:
    enum Role { CellsRole = Qt::UserRole + 1 };

    explicit TableModel(QObject* parent = nullptr);

    void setImage(std::shared_ptr<const program::ProgramImage> image);
    [[nodiscard]] int count() const;
    [[nodiscard]] QString name() const;
    [[nodiscard]] QStringList columns() const;
    [[nodiscard]] QStringList summary() const; // sentences

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void columnsChanged();

private:
    std::shared_ptr<const program::ProgramImage> m_image;
    std::vector<double> m_startS; // start of each row
};

} // namespace campanel::panel
