// SPDX-License-Identifier: Apache-2.0
// One large live number with its name below.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme

TextCard {
    id: card

    required property real value
    required property int decimals

    text: Theme.count(card.value, card.decimals)
}
