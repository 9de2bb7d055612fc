// SPDX-License-Identifier: Apache-2.0
// Nothing typed is dropped without a word: numbers, texts, PINs and wizards, when a finger touches something
// else, when Escape is pressed, when a code is scanned, the screen goes dark or the user is logged out.
#include "panel_test.h"

#include "tests/looks/screen_lists.h"
#include "tests/support/test_program.h"

#include <QSet>

#include <algorithm>
#include <functional>

namespace test_panel_input_kept {

using namespace campanel;
using namespace Qt::StringLiterals;

class TestPanelInputKept : public test::PanelTest {
    Q_OBJECT

    // Touches the center of an item, whatever is there.
    void touch(const QString& name)
    {
        m_window->touch(name);
        m_window->lift();
        m_window->settle();
    }
    void touch(const QPoint& place)
    {
        QTest::mouseClick(&m_window->window(), Qt::LeftButton, {}, place);
        m_window->settle();
    }
    // A place that nothing takes: the strip between navigation and page, or what a sheet leaves at its lower
    // left corner.
    void touchNothing()
    {
        const QQuickItem* overlay = m_window->find(u"overlay"_s);
        const auto gap =
            m_window->theme()->property("size").value<QObject*>()->property("navigation").toInt();
        const QRectF region = overlay->mapRectToScene(overlay->boundingRect());
        touch(QPointF(region.left() + gap + 3, region.bottom() - 3).toPoint());
    }
    // Touches a key of the navigation at its left edge, beside the widest sheet.
    void touchNavigation(const QString& key)
    {
        const QRectF place = rectOf(key);
        touch(QPointF(place.left() + 3, place.center().y()).toPoint());
    }
    void pressEscape()
    {
        m_window->window().requestActivate();
        QTest::keyClick(&m_window->window(), Qt::Key_Escape);
        m_window->settle();
    }
    void waitFiveSeconds()
    {
        m_window->link().advance(std::chrono::seconds(5));
        m_window->checkClock();
        m_window->settle();
    }
    void go(const QStringList& way)
    {
        for (const QString& name : way)
            m_window->tap(name);
    }
    void enter(const QString& name)
    {
        for (const looks::Screen& screen : looks::allScreens()) {
            if (screen.name == name)
                looks::enterScreen(*m_window, screen);
        }
    }
    // The thing that is held: "field bag_length_mm" or "setting bags.tolerance_mm".
    double valueOf(const QString& what)
    {
        const QString name = what.section(u' ', 1);
        return what.startsWith(u"field") ? editor().field(name)->value()
                                         : m_window->panel().settings().setting(name)->key().toDouble();
    }
    QString page() { return m_window->frame()->property("page").toString(); }
    bool isOn(const QString& name) { return m_window->find(name) != nullptr; }
    QRectF rectOf(const QString& name)
    {
        const QQuickItem* item = m_window->find(name);
        return item ? item->mapRectToScene(item->boundingRect()) : QRectF();
    }

    void logOutByTime()
    {
        m_window->link().advance(std::chrono::minutes(30));
        m_window->checkClock();
        m_window->panel().access().checkClock();
        m_window->settle();
        QVERIFY(!m_window->panel().access().loggedIn());
    }
    // By the keys of a keyboard: the pad of a login lies above that of a new PIN.
    void typePin(const QString& pin)
    {
        m_window->type(pin);
        QTest::keyClick(&m_window->window(), Qt::Key_Return);
        while (m_window->panel().access().busy())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        m_window->settle();
    }

private slots:
    void aControlBesideTheKeypadTakesTheNumber_data()
    {
        QTest::addColumn<QStringList>("way");
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("digits");
        QTest::addColumn<QString>("touched");
        QTest::addColumn<QString>("opened"); // what is on the screen afterwards
        const QString keypad = u"keypad"_s;
        QTest::newRow("next field") << QStringList{u"nav_motion"_s, u"field_bag_length_mm"_s}
                                    << u"field bag_length_mm"_s << u"190"_s << u"field_rate_bags_per_min"_s
                                    << keypad;
        QTest::newRow("other control")
            << QStringList{u"nav_motion"_s, u"field_bag_length_mm"_s} << u"field bag_length_mm"_s << u"190"_s
            << u"lawButton"_s << u"lawList"_s;
        QTest::newRow("navigation") << QStringList{u"nav_motion"_s, u"field_bag_length_mm"_s}
                                    << u"field bag_length_mm"_s << u"190"_s << u"nav_recipes"_s
                                    << u"recipeList"_s;
        QTest::newRow("in a sheet") << QStringList{u"nav_motion"_s, u"more"_s, u"field_min_seal_time_ms"_s}
                                    << u"field min_seal_time_ms"_s << u"111"_s << u"positionSwitch"_s
                                    << u"positionSwitch"_s;
        QTest::newRow("machine") << QStringList{u"nav_settings"_s, u"section2"_s, u"field_knife_radius_mm"_s}
                                 << u"field knife_radius_mm"_s << u"51"_s << u"field_knives"_s << keypad;
        QTest::newRow("setting") << QStringList{u"nav_settings"_s, u"section2"_s, u"bagTolerance"_s}
                                 << u"setting bags.tolerance_mm"_s << u"0.7"_s << u"field_knife_radius_mm"_s
                                 << keypad;
        QTest::newRow("tab of the ratios") << QStringList{u"nav_motion"_s, u"ratios"_s, u"ratioNumbers"_s}
                                           << QString() << u"1.7"_s << u"keypadTab3"_s << keypad;
    }
    void aControlBesideTheKeypadTakesTheNumber()
    {
        QFETCH(QStringList, way);
        QFETCH(QString, what);
        QFETCH(QString, digits);
        QFETCH(QString, touched);
        QFETCH(QString, opened);
        if (what.isEmpty()) { // the ratio nearest to the finger is the third
            what = u"field k3"_s;
            go(way.mid(0, 2));
            touch(way.last());
        } else {
            go(way);
        }
        QVERIFY(isOn(u"keypad"_s));
        m_window->type(digits);
        touch(touched);
        QCOMPARE(valueOf(what), digits.toDouble());
        waitFiveSeconds();
        QCOMPARE(valueOf(what), digits.toDouble());
        QVERIFY2(isOn(opened), qPrintable(opened));
        if (opened == u"keypad")
            QVERIFY2(textOf("keypadText") != digits, "the keypad of the next field is empty");
        else
            QVERIFY(!isOn(u"keypad"_s));
    }

    // The same by fingers: each of them is refused or acts alone.
    void aPalmBesideTheKeypadDoesNotHoldUpStop()
    {
        const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        QQuickWindow& window = m_window->window();
        go({u"nav_motion"_s, u"field_bag_length_mm"_s});
        m_window->type(u"190"_s);
        const QPoint nothing(centerOf(u"nav_motion"_s).x() * 2 + 3, window.height() - 3);
        const qsizetype stops = m_window->link().stopRequests();
        QTest::touchEvent(&window, screen.get()).press(0, nothing);
        QTest::touchEvent(&window, screen.get()).stationary(0).press(1, centerOf(u"stopKey"_s));
        QTest::touchEvent(&window, screen.get()).stationary(0).release(1, centerOf(u"stopKey"_s));
        m_window->settle();
        QVERIFY(m_window->link().stopRequests() > stops);
        QTest::touchEvent(&window, screen.get()).release(0, nothing);
        m_window->settle();
        QCOMPARE(textOf("keypadText"), u"190"_s);
        const QPoint rate = centerOf(u"field_rate_bags_per_min"_s);
        QTest::touchEvent(&window, screen.get()).press(0, rate);
        QCOMPARE(editor().bagLength()->value(), 190.0);
        QVERIFY2(isOn(u"keypad"_s), "it stays in place until the finger has acted");
        QTest::touchEvent(&window, screen.get()).release(0, rate);
        m_window->settle();
        QCOMPARE(textOf("keypadText"), editor().rate()->text());
    }

    void aNameIsAskedForAfterItsLogin()
    {
        enter(u"users-logged-out"_s);
        go({u"nav_recipes"_s, u"recipe0"_s, u"recipeRename"_s});
        QVERIFY(isOn(u"loginUsers"_s));
        QVERIFY(!isOn(u"textInput"_s));
    }

    void aTouchOnNothingKeepsTheDigits()
    {
        go({u"nav_motion"_s, u"field_bag_length_mm"_s});
        m_window->type(u"190"_s);
        touchNothing();
        pressEscape();
        waitFiveSeconds();
        QCOMPARE(textOf("keypadText"), u"190"_s);
        QVERIFY2(textOf("keypadHint").startsWith(u"Not confirmed"), qPrintable(textOf("keypadHint")));
        QCOMPARE(editor().bagLength()->value(), 250.0);
        tap("keypadAccept");
        QCOMPARE(editor().bagLength()->value(), 190.0);
        go({u"field_bag_length_mm"_s});
        pressEscape(); // nothing is typed
        QVERIFY(!isOn(u"keypad"_s));
    }

    void anInvalidNumberStaysWithItsReason()
    {
        go({u"nav_motion"_s, u"field_bag_length_mm"_s});
        m_window->type(u"5"_s);
        for (const QString& touched : {u"field_rate_bags_per_min"_s, u"nav_run"_s, u"nav_recipes"_s}) {
            touch(touched);
            waitFiveSeconds();
            QCOMPARE(page(), u"motion"_s);
            QCOMPARE(textOf("keypadText"), u"5"_s);
            QVERIFY2(textOf("keypadHint").startsWith(u"The minimum is"), qPrintable(textOf("keypadHint")));
            QCOMPARE(editor().bagLength()->value(), 250.0);
        }
        QTest::keyClick(&m_window->window(), Qt::Key_Return);
        QVERIFY(isOn(u"keypad"_s));
        tap("keypadCancel");
        QVERIFY(!isOn(u"keypad"_s));
    }

    void whatIsTypedInASheetStays_data()
    {
        QTest::addColumn<QString>("screen");
        QTest::addColumn<QStringList>("way");
        QTest::addColumn<QString>("keys");
        QTest::addColumn<QString>("seen"); // the item with the text
        const QString input = u"textInput"_s;
        QTest::newRow("rename") << u"recipes"_s << QStringList{u"recipeRename"_s} << u"Toast"_s << input;
        QTest::newRow("copy") << u"recipes"_s << QStringList{u"recipeCopy"_s} << u"Toast"_s << input;
        QTest::newRow("code") << u"recipes-code"_s << QStringList{} << u"4711"_s << input;
        QTest::newRow("name of a user")
            << u"users"_s << QStringList{u"userAdd"_s, u"newUserName"_s} << u"Eva"_s << input;
        QTest::newRow("level of a new user")
            << u"users"_s << QStringList{u"userAdd"_s, u"level3"_s} << QString() << u"newUserName"_s;
        QTest::newRow("PIN of a new user") << u"users"_s << QStringList{u"userAdd"_s, u"userPin"_s, u"pin2"_s}
                                           << QString() << u"pinAccept"_s;
        QTest::newRow("PIN at login") << u"login"_s << QStringList{} << QString() << u"pinAccept"_s;
        QTest::newRow("reason of a stop") << u"users-none"_s
                                          << QStringList{u"nav_settings"_s, u"section2"_s, u"openStops"_s,
                                                         u"stopsReasons"_s, u"reasonRename"_s}
                                          << u"Lunch"_s << input;
        QTest::newRow("word of a filter")
            << u"audit"_s << QStringList{u"auditFilter"_s, u"filterWord"_s} << u"mark"_s << input;
        QTest::newRow("reason for a film") << u"scan-film-reason"_s << QStringList{} << u"Trial"_s << input;
        QTest::newRow("reason outside the window")
            << u"run-outside-reasons"_s << QStringList{u"choice_other"_s} << u"Trial"_s << input;
        QTest::newRow("approved windows")
            << u"recipes-windows"_s << QStringList{} << QString() << u"windowsSave"_s;
        QTest::newRow("wizard") << u"packing-wizard-measure"_s << QStringList{} << QString()
                                << u"wizardMeasured"_s;
        QTest::newRow("network") << u"settings-network"_s << QStringList{u"networkFixed"_s} << QString()
                                 << u"networkApply"_s;
        QTest::newRow("address") << u"settings-network"_s
                                 << QStringList{u"networkFixed"_s, u"networkField0"_s, u"pin0"_s} << QString()
                                 << u"padText"_s;
    }
    void whatIsTypedInASheetStays()
    {
        QFETCH(QString, screen);
        QFETCH(QStringList, way);
        QFETCH(QString, keys);
        QFETCH(QString, seen);
        enter(screen);
        go(way);
        m_window->type(keys);
        QVERIFY2(isOn(seen), qPrintable(seen));
        const QString before = textOf(qPrintable(seen));
        QVERIFY(before.contains(keys));
        const QString pageBefore = page();
        const std::function<void()> attempts[] = {
            [this] { touchNothing(); }, [this] { touchNavigation(u"nav_trends"_s); },
            [this] { pressEscape(); }, [this] { touchNavigation(u"nav_run"_s); }};
        for (const auto& attempt : attempts) {
            attempt();
            waitFiveSeconds();
            QVERIFY2(isOn(seen), qPrintable(seen));
            QCOMPARE(textOf(qPrintable(seen)), before);
            QCOMPARE(page(), pageBefore);
        }
    }

    void aSecondTouchOnCloseDropsADraft_data()
    {
        QTest::addColumn<QString>("screen");
        QTest::addColumn<QStringList>("way");
        QTest::addColumn<QString>("keys");
        QTest::addColumn<QString>("seen");
        const QString input = u"textInput"_s;
        QTest::newRow("rename") << u"recipes"_s << QStringList{u"recipeRename"_s} << u"Toast"_s << input;
        QTest::newRow("reason outside the window")
            << u"run-outside-reasons"_s << QStringList{u"choice_other"_s} << u"Trial"_s << input;
        QTest::newRow("approved windows")
            << u"recipes-windows"_s << QStringList{} << QString() << u"windowsSave"_s;
        QTest::newRow("network") << u"settings-network"_s << QStringList{u"networkFixed"_s} << QString()
                                 << u"networkApply"_s;
    }
    void aSecondTouchOnCloseDropsADraft()
    {
        QFETCH(QString, screen);
        QFETCH(QStringList, way);
        QFETCH(QString, keys);
        QFETCH(QString, seen);
        enter(screen);
        go(way);
        m_window->type(keys);
        const QString before = textOf(qPrintable(seen));
        tap("sheetClose");
        QVERIFY2(isOn(seen), qPrintable(seen));
        QCOMPARE(textOf(qPrintable(seen)), before);
        QVERIFY2(textOf("sheetNote").startsWith(u"Not confirmed"), qPrintable(textOf("sheetNote")));
        tap("sheetClose");
        QVERIFY(!isOn(seen));
    }
    // A sheet without an entry closes at once; each new entry is asked for again.
    void closeAsksForEachEntry()
    {
        enter(u"recipes"_s);
        tap("recipeRename");
        tap("sheetClose");
        QVERIFY(!isOn(u"textInput"_s));
        tap("recipeRename");
        m_window->type(u"Toast"_s);
        tap("sheetClose");
        m_window->type(u"s"_s);
        tap("sheetClose");
        QVERIFY(isOn(u"textInput"_s));
        tap("sheetClose");
        QVERIFY(!isOn(u"textInput"_s));
    }

    // Every sheet, picker and keypad of the panel: Escape closes what holds nothing, and keeps what holds
    // something.
    void escapeClosesEverythingThatHoldsNothing()
    {
        QSet<QString> types;
        for (const looks::Screen& screen : looks::allScreens()) {
            enter(screen.name);
            for (const char* layer : {"login", "keypad", "sheet"}) {
                auto* open = m_window->frame()->property(layer).value<QQuickItem*>();
                if (!open)
                    continue;
                types << QString::fromLatin1(open->metaObject()->className());
                QVERIFY2(open->property("pending").isValid(), qPrintable(screen.name));
                const bool holds = open->property("pending").toBool();
                const QPointer<QQuickItem> kept(open);
                pressEscape();
                QCOMPARE(!kept.isNull(), holds);
                break;
            }
        }
        QVERIFY2(types.size() >= 30, qPrintable(QString::number(types.size())));
    }

    void oneTouchOnTheNavigationClosesASheetAndChangesThePage_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QStringList>("way");
        QTest::newRow("ratios") << 1 << QStringList{u"ratios"_s};
        QTest::newRow("knots") << 4 << QStringList{u"knotsButton"_s};
        QTest::newRow("segments") << 6 << QStringList{u"segmentsButton"_s};
        QTest::newRow("laws") << 1 << QStringList{u"lawButton"_s};
        QTest::newRow("download") << 1 << QStringList{u"nextStep"_s, u"downloadStart"_s};
    }
    void oneTouchOnTheNavigationClosesASheetAndChangesThePage()
    {
        QFETCH(int, kind);
        QFETCH(QStringList, way);
        editor().newProgram(kind);
        if (kind == 1)
            editor().bagLength()->set(240);
        tap("nav_motion");
        go(way);
        QVERIFY(isOn(u"sheetPanel"_s));
        touchNavigation(u"nav_recipes"_s);
        QVERIFY(!isOn(u"sheetPanel"_s));
        QCOMPARE(page(), u"recipes"_s);
        QVERIFY(isOn(u"recipeList"_s));
    }

    void aScannedCodeLeavesWhatIsTyped()
    {
        enter(u"recipes"_s);
        m_window->link().show(looks::DemoLink::Situation::Stopped);
        m_window->panel().settings().overrideValue("scanner.prefix", u"~~"_s);
        go({u"nav_motion"_s, u"field_bag_length_mm"_s});
        m_window->type(u"190"_s);
        const QString open = editor().recipeName();
        m_window->panel().scan().takeCode(u"Rusk 310"_s);
        m_window->settle();
        waitFiveSeconds();
        QCOMPARE(editor().recipeName(), open);
        QCOMPARE(textOf("keypadText"), u"190"_s);
        QVERIFY2(textOf("banner").contains(u"scan again"), qPrintable(textOf("banner")));
        tap("keypadAccept");
        QCOMPARE(editor().bagLength()->value(), 190.0);
    }

    void aDarkScreenKeepsTheDigits()
    {
        m_window->link().show(looks::DemoLink::Situation::Stopped);
        go({u"nav_motion"_s, u"field_bag_length_mm"_s});
        m_window->type(u"190"_s);
        panel::Display& display = m_window->panel().display();
        m_window->panel().settings().overrideValue("display.dark_after_minutes", u"5"_s);
        m_window->link().advance(std::chrono::minutes(6));
        m_window->checkClock();
        display.tick();
        QVERIFY(display.dark());
        touch(u"field_rate_bags_per_min"_s); // only wakes
        QVERIFY(!display.dark());
        QCOMPARE(textOf("keypadText"), u"190"_s);
        QCOMPARE(editor().bagLength()->value(), 250.0);
    }

    void theLogoutKeepsTheDigitsAndAsksAgain()
    {
        enter(u"users"_s); // Anna is logged in
        auto& access = m_window->panel().access();
        go({u"nav_settings"_s, u"section2"_s, u"field_knife_radius_mm"_s});
        m_window->type(u"51"_s);
        const double before = valueOf(u"field knife_radius_mm"_s);
        m_window->link().advance(std::chrono::minutes(30));
        m_window->checkClock();
        access.checkClock();
        m_window->settle();
        QVERIFY(!access.loggedIn());
        QCOMPARE(textOf("keypadText"), u"51"_s);
        QCOMPARE(valueOf(u"field knife_radius_mm"_s), before);
        tap("keypadAccept");
        QVERIFY2(isOn(u"loginUsers"_s), "whoever confirms has to log in");
        tap("pinCancel");
        touch(u"field_knives"_s);
        QVERIFY2(isOn(u"loginUsers"_s), "a touch on the next field confirms too");
        tap("pinCancel");
        QCOMPARE(textOf("keypadText"), u"51"_s);
        QCOMPARE(valueOf(u"field knife_radius_mm"_s), before);
    }

    // The PIN is forgotten; the name and the level of the steps before are kept.
    void theLogoutKeepsTheNameOfANewUser()
    {
        enter(u"users"_s);
        go({u"userAdd"_s, u"level2"_s, u"newUserName"_s});
        logOutByTime();
        QVERIFY2(isOn(u"textInput"_s), "somebody has chosen a level");
        m_window->type(u"Eva"_s);
        tap("textAccept");
        tap("userPin");
        QVERIFY(isOn(u"loginUsers"_s));
        tap("login_Anna");
        typePin(u"258036"_s); // and the tap is carried out
        go({u"pin2"_s, u"pin5"_s});
        logOutByTime();
        QVERIFY2(isOn(u"pinAccept"_s), "the PIN of Eva is asked for");
        QCOMPARE(propertyOf("keypad", "digits"), QString());
        waitFiveSeconds();
        typePin(u"4711"_s);
        QVERIFY2(isOn(u"loginUsers"_s), "whoever confirms has to log in");
        tap("login_Anna");
        typePin(u"258036"_s);
        typePin(u"4711"_s);
        typePin(u"4711"_s);
        const QVariantList users = m_window->panel().access().users();
        QVERIFY(std::ranges::any_of(users, [](const QVariant& each) {
            return each.toMap().value(u"name"_s) == u"Eva"_s && each.toMap().value(u"level"_s) == 2;
        }));
    }

    void theLogoutKeepsTheAddressesOfTheNetwork()
    {
        enter(u"users"_s);
        go({u"nav_settings"_s, u"section0"_s, u"sectionSystem"_s, u"setNetwork"_s});
        auto& network = m_window->panel().systemNetwork();
        m_window->waitUntil(network, &panel::SystemNetwork::changed,
                            [](const panel::SystemNetwork& each) { return each.isAsked() && !each.busy(); });
        go({u"networkFixed"_s, u"networkField0"_s, u"pinBackspace"_s, u"pin7"_s, u"pinAccept"_s});
        m_window->waitUntil(network, &panel::SystemNetwork::changed,
                            [](const panel::SystemNetwork& each) { return each.isAsked() && !each.busy(); });
        go({u"networkField2"_s});
        const QString typed = network.fields().first().toMap().value(u"text"_s).toString();
        logOutByTime();
        go({u"nav_settings"_s, u"section0"_s, u"sectionSystem"_s, u"setNetwork"_s});
        tap("login_Anna");
        typePin(u"258036"_s);
        QVERIFY(isOn(u"networkApply"_s));
        QVERIFY(network.edited());
        QCOMPARE(network.fields().first().toMap().value(u"text"_s).toString(), typed);
        tap("sheetClose");
        QVERIFY2(!network.edited(), "its own key drops them");
    }

    void theLogoutForgetsAPin()
    {
        enter(u"users"_s);
        go({u"userAdd"_s, u"userPin"_s, u"pin2"_s, u"pin5"_s});
        m_window->link().advance(std::chrono::minutes(30));
        m_window->checkClock();
        m_window->panel().access().checkClock();
        m_window->settle();
        QVERIFY(!isOn(u"pinAccept"_s));
        QCOMPARE(page(), u"run"_s);
    }
};

CAMPANEL_TEST(TestPanelInputKept)

} // namespace test_panel_input_kept

#include "test_panel_input_kept.moc"
