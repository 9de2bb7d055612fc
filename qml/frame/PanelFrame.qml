// SPDX-License-Identifier: Apache-2.0
// The frame of every page: top bar, navigation, page, banner, sheets and keypad, and the command column that nothing covers.
pragma ComponentBehavior: Bound
import QtQuick
import CamPanel.Theme
import CamPanel.Controls
import CamPanel.Parts
import CamPanel.Panel

Rectangle {
    id: frame

    // The name of the open page. An unknown name at the start opens the first one.
    property string page: "run"
    property bool showsPages               // off until the frame itself is on the screen: Start and Stop come first
    readonly property var sources: ({
        run: "../Run/RunPage.qml",
        motion: "../Editor/MotionPage.qml",
        recipes: "../Library/RecipesPage.qml",
        trends: "../Trends/TrendsPage.qml",
        stops: "../Stops/StopsPage.qml",
        alarms: "../Alarms/AlarmsPage.qml",
        maintenance: "../Maintenance/MaintenancePage.qml",
        settings: "../Settings/SettingsPage.qml"
    })
    readonly property list<string> pageNames: Object.keys(sources)
    readonly property Page openPageItem: pages.count > 0 ? (pages.itemAt(frame.pageNames.indexOf(frame.page)) as Loader)?.item as Page : null
    // The cover of everything but the command column, by its file; empty: none.
    readonly property string cover: cleaning ? "CleaningMode.qml" : TouchCalibration.open ? "TouchCrosses.qml"
        : ScreenRotation.secondsLeft > 0 || TouchCalibration.secondsLeft > 0 ? "TrialCover.qml" : ""
    readonly property bool covered: cover.length > 0
    readonly property bool cleaning: Display.wipeSeconds > 0   // the state stays in sight
    readonly property Item overlay: overlay
    property alias clockRuns: topBar.clockRuns
    property alias now: topBar.now
    property Overlay sheet: null           // the open dialog
    readonly property Overlay login: loginLoader.item as Overlay
    readonly property Overlay keypad: keypadLoader.item as Overlay
    readonly property real besideRight: Math.max(frame.sheet?.besideRight ?? 0, frame.keypad?.besideRight ?? 0)
    property real shift                    // offset of the page, so that the keypad does not cover the field
    property real rightInset               // width of a keypad that the first start makes room for instead

    function openPage(name: string): void {
        if (!outside.settle())
            return
        frame.closeAll()
        frame.page = name
        frame.openPageItem?.begin()
    }
    function openSection(name: string, section: string): void {
        frame.openPage(name)
        if (frame.page === name)
            frame.openPageItem?.open(section)
    }
    // Opens a sheet by its file: naming its type would load it at the start. What is named on... answers a signal.
    function openSheet(name: string, values: var): void {
        if (!(frame.keypad?.settle() ?? true))
            return
        frame.closeAll()
        const properties = { width: Qt.binding(() => sheetHost.width), height: Qt.binding(() => sheetHost.height) }
        const handlers = Object.keys(values).filter(key => /^on[A-Z]/.test(key))
        Object.keys(values).filter(key => !handlers.includes(key)).forEach(key => properties[key] = values[key])
        const opened = Qt.createComponent("../" + name + ".qml").createObject(sheetHost, properties)
        handlers.forEach(key => opened[key[2].toLowerCase() + key.slice(3)].connect(values[key]))
        opened.closed.connect(() => frame.closeSheet(opened))
        frame.sheet = opened
        opened.forceActiveFocus()
    }
    // Another sheet may be open by then.
    function closeSheet(sheet: Overlay): void {
        if (frame.sheet !== sheet)
            return
        frame.closeKeypad()
        frame.sheet.destroy()
        frame.sheet = null
    }
    function closeAll(): void {
        frame.closeKeypad()
        loginLoader.active = false
        if (frame.sheet)
            frame.sheet.destroy()
        frame.sheet = null
    }
    // Closes all but what somebody has typed and not confirmed; that asks for a login then.
    function forgetUser(): void {
        loginLoader.active = false
        if (frame.sheet?.secret)
            frame.sheet.forget()
        if (!outside.pending)
            frame.openPage("run")
    }
    function closeKeypad(): void {
        keypadLoader.active = false
        frame.shift = 0
        frame.rightInset = 0
        if (frame.sheet)
            frame.sheet.free = 0
    }
    function edit(fields: var, index: int, source: Item, heading: string): void {
        if (!(frame.keypad?.settle() ?? true) || !Access.ask((fields[index] as Value).neededLevel))
            return
        const right = source ? source.mapToItem(overlay, source.width, 0).x - frame.shift : 0
        keypadLoader.setSource("KeypadOverlay.qml", {
            fields: fields, index: index, heading: heading, beside: frame.sheet?.beside ?? false, leftEdge: navigation.width + Theme.size.gap, rightEdge: frame.sheet?.besideRight ?? 0
        })
        keypadLoader.active = true
        frame.keypad.forceActiveFocus()
        const hidden = Math.min(0, frame.keypad.free - Theme.size.spacing - right)
        const isFirstStart = firstStart.active && frame.sheet === null
        frame.rightInset = isFirstStart ? overlay.width - frame.keypad.free : 0
        frame.shift = isFirstStart || frame.keypad.besideRight > 0 ? 0 : hidden
        if (frame.sheet && frame.keypad.besideRight === 0)
            frame.sheet.free = frame.keypad.free - hidden
    }

    Connections {
        target: Frame
        function onOpen(sheet: string, values: var) { frame.openSheet(sheet, values) }
        function onClose() { frame.closeSheet(frame.sheet) }
        function onOpenPage(name: string) { frame.openPage(name) }
        function onOpenSection(page: string, section: string) { frame.openSection(page, section) }
        function onEdit(fields: var, index: int, source: Item, heading: string) { frame.edit(fields, index, source, heading) }
    }
    Binding {
        target: Frame
        property: "covered"
        value: frame.sheet !== null || keypadLoader.active || loginLoader.active
    }
    // A scanned code opens nothing then.
    Binding {
        target: Scan
        property: "typing"
        value: outside.pending
    }
    Connections {
        target: Access
        function onLeftAlone() { frame.forgetUser() }
    }
    Connections {
        target: Scan
        function onEditsFound() { Frame.open("Scan/ScannedEditsSheet", {}) }
        function onRecipeOpened() { Frame.open("Download/DownloadSheet", {}) }
        function onWrongFilmScanned() { Frame.open("Scan/FilmSheet", {}) }
    }

    color: Theme.color.ground
    Component.onCompleted: if (!(page in sources)) page = "run"

    Item {
        id: pageArea
        visible: !frame.covered
        clip: true
        anchors { left: navigation.right; right: commands.left; top: topBar.bottom; bottom: parent.bottom }

        Item {
            id: pageFrame
            anchors { fill: parent; margins: Theme.size.gap }
            transform: Translate { x: frame.shift }
            Repeater {
                id: pages
                model: frame.showsPages ? frame.pageNames : []
                Loader {
                    id: loader
                    required property int index
                    required property string modelData
                    property bool wanted: frame.page === modelData
                    property bool opened
                    anchors.fill: parent
                    onWantedChanged: opened = opened || wanted
                    Component.onCompleted: opened = wanted
                    source: opened ? frame.sources[modelData] : ""
                    visible: wanted
                    Binding {
                        target: loader.item
                        property: "bottomInset"
                        value: banner.shown && !banner.above ? banner.height + Theme.size.gap : 0
                    }
                    Binding {
                        target: loader.item
                        property: "leftInset"
                        value: Math.max(0, frame.besideRight - pageArea.x - Theme.size.gap)
                    }
                }
            }
        }
    }
    NavigationBar {
        id: navigation
        visible: !frame.covered
        anchors { left: parent.left; top: parent.top; bottom: parent.bottom }
        current: frame.page
    }
    TopBar {
        id: topBar
        visible: !frame.covered || frame.cleaning
        enabled: !frame.covered
        // No navigation during the first start.
        anchors { left: firstStart.active ? parent.left : navigation.right; right: parent.right; top: parent.top }
    }
    // The part of the navigation above the sheets' region is dimmed too.
    Rectangle {
        anchors { left: navigation.left; right: navigation.right; top: parent.top; bottom: topBar.bottom }
        visible: frame.sheet !== null || loginLoader.active || firstStart.active
        color: firstStart.active || frame.sheet?.beside && !loginLoader.active ? "transparent" : Theme.color.scrim
        MouseArea {
            anchors.fill: parent
            enabled: firstStart.active || loginLoader.active
        }
    }
    // The region of sheets and keypad: everything but the top bar and the command column.
    Item {
        id: overlay
        objectName: "overlay"
        visible: !frame.covered
        anchors { left: parent.left; right: commands.left; rightMargin: Theme.size.spacing; top: topBar.bottom; bottom: parent.bottom }

        Loader {
            id: firstStart
            objectName: "firstStart"
            anchors.fill: parent
            active: Settings.firstStart && frame.showsPages
            source: "../First/FirstStart.qml"
            Binding {
                target: firstStart.item
                property: "rightInset"
                value: frame.rightInset
            }
        }
        Item {
            id: sheetHost
            objectName: "sheetHost"
            anchors.fill: parent
            transform: Translate { x: frame.shift }
        }
        Loader {
            id: keypadLoader
            objectName: "keypadLoader"
            anchors.fill: parent
            active: false
            Connections {
                target: keypadLoader.item
                ignoreUnknownSignals: true
                function onClosed() { frame.closeKeypad() }
            }
        }
        LoginHost {
            id: loginLoader
            objectName: "loginLoader"
            anchors.fill: parent
            // Keys reach what was open before the login.
            onActiveChanged: if (!active) (frame.keypad ?? frame.sheet)?.forceActiveFocus()
        }
    }
    OutsideTouch {
        id: outside
        anchors.fill: overlay
        login: frame.login
        keypad: frame.keypad
        sheet: frame.sheet
        navigation: navigation
    }
    // At the lower edge of a page. Over a sheet, a keypad or the first start at the upper edge, away from the confirming
    // keys.
    BannerHost {
        id: banner
        readonly property real leftEdge: above ? frame.besideRight : pageArea.x + (frame.openPageItem?.bannerLeft ?? 0)
        // The key that closes the sheet below stays free.
        readonly property real free: Math.min(frame.keypad?.free ?? overlay.width, (frame.login ?? frame.sheet)?.closeLeft ?? overlay.width) - leftEdge
        above: Frame.covered || firstStart.active
        faultOnPage: frame.openPageItem?.showsFault ?? false
        x: leftEdge + Theme.size.gap
        y: above ? overlay.y + Theme.size.gap : parent.height - height - Theme.size.gap - (frame.openPageItem?.bannerBottom ?? 0)
        width: (above ? free : pageArea.x + pageArea.width - leftEdge) - 2 * Theme.size.gap
        // A narrow banner is higher, and one in the place of cards has their height.
        height: !above && frame.openPageItem?.bannerRow || (width < 0.75 * pageArea.width ? Math.round(1.5 * Theme.size.actionBar) : Theme.size.actionBar)
        visible: shown && !frame.covered
    }
    CommandColumn {
        id: commands
        covered: frame.covered
        anchors { right: parent.right; rightMargin: Theme.size.gap; top: topBar.bottom; bottom: parent.bottom; topMargin: Theme.size.gap; bottomMargin: Theme.size.gap }
        onStartRefused: {
            if (Scan.film.blockedReason.length > 0 && Controller.startBlockedReason === Scan.film.blockedReason && outside.settle())
                Frame.open("Scan/FilmSheet", {})
            else
                banner.refuseStart()
        }
    }
    Loader {
        anchors { left: parent.left; right: commands.left; top: frame.cleaning ? topBar.bottom : parent.top; bottom: parent.bottom }
        source: frame.cover
    }
    // Sees all touches first and leaves them to what is below, also those on the command column: those of a wrong calibration
    // may be anywhere.
    Item {
        anchors.fill: parent
        enabled: TouchCalibration.crossIndex >= 0
        PointHandler {
            acceptedDevices: PointerDevice.TouchScreen
            onActiveChanged: if (active) TouchCalibration.touch(Qt.point(point.scenePosition.x / frame.Window.width, point.scenePosition.y / frame.Window.height))
        }
    }
    Behavior on shift { NumberAnimation { duration: Theme.shortTime; easing.type: Easing.OutCubic } }
}
