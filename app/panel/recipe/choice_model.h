// SPDX-License-Identifier: Apache-2.0
// The inputs of the recipe that are not numbers, each with its options, and its master; law and ratios have
// their own views.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/row_model.h"
#include "app/program/recipe.h"

#include <QStringList>

#include <cstdint>
#include <optional>

namespace campanel::panel {

struct ChoiceRow {
    Q_GADGET
    Q_PROPERTY(QString name MEMBER name)
    Q_PROPERTY(QString valueText READ valueText)
    Q_PROPERTY(QStringList options MEMBER options)
    Q_PROPERTY(int option MEMBER option)
    Q_PROPERTY(QString group MEMBER group)

public:
    std::optional<program::Choice> choice; // none: the master of the recipe
    QString name;
    QString group;
    QStringList options;
    QList<std::uint16_t> codes; // of the options
    int option = 0;

    // Returns the choices of the recipe. What the controller cannot execute is no option, unless selected.
    [[nodiscard]] static QList<ChoiceRow> rows(const program::Recipe& recipe,
                                               const std::optional<modbus::Identity>& controller);
    [[nodiscard]] QString valueText() const { return options.value(option); }
    // Sets an option in the recipe, if there is one with this index.
    void apply(int index, program::Recipe& recipe) const;

    bool operator==(const ChoiceRow&) const = default;
};

using ChoiceModel = RowModel<ChoiceRow, &ChoiceRow::choice>;

} // namespace campanel::panel
