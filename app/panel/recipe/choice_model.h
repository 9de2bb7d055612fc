// SPDX-License-Identifier: Apache-2.0
// The inputs of the recipe that are not numbers, each with its options; the law has its own list.
#pragma once

#include "app/program/recipe.h"

#include <QAbstractListModel>
#include <QList>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class ChoiceModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Choices belong to the Editor")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role { NameRole = Qt::UserRole + 1, ValueTextRole, OptionsRole, OptionRole };

    using QAbstractListModel::QAbstractListModel;

    void show(const program::Recipe& recipe);
    [[nodiscard]] int count() const { return static_cast<int>(m_rows.size()); }
    // Sets the option of a row in the recipe; returns false when there is none.
    bool apply(int row, int option, program::Recipe& recipe) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    struct Row {
        program::Choice choice = program::Choice::Law;
        QString name;
        QStringList options;
        int option = 0;

        bool operator==(const Row&) const = default;
    };

    QList<Row> m_rows;
};

} // namespace campanel::panel
