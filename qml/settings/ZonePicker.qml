// SPDX-License-Identifier: Apache-2.0
// The time zone: a region, then a city with its offset.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

ListPicker {
    id: picker

    property string region
    readonly property var regions: SystemClock.regions

    title: picker.region.length > 0 ? picker.region : qsTr("Time zone")
    choices: picker.region.length > 0 ? SystemClock.zonesOf(picker.region) : picker.regions.map(key => ({ key: key, text: key }))
    current: picker.region.length > 0 ? SystemClock.zone : SystemClock.zone.split("/")[0]
    level: picker.region.length > 0 ? Access.Service : Access.Viewer
    stays: picker.region.length === 0
    onChosen: key => {
        if (picker.region.length > 0)
            SystemClock.setZone(key)
        else
            picker.region = key
    }
    onClosed: Frame.open("Settings/ClockSheet", {})
}
