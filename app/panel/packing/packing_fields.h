// SPDX-License-Identifier: Apache-2.0
// The parameters of a packing machine that a technician sets, with a suggestion where there is one.
#pragma once

#include "app/panel/controller/parameter_fields.h"
#include "app/panel/packing/gain_estimate.h"
#include "app/program/dead_time_estimate.h"
#include "app/program/eye_dead_time.h"
#include "app/program/knife_places.h"

namespace campanel::panel {

class PackingFields final : public campanel::panel::ParameterFields {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The fields belong to the packing setup")

public:
    // The controller must outlive the object.
    PackingFields(Controller& controller, QObject* parent);

    // Returns the label of a parameter; empty for one that is not in this list. `name` as in the register
    // table.
    [[nodiscard]] static QString words(const QString& name);
    // Returns the number of the knife whose place this parameter is; 0 for another one.
    [[nodiscard]] static int knifeOf(std::string_view name);
    void suggest(const std::optional<GainSuggestion>& gains, int bags);
    void suggestDeadTime(const program::DeadTimeEstimate& estimate);
    void suggestEyeDeadTimes(const program::EyeDeadTime& measurement);
    // Lists the places of the knives behind the first one; none of a shaft with one knife.
    void setKnives(int knives);
    void suggestKnives(const program::KnifePlaces& places);

protected:
    [[nodiscard]] QString label(const Field& field) const override;
    [[nodiscard]] QString note(const Field& field) const override;
    [[nodiscard]] QString objection(const Field& field, double value) const override;

private:
    [[nodiscard]] QString endObjection(const Field& field, double value) const;
    [[nodiscard]] bool areJawsHalfKnown() const;
    [[nodiscard]] QString deadTimeNote(const Field& field) const;
    [[nodiscard]] QString eyeNote(const Field& field, program::EyeDeadTime::Edge edge) const;
    [[nodiscard]] static QString markWidthObjection(double minimum, double maximum);
    [[nodiscard]] static QString backObjection(double backDeg, double jawsDeg);
    [[nodiscard]] QString stopTimeObjection(double timeMs) const;

    std::optional<GainSuggestion> m_gains;
    std::optional<program::DeadTime> m_deadTime;
    program::EyeDeadTime m_eye;
    int m_bags = 0;
};

} // namespace campanel::panel
