// SPDX-License-Identifier: Apache-2.0
// Dry run: a finger turns the master of the edited recipe, and knife and film, or the axis, follow on the screen. The
// machine does not move.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel
import CamPanel.Plot

MaintenanceSection {
    id: section

    readonly property DryRun run: Maintenance.dryRun
    readonly property real dialSide: Math.min(Math.round(section.width * 0.3), section.height - keys.height - film.height - caption.height - 2 * Theme.size.spacing)

    onShownChanged: shown => {
        if (!shown)
            section.run.playing = false
    }

    Label {
        anchors.fill: parent
        visible: !section.run.available
        wrapMode: Text.WordWrap
        horizontalAlignment: Text.AlignHCenter
        text: qsTr("The recipe cannot be executed. Correct it on the Motion page.")
        color: Theme.color.secondaryInk
    }
    Item {
        anchors.fill: parent
        visible: section.run.available

        Label {
            id: caption
            objectName: "dryRunCaption"
            width: section.dialSide
            text: qsTr("Master %1°").arg(Theme.number(section.run.masterDeg, 1))
            horizontalAlignment: Text.AlignHCenter
            font { pixelSize: Theme.size.body; weight: Font.Bold }
        }
        TurnDial {
            id: master
            objectName: "dryRunDial"
            anchors { top: caption.bottom; left: parent.left }
            width: section.dialSide
            height: section.dialSide
            run: section.run
            angleDeg: section.run.masterDeg
            syncStartDeg: section.run.syncStartMasterDeg
            syncEndDeg: section.run.syncEndMasterDeg
            cutAngleDeg: section.run.cutMasterDeg
        }
        Label {
            visible: section.run.cutter
            anchors { left: knife.left; right: knife.right; top: parent.top }
            text: qsTr("Knife %1°").arg(Theme.number(section.run.knifeDeg, 1))
            horizontalAlignment: Text.AlignHCenter
            font { pixelSize: Theme.size.body; weight: Font.Bold }
        }
        KnifeDial {
            id: knife
            objectName: "dryRunKnife"
            visible: section.run.cutter
            anchors { left: master.right; leftMargin: Theme.size.spacing; top: master.top }
            width: section.dialSide
            height: section.dialSide
            angleDeg: section.run.knifeDeg
            syncStartDeg: section.run.syncStartDeg
            syncEndDeg: section.run.syncEndDeg
            cutAngleDeg: section.run.cutDeg
            ringColor: Theme.color.line
            syncColor: Theme.color.sync
            cutColor: Theme.color.ink
            handColor: Theme.color.ink
            tipColor: section.run.synchronous ? Theme.color.sync : Theme.color.ink
            surfaceColor: Theme.color.surface
            staleColor: Theme.color.target
        }
        FigureColumn {
            objectName: "dryRunFigures"
            anchors { left: section.run.cutter ? knife.right : master.right; leftMargin: Theme.size.padding; right: parent.right; top: parent.top }
            title: qsTr("%1, at full speed").arg(Editor.recipeName)
            figures: section.run.figures
        }
        FilmPicture {
            id: film
            objectName: "dryRunFilm"
            lengthUnit: Theme.shownUnit("mm")
            lengthFactor: Theme.unitFactor("mm")
            visible: section.run.cutter
            anchors { left: parent.left; right: parent.right; bottom: keys.top; bottomMargin: Theme.size.spacing }
            height: Math.round(section.height * 0.28)
            cuts: section.run.cuts
            position: section.run.filmPositionMm
            bagLength: section.run.bagLengthMm
            live: false
            knifeText: qsTr("Knife")
            textFont: Theme.captionFont
            filmColor: Theme.color.touchTint
            edgeColor: Theme.color.target
            cutColor: Theme.color.ink
            knifeColor: section.run.synchronous ? Theme.color.sync : Theme.color.ink
            textColor: Theme.color.secondaryInk
            Binding {
                target: film
                property: "locale"
                value: Theme.locale
            }
        }
        StyledCurves {
            objectName: "dryRunCurve"
            visible: !section.run.cutter
            anchors.fill: film
            curves: Editor.plot.curves
            quantities: ["velocity"]
            titles: [qsTr("Speed %1").arg(Theme.shownUnit("mm/s"))]
            cursorTime: section.run.timeS
        }
        Row {
            id: keys
            anchors { left: parent.left; bottom: parent.bottom }
            spacing: Theme.size.spacing
            Button {
                objectName: "dryRunStart"
                Accessible.name: qsTr("Back to the start")
                glyph: Theme.icon.revert
                onClicked: section.run.toStart()
            }
            Button {
                objectName: "dryRunBack"
                text: "−1°"
                onClicked: section.run.turn(-1)
            }
            Button {
                objectName: "dryRunOn"
                text: "+1°"
                onClicked: section.run.turn(1)
            }
            Button {
                objectName: "dryRunPlay"
                glyph: section.run.playing ? Theme.icon.pause : Theme.icon.start
                text: section.run.playing ? qsTr("Pause") : qsTr("Play")
                onClicked: section.run.playing = !section.run.playing
            }
        }
        Label {
            objectName: "dryRunNote"
            anchors { left: keys.right; leftMargin: Theme.size.padding; right: parent.right; verticalCenter: keys.verticalCenter }
            height: keys.height
            wrapMode: Text.WordWrap
            fontSizeMode: Text.Fit
            text: qsTr("Only on the screen: the machine does not move, and nothing is sent to the controller. Turn the left dial.")
            color: Theme.color.secondaryInk
        }
    }
}
