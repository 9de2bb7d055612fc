// SPDX-License-Identifier: Apache-2.0
// A ring that fills while a key is held: while it is visible.
import QtQuick
import CamPanel.Theme

Canvas {
    id: ring

    required property int time   // ms
    required property color color
    property real filled

    objectName: "holdRing"
    onFilledChanged: requestPaint()
    onPaint: {
        const context = getContext("2d")
        const width = 2 * Theme.size.outline
        context.clearRect(0, 0, ring.width, ring.height)
        context.lineWidth = width
        context.strokeStyle = ring.color
        context.beginPath()
        context.arc(ring.width / 2, ring.height / 2, (ring.width - width) / 2, -Math.PI / 2, (2 * ring.filled - 0.5) * Math.PI)
        context.stroke()
    }
    NumberAnimation on filled { from: 0; to: 1; duration: ring.time; running: ring.visible }
}
