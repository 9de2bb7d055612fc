// SPDX-License-Identifier: Apache-2.0
// Commands to the machine: by a touch that is too short, by one that is long enough, with another recipe
// open, and twice on one spot.
#include "panel_test.h"
#include "tests/looks/screens.h"
#include "tests/support/test_program.h"

namespace test_panel_commands {

using namespace campanel;
using namespace Qt::StringLiterals;
using Situation = looks::DemoLink::Situation;
using Kind = looks::DemoLink::Kind;
using modbus::Command;

class TestPanelCommands : public test::PanelTest {
    Q_OBJECT

    auto& link() { return m_window->link(); }
    void enter(Situation situation, const QStringList& way = {}, Kind kind = Kind::RotaryCutter)
    {
        m_window->link().show(situation, kind);
        m_window->checkClock();
        m_window->settle();
        for (const QString& name : way)
            m_window->tap(name);
        link().requests.clear();
        link().jogs.clear();
    }
    QList<Command> commands()
    {
        QList<Command> list;
        for (const auto& request : link().requests)
            list << request.command;
        return list;
    }
    QRectF rectOf(const char* name)
    {
        const QQuickItem* item = m_window->find(QString::fromLatin1(name));
        return item ? item->mapRectToScene(item->boundingRect()) : QRectF();
    }
    // Waits until the screen has settled for good, as a person who looks at the outcome does.
    void wait(int ms)
    {
        QTest::qWait(ms);
        m_window->settle();
    }
    void click(const QPoint& place)
    {
        QTest::mouseClick(&m_window->window(), Qt::LeftButton, Qt::NoModifier, place);
        m_window->settle();
    }
    // Returns the name of the controller's program.
    QString active()
    {
        const auto program = m_window->panel().controller().active();
        return u"%1 · v%2"_s.arg(program.name).arg(program.version);
    }
    // The program in the controller is not kept after power-off.
    void tellUnsaved()
    {
        modbus::StatusBlock status = *m_window->panel().controller().status();
        status.savedCrc = 0;
        emit link().statusReceived({{{link().now(), status}}, 0});
        m_window->settle();
    }

private slots:
    void aShortTouchCommandsNothing_data()
    {
        QTest::addColumn<Situation>("situation");
        QTest::addColumn<QStringList>("way");
        QTest::addColumn<QString>("key");
        QTest::addColumn<Command>("command");
        const QStringList machine{u"nav_maintenance"_s, u"maintenanceMachine"_s};
        QTest::newRow("reference run")
            << Situation::Fresh << QStringList() << u"middleKey"_s << Command::Home;
        QTest::newRow("reset") << Situation::Fault << QStringList() << u"middleKey"_s << Command::ResetFault;
        QTest::newRow("reference run, Maintenance")
            << Situation::Stopped << machine + QStringList{u"maintenanceHoming"_s} << u"middleKey"_s
            << Command::Home;
        QTest::newRow("output") << Situation::Stopped << machine + QStringList{u"maintenanceIo"_s}
                                << u"try2"_s << Command::TryOutput;
    }

    void aShortTouchCommandsNothing()
    {
        QFETCH(const Situation, situation);
        QFETCH(const QStringList, way);
        QFETCH(const QString, key);
        QFETCH(const Command, command);
        enter(situation, way);
        holdFor(qPrintable(key), 60);
        wait(700);
        QCOMPARE(commands(), QList<Command>());
        m_window->touch(key);
        QTRY_COMPARE(commands().value(0), command);
        m_window->lift();
        m_window->settle();
    }

    void aShortTouchDoesNotJog()
    {
        enter(Situation::Stopped, {u"nav_maintenance"_s, u"maintenanceMachine"_s, u"maintenanceJog"_s});
        holdFor("jogForward", 60);
        wait(700);
        QVERIFY(!link().jogs.contains(link::JogDirection::Forward));
        m_window->touch(u"jogForward"_s);
        QTRY_COMPARE(link().jog(), link::JogDirection::Forward);
        m_window->lift();
        QCOMPARE(link().jog(), link::JogDirection::None);
    }

    void aStopBeforeTheRingIsFullEndsTheTouch()
    {
        enter(Situation::Stopped, {u"nav_maintenance"_s, u"maintenanceMachine"_s, u"maintenanceJog"_s});
        m_window->touch(u"jogForward"_s);
        QTest::qWait(100);
        m_window->panel().controller().stop();
        wait(900);
        QVERIFY(!link().jogs.contains(link::JogDirection::Forward));
        m_window->lift();
    }

    void theKeysKeepTheirPlaces_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("gloves");
        for (const QSize size : {QSize(800, 480), QSize(1024, 600), QSize(1280, 800)}) {
            QTest::addRow("%d x %d", size.width(), size.height()) << size << false;
            QTest::addRow("%d x %d, gloves", size.width(), size.height()) << size << true;
        }
    }

    void theKeysKeepTheirPlaces()
    {
        QFETCH(const QSize, size);
        QFETCH(const bool, gloves);
        m_window = std::make_unique<looks::TestWindow>(looks::Variant{u"de"_s, u"light"_s, size, gloves});
        const double least =
            m_window->theme()->property("size").value<QObject*>()->property("commandKey").toDouble();
        enter(Situation::Running);
        QVERIFY(!m_window->find(u"middleKey"_s));
        const QRectF start = rectOf("startKey");
        const QRectF stop = rectOf("stopKey");
        QRectF middle;
        for (const Situation situation :
             {Situation::Fresh, Situation::Fault, Situation::Empty, Situation::Lost}) {
            enter(situation);
            QCOMPARE(rectOf("startKey"), start);
            QCOMPARE(rectOf("stopKey"), stop);
            const QRectF place = rectOf("middleKey");
            if (place.isNull())
                continue;
            QVERIFY(place.height() >= least - 1 && !place.intersects(start) && !place.intersects(stop));
            QVERIFY(middle.isNull() || middle == place);
            middle = place;
        }
        QVERIFY(!middle.isNull());
    }

    void theTitleIsWhatTheMachineRuns()
    {
        enter(Situation::Running);
        QCOMPARE(textOf("recipeTitle"), active());
        QVERIFY(!m_window->find(u"openTitle"_s));
        enter(Situation::Running, {}, Kind::Press);
        QCOMPARE(textOf("recipeTitle"), u"Bearing 6204 · v1"_s);
        QVERIFY2(textOf("openTitle").startsWith(u"open: Biscuit 250"_s), qPrintable(textOf("openTitle")));
        enter(Situation::Empty);
        QCOMPARE(textOf("recipeTitle"), u"No program"_s);
    }

    void startAsksOnceWhenAnotherRecipeIsOpen()
    {
        m_window->panel().settings().set("access.hold_to_start", u"on"_s);
        enter(Situation::Stopped);
        editor().bagLength()->set(240);
        const QString open = u"Biscuit 250 · v%1, edited"_s.arg(editor().recipeVersion());
        m_window->settle();
        holdFor("startKey", 700);
        wait(5000);
        QCOMPARE(commands(), QList<Command>());
        QCOMPARE(textOf("startQuestion"), u"Start runs %1. Download %2 instead?"_s.arg(active(), open));
        tap("stopKey");
        QCOMPARE(commands(), QList<Command>{Command::StopAtCycleEnd});
        tap("startDownload");
        QVERIFY(m_window->find(u"downloadStart"_s));
        tap("downloadCancel");
        link().requests.clear();
        holdFor("startKey", 700);
        QCOMPARE(textOf("startActive"), u"Start %1"_s.arg(active()));
        holdFor("startActive", 60);
        QCOMPARE(commands(), QList<Command>());
        holdFor("startActive", 700);
        QCOMPARE(commands(), QList<Command>{Command::Start});
        QVERIFY(!m_window->find(u"startQuestion"_s));
        holdFor("startKey", 700);
        QCOMPARE(commands(), (QList<Command>{Command::Start, Command::Start}));
    }

    void saveNamesTheProgramThatIsSaved()
    {
        enter(Situation::Stopped, {u"nav_motion"_s});
        tellUnsaved();
        QCOMPARE(textOf("nextStep"), u"Save Biscuit 250"_s);
        editor().newProgram(static_cast<int>(Kind::PointCam));
        m_window->settle();
        QCOMPARE(textOf("nextStep"), u"Download"_s);
        editor().undo();
        editor().bagLength()->set(1500); // refused
        m_window->settle();
        QVERIFY(!editor().programDownload()->canDownload());
        QVERIFY2(!textOf("nextStep").startsWith(u"Save"_s), qPrintable(textOf("nextStep")));
        const auto place = centerOf(u"nextStep"_s);
        click(place);
        wait(5000);
        QVERIFY(!commands().contains(Command::SaveToFlash));
    }

    // Also where the ramps of the recipe can be bettered, which is one more key.
    void twoTapsOnOneSpotAreTheSameKey_data()
    {
        QTest::addColumn<double>("length");
        QTest::addColumn<QList<double>>("rates");
        QTest::newRow("good") << 240.0 << QList{60.0, 61.0, 62.0};
        QTest::newRow("other ramps are offered") << 150.0 << QList{318.0, 319.0, 320.0};
        QTest::newRow("refused") << 250.0 << QList{60.0, 61.0, 390.0};
    }

    void twoTapsOnOneSpotAreTheSameKey()
    {
        QFETCH(const double, length);
        QFETCH(const QList<double>, rates);
        enter(Situation::Stopped, {u"nav_motion"_s});
        editor().bagLength()->set(length);
        for (const double rate : rates)
            editor().rate()->set(rate);
        m_window->settle();
        const QPoint undo = centerOf(u"undo"_s);
        for (int i = 0; i < 6; ++i)
            click(undo);
        QVERIFY(!editor().canUndo());
        QVERIFY(editor().canRedo());
        const QPoint redo = centerOf(u"redo"_s);
        for (int i = 0; i < 8; ++i)
            click(redo);
        QVERIFY(!editor().canRedo());
        QCOMPARE(editor().bagLength()->value(), length);
        QCOMPARE(editor().rate()->value(), rates.last());
    }

    void undoOnTheMapStaysUndo()
    {
        enter(Situation::Stopped, {u"nav_motion"_s, u"more"_s, u"mapButton"_s});
        const double before = editor().rate()->value();
        editor().rate()->set(390); // not possible: going back to it, a suggestion comes
        editor().rate()->set(100);
        m_window->settle();
        const QPoint undo = centerOf(u"regimeUndo"_s);
        click(undo);
        QCOMPARE(editor().rate()->value(), 390.0);
        QVERIFY(m_window->find(u"regimeSuggestion"_s));
        click(undo);
        QCOMPARE(editor().rate()->value(), before);
    }
};

CAMPANEL_TEST(TestPanelCommands)

} // namespace test_panel_commands

#include "test_panel_commands.moc"
