// SPDX-License-Identifier: Apache-2.0
// The recipes of the panel as a list, filtered by a search.
#pragma once

#include <QAbstractListModel>
#include <QList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

struct RecipeRow {
    qint64 id = 0;
    QString name;
    int version = 0;
    QString summary;       // "250.0 mm · 60.0 bags/min"
    QString savedText;     // time and author
    bool isOpen = false;   // being edited
    bool isActive = false; // active in the controller

    bool operator==(const RecipeRow&) const = default;
};

class RecipeList : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The list belongs to the Recipes")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role { NameRole = Qt::UserRole + 1, VersionRole, SummaryRole, SavedTextRole, OpenRole, ActiveRole };

    using QAbstractListModel::QAbstractListModel;

    void setRows(QList<RecipeRow> rows);
    [[nodiscard]] const QList<RecipeRow>& rows() const { return m_rows; }
    [[nodiscard]] int count() const { return static_cast<int>(m_rows.size()); }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    QList<RecipeRow> m_rows;
};

} // namespace campanel::panel
