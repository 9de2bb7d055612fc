// SPDX-License-Identifier: Apache-2.0
// `Service.packing` in QML: the commissioning of a packing machine. Compares the measured marks with the
// recipe, corrects the distance from their sensor to the knife, and lists the parameters with suggestions.
#pragma once

#include "app/panel/packing/gain_estimate.h"
#include "app/panel/packing/jam_watch.h"
#include "app/panel/packing/mark_edge_list.h"
#include "app/panel/packing/mark_sensor.h"
#include "app/panel/packing/mark_wizard.h"
#include "app/panel/packing/packing_fields.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class PackingSetup : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The packing setup belongs to Maintenance")
    Q_PROPERTY(campanel::panel::PackingFields* fields READ fields CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::MarkWizard* wizard READ wizard CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::MarkEdgeList* edges READ edges CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::JamWatch* jam READ jam CONSTANT FINAL)
    // True when a packing machine's program is active and the controller reports it.
    Q_PROPERTY(bool available READ available NOTIFY changed FINAL)
    Q_PROPERTY(bool teaching READ teaching NOTIFY changed FINAL)
    Q_PROPERTY(bool canTeach READ canTeach NOTIFY changed FINAL)
    // The progress 0..1 of the marks being measured.
    Q_PROPERTY(double teachProgress READ teachProgress NOTIFY changed FINAL)
    Q_PROPERTY(QString teachText READ teachText NOTIFY changed FINAL)
    // True when the marks do not fit the recipe.
    Q_PROPERTY(bool misfit READ misfit NOTIFY changed FINAL)

public:
    static constexpr int marksToTeach = 10;

    // The controller must outlive the object.
    PackingSetup(Controller& controller, QObject* parent);

    [[nodiscard]] PackingFields* fields() { return &m_fields; }
    [[nodiscard]] MarkWizard* wizard() { return &m_wizard; }
    [[nodiscard]] MarkSensor* sensor() { return &m_sensor; }
    [[nodiscard]] MarkEdgeList* edges() { return &m_edges; }
    [[nodiscard]] JamWatch* jam() { return &m_jam; }
    [[nodiscard]] bool available() const;
    [[nodiscard]] bool teaching() const { return m_teaching != Teaching::No; }
    [[nodiscard]] bool canTeach() const;
    [[nodiscard]] double teachProgress() const;
    [[nodiscard]] QString teachText() const;
    [[nodiscard]] bool misfit() const;

    Q_INVOKABLE void teach();
    // Reads all values; call it when the page opens.
    Q_INVOKABLE void open();

signals:
    void changed();

private:
    enum class Teaching { No, Asked, Accepted, UnderWay };

    void followMarks();
    void followKnives();
    void takeBag(const modbus::BagRecord& bag);
    void followTeaching();
    void takeCommand(const link::CommandOutcome& outcome);
    void takeEye(const std::vector<std::uint16_t>& registers);

    Controller& m_controller;
    PackingFields m_fields;
    MarkWizard m_wizard;
    MarkSensor m_sensor;
    MarkEdgeList m_edges;
    SensorRecords m_eyeRecords;
    program::EyeDeadTime m_eye;
    JamWatch m_jam;
    GainEstimate m_estimate;
    program::KnifePlaces m_knives{1};
    Teaching m_teaching = Teaching::No;
    QString m_refusal; // refusal of the last teaching
};

} // namespace campanel::panel
