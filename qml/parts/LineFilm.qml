// SPDX-License-Identifier: Apache-2.0
// The film of a packing machine in the colors of the screen; what lies on it is set where it is used.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Panel
import CamPanel.Plot

FilmPicture {
    id: film

    property bool fresh: true              // what is old is gray
    stale: !film.fresh
    bagLength: Controller.active.bagLengthMm
    live: Theme.animated
    knifeText: qsTr("Knife")
    textFont: Theme.captionFont
    lengthUnit: Theme.shownUnit("mm")
    lengthFactor: Theme.unitFactor("mm")
    filmColor: film.fresh ? Theme.color.touchTint : Theme.color.inset
    edgeColor: Theme.color.target
    markColor: Theme.color.ink
    windowColor: Theme.color.touch
    productColor: Theme.color.sync
    cutColor: Theme.color.ink
    skippedColor: Theme.color.warning
    knifeColor: Theme.color.ink
    textColor: film.fresh ? Theme.color.secondaryInk : Theme.color.disabledInk

    Binding {
        target: film
        property: "locale"
        value: Theme.locale
    }
}
