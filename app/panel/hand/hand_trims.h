// SPDX-License-Identifier: Apache-2.0
// `HandTrims` in QML: where an operator wants cut and product to lie, and how long a bag is to be, against
// the program of a packing machine. They act at once and belong to the recipe.
#pragma once

#include "app/panel/hand/hand_value.h"
#include "app/panel/kit/row_model.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/kit/watched.h"
#include "app/program/recipe_trims.h"
#include "app/store/logs/audit_log.h"

#include <QList>
#include <QtQml/qqmlregistration.h>

#include <array>
#include <functional>
#include <optional>
#include <utility>

namespace campanel::panel {

class Controller;
class Parameter;

struct TrimRow {
    Q_GADGET
    Q_PROPERTY(int trim MEMBER trim)
    Q_PROPERTY(QString title MEMBER title)
    Q_PROPERTY(QString amount MEMBER amount) // "2.0 mm earlier"
    // The texts of the keys; the film runs to the right, so that the right one is earlier, forward or longer.
    Q_PROPERTY(QString leftText MEMBER leftText)
    Q_PROPERTY(QString rightText MEMBER rightText)
    Q_PROPERTY(bool canLeft MEMBER canLeft)
    Q_PROPERTY(bool canRight MEMBER canRight)
    Q_PROPERTY(QString note MEMBER note) // why a key is off; empty: both act
    Q_PROPERTY(bool canReset MEMBER canReset)

public:
    int trim = 0;
    QString title;
    QString amount;
    QString leftText;
    QString rightText;
    QString note;
    bool canLeft = false;
    bool canRight = false;
    bool canReset = false;

    bool operator==(const TrimRow&) const = default;
};

using TrimRows = RowModel<TrimRow, &TrimRow::trim>;

class HandTrims : public campanel::panel::Watched, public Singleton<HandTrims> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // True with a packing machine's program in a controller that has trims.
    Q_PROPERTY(bool offered READ offered NOTIFY changed FINAL)
    // The same, and stays true while the line is away.
    Q_PROPERTY(bool present READ present NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    // In the order of the rows, mm; 0 while one is unknown.
    Q_PROPERTY(QList<double> mm READ mm NOTIFY changed FINAL)
    Q_PROPERTY(bool moved READ moved NOTIFY changed FINAL)     // any of them is not 0
    Q_PROPERTY(bool unsaved READ unsaved NOTIFY changed FINAL) // they are not those of the recipe
    Q_PROPERTY(QString stepText READ stepText NOTIFY changed FINAL)
    // Why the last touch has not reached the controller; empty: it has.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)

public:
    // The controller must outlive the object.
    HandTrims(Controller& controller, QObject* parent);

    [[nodiscard]] bool offered() const;
    [[nodiscard]] bool present() const { return m_isPresent; }
    [[nodiscard]] TrimRows* rows() { return &m_rows; }
    [[nodiscard]] QList<double> mm() const;
    [[nodiscard]] bool moved() const;
    [[nodiscard]] bool unsaved() const;
    [[nodiscard]] QString stepText() const;
    [[nodiscard]] QString message() const;

    // Sets where the saved trims of a recipe are found; empty: it is not among the recipes of this panel.
    using Saved = std::function<std::optional<program::Trims>(const QString& recipe)>;
    void setSaved(Saved saved) { m_saved = std::move(saved); }
    // Shows them again after a change of the recipes.
    void update();

    // Move a row by one step, and back to 0. For operators.
    Q_INVOKABLE void left(int row);
    Q_INVOKABLE void right(int row);
    Q_INVOKABLE void reset(int row);
    // Has the controller keep the trims over a power cut, and emits saveWanted(). For operators.
    Q_INVOKABLE void save();

signals:
    void changed();
    // The trims are to be saved with the recipe of this name.
    void saveWanted(const QString& recipe, const campanel::program::Trims& trims);
    // Emitted for the audit trail, once behind the last touch of a row.
    void noted(const campanel::store::AuditEntry& entry);

private:
    [[nodiscard]] bool hasPacker() const;
    [[nodiscard]] bool isTooOld() const;
    void moveTo(int row, double mm);
    [[nodiscard]] double stepMm() const;
    [[nodiscard]] QString blockedText(program::Trim trim) const;
    [[nodiscard]] TrimRow row(program::Trim trim) const;
    [[nodiscard]] HandValue& value(program::Trim trim) { return m_values[static_cast<std::size_t>(trim)]; }
    [[nodiscard]] const HandValue& value(program::Trim trim) const
    {
        return m_values[static_cast<std::size_t>(trim)];
    }

    Controller& m_controller;
    Parameter& m_place; // of the encoder
    std::array<HandValue, program::trimCount> m_values;
    TrimRows m_rows{this};
    Saved m_saved;
    bool m_isPresent = false;
};

} // namespace campanel::panel
