// SPDX-License-Identifier: Apache-2.0
// A list of items to choose from, such as files and places, with their details.
#pragma once

#include <QAbstractListModel>
#include <QList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

struct OfferRow {
    QString title;
    QString note;       // short, below the title
    QString detail;     // the consequence of choosing it, or why it cannot be chosen
    bool usable = true; // when false, `detail` is the reason

    bool operator==(const OfferRow&) const = default;
};

class OfferModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Offers belong to what makes them")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role { TitleRole = Qt::UserRole + 1, NoteRole, DetailRole, UsableRole };

    using QAbstractListModel::QAbstractListModel;

    void setRows(QList<OfferRow> rows);
    [[nodiscard]] int count() const { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] const QList<OfferRow>& rows() const { return m_rows; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    QList<OfferRow> m_rows;
};

} // namespace campanel::panel
