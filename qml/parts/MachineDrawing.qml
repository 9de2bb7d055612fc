// SPDX-License-Identifier: Apache-2.0
// The machine of the kind of program, with the part that a field of the machine's data describes.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Panel

Item {
    id: drawing

    property string fieldId                // empty: no part is marked

    // Limits and data of the motor belong to the motor, those of the shaft to the gear or to the load.
    readonly property var parts: ({
        knife_radius_mm: "radius", knives: "knives", pulses_per_motor_rev: "motor", gear_numerator: "gear", gear_denominator: "gear",
        max_motor_rpm: "motor", max_knife_acceleration_mm_per_s2: "knives", max_pulse_frequency_hz: "motor", max_rate_bags_per_min: "film",
        max_torque_nm: "motor", rated_torque_nm: "motor", inertia_kg_cm2: "motor", friction_nm: "motor",
        natural_frequency_hz: cutter.visible ? "gear" : "load", damping_ratio: cutter.visible ? "gear" : "load", contact_angle_deg: "contact",
        feed_mm_per_motor_rev: "feed", max_acceleration_mm_per_s2: "load"
    })
    readonly property var marked: fieldId in parts ? [parts[fieldId]] : []

    objectName: "machineDrawing"
    Accessible.role: Accessible.Graphic
    Accessible.name: qsTr("Drawing of the machine")

    CutterDrawing {
        id: cutter
        anchors.fill: parent
        visible: Editor.kind === Editor.Kind.RotaryCutter
        marked: drawing.marked
        knives: Array.from(Editor.machineFields).find(field => field.fieldId === "knives")?.value ?? 1
    }
    AxisDrawing {
        anchors.fill: parent
        visible: !cutter.visible
        marked: drawing.marked
    }
}
