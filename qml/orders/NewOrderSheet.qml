// SPDX-License-Identifier: Apache-2.0
// A new order: how many good bags, of which order and lot, and what happens at the quantity.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Sheet {
    id: sheet

    property bool fresh                    // opened to be filled, not come back from a text

    function finish(isAdded: bool): void {
        if (isAdded)
            Frame.open("Orders/OrdersSheet", {})
    }

    objectName: "newOrderSheet"
    title: qsTr("New order")
    note: Orders.message
    pending: Orders.entry.touched
    Component.onCompleted: if (sheet.fresh) {
        Orders.clearMessage()
        Orders.entry.begin(Controller.active.isPresent ? Controller.active.name : "")
    }

    component Entry: SettingRow {
        level: Access.Operator
        width: (fields.width - 2 * fields.spacing) / 3
    }
    component TextEntry: Entry {
        required property string member    // of Orders.entry
        property string title: label
        value: Orders.entry[member].length > 0 ? Orders.entry[member] : "--"
        onClicked: if (Access.ask(Access.Operator)) Frame.open("Orders/OrderTextSheet", { member: member, title: title })
    }
    Grid {
        id: fields
        anchors { left: parent.left; right: parent.right; top: parent.top }
        columns: 3
        spacing: Theme.size.spacing
        Entry {
            id: quantity
            objectName: "orderQuantity"
            label: qsTr("Good bags")
            value: Orders.entry.quantity.text
            onClicked: Frame.edit([Orders.entry.quantity], 0, quantity, "")
        }
        TextEntry {
            objectName: "orderText"
            member: "text"
            label: qsTr("Order")
            title: Scan.enabled ? qsTr("Order: enter or scan it") : label
        }
        TextEntry {
            objectName: "orderLot"
            member: "lot"
            label: qsTr("Lot")
            title: Scan.enabled ? qsTr("Lot: enter or scan it") : label
        }
        Entry {
            objectName: "orderRecipe"
            label: qsTr("Recipe")
            value: Orders.entry.recipe.length > 0 ? Orders.entry.recipe : qsTr("Any recipe")
            onClicked: if (Access.ask(Access.Operator)) Frame.open("Orders/OrderRecipePicker", {})
        }
        TextEntry {
            objectName: "orderChecked"
            member: "checkedBy"
            label: qsTr("First bag checked by")
        }
        Entry {
            id: before
            objectName: "orderBefore"
            visible: Orders.entry.action === OrderEntry.Message
            label: qsTr("Bags before the end")
            value: Orders.entry.messageBefore.text
            onClicked: Frame.edit([Orders.entry.messageBefore], 0, before, "")
        }
    }
    Label {
        id: caption
        anchors { left: parent.left; top: fields.bottom; topMargin: Theme.size.spacing }
        text: qsTr("At the quantity")
        color: Theme.color.secondaryInk
        font.pixelSize: Theme.size.caption
    }
    Segmented {
        anchors { left: parent.left; right: parent.right; top: caption.bottom; topMargin: Theme.size.accent }
        level: Access.Operator
        choices: [{ key: OrderEntry.Stop, text: qsTr("Stop"), name: "orderStop" },
            { key: OrderEntry.Message, text: qsTr("Message before"), name: "orderMessage" },
            { key: OrderEntry.None, text: qsTr("Run on"), name: "orderRunOn" }]
        current: Orders.entry.action
        onChosen: key => {
            if (Access.ask(Access.Operator))
                Orders.entry.action = key
        }
    }
    footer: [
        Button {
            objectName: "orderAdd"
            level: Access.Operator
            text: qsTr("Add to the queue")
            onClicked: sheet.finish(Orders.add())
        },
        Button {
            objectName: "orderStart"
            level: Access.Operator
            visible: !Orders.current.underWay
            kind: Button.Primary
            text: qsTr("Start order")
            onClicked: sheet.finish(Orders.addAndStart())
        }
    ]
}
