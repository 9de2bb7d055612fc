// SPDX-License-Identifier: Apache-2.0
// The speed laws with their demands on the machine for the recipe being edited.
#pragma once

#include <QAbstractListModel>
#include <QList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

struct LawRow {
    QString lawId;
    QString name;
    QString strength; // one sentence each
    QString weakness;
    QString peakRpmText;
    QString peakAccelerationText;
    QString peakFrequencyText;
    QString peakJerkText;
    bool current = false;
    bool usable = false;   // exceeds no limit with this recipe
    bool compared = false; // its curves are in the background

    bool operator==(const LawRow&) const = default;
};

class LawModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Laws belong to the Editor")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role {
        LawIdRole = Qt::UserRole + 1,
        NameRole,
        StrengthRole,
        WeaknessRole,
        PeakRpmTextRole,
        PeakAccelerationTextRole,
        PeakFrequencyTextRole,
        PeakJerkTextRole,
        CurrentRole,
        UsableRole,
        ComparedRole,
    };

    using QAbstractListModel::QAbstractListModel;

    void setRows(QList<LawRow> rows);
    [[nodiscard]] int count() const { return static_cast<int>(m_rows.size()); }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    QList<LawRow> m_rows;
};

} // namespace campanel::panel
