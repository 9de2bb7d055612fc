// SPDX-License-Identifier: Apache-2.0
// The window.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Window {
    id: window

    property alias page: frame.page
    readonly property PanelFrame frame: frame
    readonly property QtObject theme: Theme
    readonly property QtObject permission: Permission

    title: "CamPanel"
    color: Theme.color.ground
    visible: false
    minimumWidth: isOnDesktop ? 800 : 0
    minimumHeight: isOnDesktop ? 480 : 0

    // Beside other windows: no screen is turned, however the window is resized.
    property bool hasWindowSystem: /^(xcb|wayland)/.test(Qt.platform.pluginName)
    readonly property bool isOnDesktop: hasWindowSystem && visibility !== Window.FullScreen

    // The platform plugins without a window system do not rotate a window. Touches follow the item.
    Item {
        id: turned
        readonly property bool isAcross: ScreenRotation.degrees % 180 !== 0
        x: (window.width - width) / 2
        y: (window.height - height) / 2
        width: isAcross ? window.height : window.width
        height: isAcross ? window.width : window.height
        rotation: ScreenRotation.degrees

        PanelFrame {
            id: frame
            anchors.fill: parent
        }
        FocusRing {
            anchors.fill: parent
            region: Frame.covered || Settings.firstStart ? frame.overlay : null
        }
        Rectangle {
            anchors.fill: parent
            visible: Display.dark
            color: "black"
        }
    }
    Timer {
        id: nextTurn
        interval: 0
        onTriggered: frame.showsPages = true
    }
    Connections {
        target: window
        enabled: !frame.showsPages
        function onFrameSwapped() { nextTurn.start() }
    }
    Binding { target: Permission; property: "level"; value: Access.level }
    Binding { target: Permission; property: "words"; value: Array.from(Access.levels, level => qsTr("needs level %1").arg(level.text)) }
    Binding { target: Theme; property: "name"; value: Settings.setting("display.theme").key }
    Binding { target: Theme; property: "gloves"; value: Settings.setting("display.gloves").key }
    Binding { target: Theme; property: "language"; value: Settings.setting("display.language").key }
    Binding { target: Theme; property: "units"; value: Settings.units }
    Binding { target: Theme; property: "window"; value: Qt.size(turned.width, turned.height) }
    Binding { target: ScreenRotation; property: "screen"; value: window.isOnDesktop ? Qt.size(Math.max(window.width, window.height), 0) : Qt.size(window.width, window.height) }
    Binding {
        target: Theme
        property: "screenPixelsPerMm"
        value: window.visibility === Window.FullScreen ? window.Screen.pixelDensity : 0
    }
}
