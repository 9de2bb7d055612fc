// SPDX-License-Identifier: Apache-2.0
// The codes of the chosen recipe: the one that selects it when it is scanned, and that of its film reel.
#pragma once

#include "app/program/recipe.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Recipes;

class RecipeCodes : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Recipes.codes is the only one")

    // The code that selects the chosen recipe, and that of its film reel in words.
    Q_PROPERTY(QString scanText READ scanText NOTIFY changed FINAL)
    Q_PROPERTY(QString filmText READ filmText NOTIFY changed FINAL)
    // The code being entered, and the reason why it is not available; empty when it is.
    Q_PROPERTY(Code code READ code NOTIFY wantedChanged FINAL)
    Q_PROPERTY(QString wanted READ wanted WRITE setWanted NOTIFY wantedChanged FINAL)
    Q_PROPERTY(QString problem READ problem NOTIFY wantedChanged FINAL)

public:
    enum class Code { Recipe, Film };
    Q_ENUM(Code)

    // The recipes must outlive the object.
    explicit RecipeCodes(Recipes& recipes);

    [[nodiscard]] QString scanText() const;
    [[nodiscard]] QString filmText() const;
    [[nodiscard]] Code code() const { return m_code; }
    [[nodiscard]] QString wanted() const { return m_wanted; }
    void setWanted(const QString& code);
    [[nodiscard]] QString problem() const;

    // Begins the entry with the present code.
    Q_INVOKABLE void enter(campanel::panel::RecipeCodes::Code code);
    // Stores the wanted code, which must have no problem; for technicians.
    Q_INVOKABLE void store();

signals:
    void changed();
    void wantedChanged();

private:
    [[nodiscard]] QString formProblem() const;
    [[nodiscard]] program::Recipe withWanted(program::Recipe recipe) const;

    Recipes& m_recipes;
    Code m_code = Code::Recipe;
    QString m_wanted;
};

} // namespace campanel::panel
