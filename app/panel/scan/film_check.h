// SPDX-License-Identifier: Apache-2.0
// The scanned film reel against the one that the program in the controller needs. A wrong reel blocks Start
// until the right one is scanned or a technician overrides the check with a reason. The reel stays on the
// machine when the program changes: it is compared with the new one's. The demand belongs to the program,
// whatever becomes of its recipe in the library: it is taken once, when the program is downloaded or first
// seen. While the recipe of a program is unknown, the last demand stays.
#pragma once

#include "app/store/logs/audit_log.h"
#include "app/store/recipes/recipe_library.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;
class Recipes;

class FilmCheck : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Scan.film is the only one")

    // The sentence that names both codes while a wrong reel blocks Start; else empty.
    Q_PROPERTY(QString blockedReason READ blockedReason NOTIFY changed FINAL)

public:
    // Both must outlive the object. What was scanned is kept in a file of the folder.
    FilmCheck(Controller& controller, Recipes& recipes, const QString& folder, QObject* parent);
    ~FilmCheck() override;

    // Returns the code of the reel that the active program's recipe needs; empty: any, or no program is
    // known.
    [[nodiscard]] QString neededCode() const;
    [[nodiscard]] QString scannedCode() const { return m_reel.code; }
    [[nodiscard]] QString blockedReason() const;

    // Returns true for the code of a reel that some recipe needs.
    [[nodiscard]] bool isReel(const QString& code) const;
    // Remembers a reel and compares it with the needed one. Returns false when it is a wrong one.
    bool check(const QString& code);
    // Lifts the block; for technicians. The reason must not be empty.
    Q_INVOKABLE void overrideCheck(const QString& reason);

signals:
    void changed();
    // Emitted for the audit trail.
    void noted(const campanel::store::AuditEntry& entry);

private:
    // The reel that a program needs.
    struct Demand {
        QString program;     // its name, version and CRC-32
        qint64 recipeId = 0; // in the library
        QString code;        // empty: any reel

        bool operator==(const Demand&) const = default;
    };
    // The reel that was scanned last, and the override for it.
    struct Reel {
        QString code;          // empty: none was scanned
        QString overriddenFor; // the reel that was needed then
        QString reason;        // empty: not overridden

        bool operator==(const Reel&) const = default;
    };

    void keep(const Reel& reel, const Demand& demand);
    void followProgram();
    void takeDownloaded(const program::Recipe& recipe);
    void takeCodes(const store::RecipeVersion& recipe);
    void load();
    void note(const QString& what, const QString& after, const QString& outcome);

    Controller& m_controller;
    Recipes& m_recipes;
    QString m_path;
    Reel m_reel;
    Demand m_demand;
    std::optional<program::Recipe> m_downloaded; // the last one
};

} // namespace campanel::panel
