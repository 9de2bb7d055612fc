// SPDX-License-Identifier: Apache-2.0
// The step table behind the curves, one row of the controller's table per row. Texts are made when they are
// shown.
#pragma once

#include "app/program/program_image.h"

#include <QAbstractListModel>
#include <QtQml/qqmlregistration.h>

#include <memory>
#include <vector>

namespace campanel::machine {

class TableModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The table belongs to the Editor")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role {
        RowRole = Qt::UserRole + 1,
        TimeTextRole, // of the row's beginning
        FrequencyTextRole,
        PulsesTextRole,
        TicksTextRole,
        SegmentRole,
    };

    using QAbstractListModel::QAbstractListModel;

    void setImage(std::shared_ptr<const program::ProgramImage> image);
    [[nodiscard]] int count() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    [[nodiscard]] QString segmentName(double timeS) const;

    std::shared_ptr<const program::ProgramImage> m_image;
    std::vector<double> m_startS;
};

} // namespace campanel::machine
