// SPDX-License-Identifier: Apache-2.0
// The last edges of the mark sensor over the film, and in words why a mark was not taken.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel
import CamPanel.Plot

Sheet {
    id: sheet

    readonly property MarkEdgeList edges: Maintenance.packing.edges
    readonly property bool empty: edges.emptyText.length > 0
    readonly property real bagMm: Controller.active.bagLengthMm > 0 ? Controller.active.bagLengthMm : 250
    readonly property real spanMm: 3.5 * sheet.bagMm
    readonly property real pxPerMm: picture.width / sheet.spanMm
    readonly property real filmMm: sheet.empty ? 0 : -sheet.edges.places[0]

    title: qsTr("Edges of the mark sensor")
    note: sheet.empty ? "" : qsTr("The film below the sensor. The newest edge is at the right; swipe for earlier ones.")
    Component.onDestruction: sheet.edges.paused = false

    // Brings a place of the film into the middle of the picture.
    function showPlace(mm: real) {
        const px = -mm * sheet.pxPerMm - 0.4 * view.width
        view.contentX = Math.max(0, view.contentWidth - view.width - Math.max(0, px))
    }

    header: Button {
        objectName: "edgesPause"
        Accessible.name: sheet.edges.paused ? qsTr("Resume") : qsTr("Pause")
        enabled: !sheet.empty
        kind: sheet.edges.paused ? Button.Primary : Button.Normal
        glyph: sheet.edges.paused ? Theme.icon.start : Theme.icon.pause
        onClicked: sheet.edges.paused = !sheet.edges.paused
    }

    component Colors: EdgePicture {
        textFont: Theme.captionFont
        lengthUnit: Theme.shownUnit("mm")
        lengthFactor: Theme.unitFactor("mm")
        filmColor: Theme.color.touchTint
        edgeColor: Theme.color.target
        markColor: Theme.color.ink
        windowColor: Theme.color.touch
        rejectedColor: Theme.color.warning
        textColor: Theme.color.secondaryInk
    }
    component Words: Column {
        id: words
        required property string name
        required property string caption
        required property string text
        property bool abnormal
        visible: text.length > 0
        Label {
            width: parent.width
            text: words.caption
            color: Theme.color.secondaryInk
            font.pixelSize: Theme.size.caption
        }
        Label {
            objectName: words.name
            width: parent.width
            wrapMode: Text.WordWrap
            text: words.text
            color: words.abnormal ? Theme.color.warning : Theme.color.ink
        }
    }

    Label {
        objectName: "edgesEmpty"
        anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter }
        visible: sheet.empty
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
        text: sheet.edges.emptyText
        color: Theme.color.secondaryInk
    }
    Colors {
        id: picture
        objectName: "edgePicture"
        Accessible.role: Accessible.Graphic
        Accessible.name: sheet.title
        Accessible.description: sheet.edges.summary
        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: legend.top; bottomMargin: Theme.size.spacing }
        visible: !sheet.empty
        places: sheet.edges.places
        looks: sheet.edges.looks
        notes: sheet.edges.notes
        windows: sheet.edges.windows
        span: sheet.spanMm
        back: (view.contentWidth - view.width - view.contentX) / sheet.pxPerMm
        Binding {
            target: picture
            property: "locale"
            value: Theme.locale
        }
    }
    Flickable {
        id: view
        objectName: "edgesView"
        anchors.fill: picture
        visible: !sheet.empty
        boundsBehavior: Flickable.StopAtBounds
        contentWidth: Math.max(width, sheet.filmMm * sheet.pxPerMm + width * 0.2)
        // The newest edge stays in sight until a finger looks for earlier ones.
        onContentWidthChanged: contentX = contentWidth - width
        Item {
            x: view.contentX
            width: view.width
            height: view.height
            Explained {
                objectName: "edgesExplained"
                Accessible.name: sheet.title
                quantities: [Explanations.MarkDistance]
            }
        }
    }
    Flow {
        id: legend
        anchors { left: parent.left; right: parent.right; bottom: sentences.top; bottomMargin: Theme.size.spacing }
        visible: !sheet.empty
        spacing: Theme.size.padding
        Repeater {
            model: sheet.edges.verdicts
            Row {
                id: verdict
                required property int index
                required property string name
                required property int look
                required property int edges
                spacing: Theme.size.spacing
                Colors {
                    width: Theme.size.icon
                    height: Math.round(Theme.size.caption * 2)
                    places: [0]
                    looks: [verdict.look]
                }
                Label {
                    objectName: "edgeVerdict" + verdict.index
                    anchors.verticalCenter: parent.verticalCenter
                    text: Theme.fill(qsTr("%1: %2"), [verdict.name, verdict.edges])
                    font.pixelSize: Theme.size.caption
                }
            }
        }
        Row {
            spacing: Theme.size.spacing
            Rectangle {
                width: Theme.size.icon
                height: Math.round(Theme.size.caption * 2)
                color: Theme.color.touchTint
                border { width: Theme.size.hairline; color: Theme.color.touch }
            }
            Label {
                anchors.verticalCenter: parent.verticalCenter
                text: qsTr("window of an expected mark")
                font.pixelSize: Theme.size.caption
            }
        }
    }
    Column {
        id: sentences
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        visible: !sheet.empty
        spacing: Theme.size.accent
        Words {
            width: parent.width
            name: "edgeNewest"
            caption: qsTr("Newest edge")
            text: sheet.edges.newestText
            abnormal: sheet.edges.newestRejected
        }
        Item {
            width: parent.width
            height: Math.max(rejected.height, show.height)
            visible: rejected.text.length > 0
            Words {
                id: rejected
                anchors { left: parent.left; right: show.left; rightMargin: Theme.size.padding; verticalCenter: parent.verticalCenter }
                name: "edgeRejected"
                caption: qsTr("Last edge that was not taken; edges since then: %1").arg(sheet.edges.sinceRejected)
                text: sheet.edges.rejectedText
                abnormal: true
            }
            Button {
                id: show
                objectName: "edgesShow"
                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                text: qsTr("Show")
                onClicked: {
                    sheet.edges.paused = true
                    sheet.showPlace(sheet.edges.rejectedPlace)
                }
            }
        }
    }
}
