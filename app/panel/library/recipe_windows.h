// SPDX-License-Identifier: Apache-2.0
// The approved windows of the chosen recipe: a draft of the lowest and highest value of each input, which a
// technician stores with the recipe.
#pragma once

#include "app/panel/kit/value.h"
#include "app/program/recipe.h"

#include <QList>
#include <QObject>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Recipes;

// The window of one input. While it has none, entering one end sets the other to the limit of the input.
class RecipeWindow : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Recipes.windows has them")

    Q_PROPERTY(QString fieldId READ fieldId CONSTANT FINAL)
    Q_PROPERTY(QString label READ label CONSTANT FINAL)
    Q_PROPERTY(QString present READ present CONSTANT FINAL) // the value of the recipe, with its unit
    Q_PROPERTY(campanel::panel::Value* lowest READ lowest CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::Value* highest READ highest CONSTANT FINAL)
    Q_PROPERTY(bool isSet READ isSet NOTIFY changed FINAL)

public:
    RecipeWindow(const program::Recipe& solved, profile::Field field, QObject* parent);

    [[nodiscard]] QString fieldId() const;
    [[nodiscard]] QString label() const;
    [[nodiscard]] QString present() const { return m_present; }
    [[nodiscard]] Value* lowest() { return &m_lowest; }
    [[nodiscard]] Value* highest() { return &m_highest; }
    [[nodiscard]] bool isSet() const { return m_window.has_value(); }
    [[nodiscard]] profile::Field field() const { return m_field; }
    [[nodiscard]] const std::optional<program::ApprovedWindow>& window() const { return m_window; }

    // Removes the window from the draft.
    Q_INVOKABLE void clear();

signals:
    void changed();

private:
    void set(double program::ApprovedWindow::*end, double value);
    void show();

    profile::Field m_field;
    QString m_present;
    std::optional<program::ApprovedWindow> m_window;
    Value m_lowest{this};
    Value m_highest{this};
};

class RecipeWindows : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Recipes.windows is the only one")

    Q_PROPERTY(QVariantList rows READ rows NOTIFY begun FINAL) // list of RecipeWindow*
    // True when the draft differs from the recipe.
    Q_PROPERTY(bool touched READ isTouched NOTIFY changed FINAL)
    // Why the draft cannot be stored; empty: it can.
    Q_PROPERTY(QString problem READ problem NOTIFY changed FINAL)

public:
    // The recipes must outlive the object.
    explicit RecipeWindows(Recipes& recipes);

    [[nodiscard]] QVariantList rows() const;
    [[nodiscard]] bool isTouched() const;
    [[nodiscard]] QString problem() const;
    [[nodiscard]] RecipeWindow* row(profile::Field field) const; // null: it can have no window

    // Begins a draft with the windows of the chosen recipe.
    Q_INVOKABLE void begin();
    // Stores the draft as the next version of its recipe; for technicians.
    Q_INVOKABLE void store();

signals:
    void begun();
    void changed();

private:
    [[nodiscard]] program::ApprovedWindows draft() const;

    Recipes& m_recipes;
    program::Recipe m_recipe; // as it was when the draft began
    QList<RecipeWindow*> m_rows;
};

} // namespace campanel::panel
