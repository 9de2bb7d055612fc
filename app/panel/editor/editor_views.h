// SPDX-License-Identifier: Apache-2.0
// The contents of the editor's fields and lists, built from the recipe, its solution and the active program.
#pragma once

#include "app/panel/editor/editor_field.h"
#include "app/panel/recipe/controller_program.h"
#include "app/panel/recipe/law_model.h"
#include "app/panel/recipe/solution.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>
#include <optional>

namespace campanel::panel {

// The demands of a law on the machine; peaks are NaN without a motion.
struct LawDemand {
    profile::Peaks peaks;
    double rmsAccelerationMmPerS2 = 0; // only of a rotary cutter
    bool isFeasible = false;
    double vibrationMm = NAN; // see EditorViews::vibration(); NaN while the natural frequency is unknown
};

class EditorViews {
    Q_DECLARE_TR_FUNCTIONS(EditorViews)

public:
    // `maxSpeedShare`: where an encoder leads, the maximum speed of the master as a share of the rate.
    EditorViews(const program::Recipe& recipe, const Solution& solution, const ControllerProgram* active,
                std::optional<double> maxSpeedShare = {})
        : m_recipe(recipe)
        , m_solution(solution)
        , m_active(active)
        , m_maxSpeedShare(maxSpeedShare)
    {
    }

    [[nodiscard]] FieldView field(profile::Field field) const;
    [[nodiscard]] FieldView lawParameter(std::size_t index) const; // not visible when the law has no such
                                                                   // parameter
    // Returns the titles of the laws' columns for a kind without a law.
    [[nodiscard]] QStringList lawColumns() const;
    // Returns an empty list for a kind without a law. The laws of a cutter are ranked, each at the ratios
    // that suit it; the figures are those of the recipe with its own ratios.
    [[nodiscard]] QList<LawRow> laws(std::optional<profile::LawId> compared) const;
    [[nodiscard]] QString peaks() const; // "peak 71 r/min · 1.95 m/s² · 11.8 kHz"
    [[nodiscard]] QString verdict() const;

private:
    [[nodiscard]] QString explanation(profile::Field field) const;
    [[nodiscard]] program::Recipe withLaw(const profile::Law& law) const;
    [[nodiscard]] LawDemand demandOf(const program::Recipe& tried) const;
    [[nodiscard]] LawRow lawRow(const profile::Law& law, const LawDemand& demand) const;
    // Returns the columns of the law picker that not every machine has.
    [[nodiscard]] bool hasTorque() const;
    [[nodiscard]] bool hasRmsAcceleration() const;
    [[nodiscard]] bool hasVibration() const;
    void narrowRatio(profile::Field field, FieldView& view) const;
    void tellMaster(profile::Field field, FieldView& view) const;

    const program::Recipe& m_recipe;
    const Solution& m_solution;
    const ControllerProgram* m_active;
    std::optional<double> m_maxSpeedShare;
};

} // namespace campanel::panel
