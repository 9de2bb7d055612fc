// SPDX-License-Identifier: Apache-2.0
// The sentences of Run, by touch: none that is not so, scrap is called scrap, a short gap of the line leaves
// the page as it is, a lost program comes back by one key, a number is changed where it stands, and
// a cam says what the line that leads it does.
#include "panel_test.h"

#include "tests/looks/demo_packing.h"
#include "tests/support/test_program.h"

namespace test_panel_run {

using namespace campanel;
using namespace Qt::StringLiterals;
using Situation = looks::DemoLink::Situation;

class TestPanelRun : public test::PanelTest {
    Q_OBJECT

    panel::Controller& controller() { return m_window->panel().controller(); }

    void enter(Situation situation)
    {
        m_window->link().show(situation);
        m_window->checkClock();
        m_window->settle();
        tap("nav_run");
    }
    static void collect(const QQuickItem& below, QStringList& texts)
    {
        if (!below.isVisible() || below.opacity() == 0)
            return;
        if (below.inherits("QQuickText"))
            texts << below.property("text").toString();
        for (const QQuickItem* child : below.childItems())
            collect(*child, texts);
    }
    // Returns all texts in the window, a line each.
    QString texts()
    {
        m_window->settle();
        QStringList found;
        collect(m_window->root(), found);
        return found.join(u'\n');
    }
    void sendStatus(const modbus::StatusBlock& status)
    {
        emit m_window->link().statusReceived({{{m_window->link().now(), status}}, 0});
    }
    // Another program of the same data takes over, as after a change of length.
    void changeProgram()
    {
        const panel::ControllerProgram program = *controller().program();
        modbus::StatusBlock status = *controller().status();
        ++status.generation;
        sendStatus(status);
        emit m_window->link().programRead({status.generation, program.crc, program.registers, program.list});
    }
    // The controller reports one more bag.
    void cutBag(modbus::BagBit bit)
    {
        looks::DemoFilm film;
        film.bags = controller().packing()->status()->bagNumber + 1;
        std::vector<std::uint16_t> registers = looks::demoPacker(film);
        const std::size_t at = modbus::findRegister("packer.bags")->address - modbus::packerAddress +
                               4 * (film.bags % modbus::bagRecords);
        registers[at + 3] = static_cast<std::uint16_t>(1U << 8U | 1U << static_cast<unsigned>(bit));
        emit m_window->link().registersRead({{0, modbus::packerAddress, modbus::packerRegisters()},
                                             link::ReadEnd::Done,
                                             registers,
                                             m_window->link().now(),
                                             std::nullopt});
        m_window->settle();
    }
    void loseLine(std::chrono::milliseconds silence)
    {
        link::LinkReport report = controller().report();
        report.state = link::LinkState::Lost;
        m_window->link().advance(silence);
        emit m_window->link().reported(report);
        m_window->checkClock();
        m_window->settle();
    }
    void findLine()
    {
        link::LinkReport report = controller().report();
        report.state = link::LinkState::Connected;
        emit m_window->link().reported(report);
        const panel::ControllerProgram program = *controller().program();
        sendStatus(*controller().status());
        emit m_window->link().programRead({program.generation, program.crc, program.registers, program.list});
        m_window->settle();
    }
    QRectF placeOf(const char* name)
    {
        const QQuickItem* item = m_window->find(QString::fromLatin1(name));
        return item ? item->mapRectToScene(item->boundingRect()) : QRectF();
    }

private slots:
    void aRunningMachineIsNotToldToStart()
    {
        enter(Situation::Running);
        changeProgram();
        const QString shown = texts();
        QVERIFY2(!shown.contains(u"Press Start"_s), qPrintable(shown));
        QVERIFY2(shown.contains(u"Running; first bag not measured yet"_s), qPrintable(shown));
    }

    void scrapIsCalledScrap()
    {
        enter(Situation::Running);
        QCOMPARE(propertyOf("bagLength", "title"), u"Bag length"_s);
        cutBag(modbus::BagBit::StartUp);
        QCOMPARE(propertyOf("bagLength", "title"), u"Scrap bag"_s);
        QVERIFY(m_window->find(u"scrapHatch"_s));
        cutBag(modbus::BagBit::Tracked);
        QCOMPARE(propertyOf("bagLength", "title"), u"Bag length"_s);
        QVERIFY(!m_window->find(u"scrapHatch"_s));
    }

    void beforeTheFirstStartMarksAreNotOff()
    {
        enter(Situation::Fresh);
        QCOMPARE(textOf("markState"), u"Marks not searched for yet"_s);
        QCOMPARE(m_window->find(u"filmPicture"_s)->property("sensor").toDouble(), 900.0);
    }

    void aShortGapLeavesBagsAndPageAsTheyAre()
    {
        using namespace std::chrono_literals;
        enter(Situation::Running);
        QCOMPARE(controller().bags().series.size(), 60);
        const QString figures = textOf("lastDeviation");
        const QRectF film = placeOf("filmCard");
        loseLine(2s);
        QCOMPARE(placeOf("filmCard"), film);
        findLine();
        QCOMPARE(controller().bags().series.size(), 60);
        QCOMPARE(textOf("lastDeviation"), figures);
        // A longer one is told.
        loseLine(4s);
        QVERIFY2(textOf("banner").startsWith(u"No connection since"_s), qPrintable(textOf("banner")));
    }

    void aLostProgramComesBackByOneKey()
    {
        enter(Situation::Stopped);
        modbus::StatusBlock status = *controller().status();
        status.uptimeS = 1;
        status.state = modbus::State::Idle;
        status.generation = 0;
        status.activeCrc.reset();
        status.savedCrc.reset();
        sendStatus(status);
        emit m_window->link().programRead({});
        const QString shown = texts();
        QVERIFY2(shown.contains(u"has lost its program"_s), qPrintable(shown));
        QCOMPARE(textOf("downloadAgain"), u"Download Biscuit 250 v1"_s);
        tap("downloadAgain");
        QCOMPARE(editor().programDownload()->state(), panel::ProgramDownload::State::Transferring);
    }

    void aNumberIsChangedWhereItStands_data()
    {
        QTest::addColumn<QString>("card");
        QTest::addColumn<QString>("field");
        QTest::addColumn<double>("after");
        QTest::addRow("length") << u"bagNumbers"_s << u"bag_length_mm"_s << 251.0;
        QTest::addRow("rate") << u"packingRate"_s << u"rate_bags_per_min"_s << 61.0;
    }
    // Three touches: the number, a step, Apply.
    void aNumberIsChangedWhereItStands()
    {
        QFETCH(QString, card);
        QFETCH(QString, field);
        QFETCH(double, after);
        enter(Situation::Running);
        const double before = editor().field(field)->value();
        m_window->hold(card);
        QVERIFY2(m_window->find(u"sheetPanel"_s), "a held finger explains");
        tap("sheetClose");
        m_window->tap(card);
        QVERIFY2(!m_window->find(u"changeApply"_s)->isEnabled(), "nothing is changed");
        tap("changeMore");
        QCOMPARE(editor().field(field)->value(), after);
        QVERIFY2(m_window->find(u"changeFilm"_s), "what the change does is drawn");
        // The film's speed is length times rate.
        const QList<QPointF> speeds = editor().programDownload()->changeSpeeds();
        QCOMPARE(speeds.size(), 3);
        QCOMPARE(speeds.first(), QPointF(0, 100));
        QVERIFY(speeds[1].y() <= 100);
        QVERIFY(qAbs(speeds.last().y() - 100 * after / before) < 1e-6);
        QVERIFY(!textOf("changeText").isEmpty());
        // The film has the cuts of both programs, with the scrap between them.
        const auto film = m_window->find(u"changeFilm"_s)->property("cuts").value<QList<QPointF>>();
        QVERIFY(film.first().y() == 0 && film.at(1).y() == 3 && film.last().y() == 2);
        QVERIFY(qAbs(film.last().x() - film.at(film.size() - 2).x() - editor().bagLength()->value()) < 1e-6);
        const bool isLength = field == u"bag_length_mm";
        QCOMPARE(propertyOf("changeFilm", "nextText"), isLength ? u"← 251\u00A0mm"_s : QString());
        tap("changeApply");
        QCOMPARE(editor().programDownload()->state(), panel::ProgramDownload::State::Transferring);
    }

    void whatIsNotAppliedIsNotKept()
    {
        enter(Situation::Running);
        const double before = editor().field(u"bag_length_mm"_s)->value();
        const int undo = editor().undoLevel();
        const QString name = editor().recipeName();
        m_window->tap(u"bagNumbers"_s);
        tap("changeStep2");
        tap("changeMore");
        tap("changeMore");
        QCOMPARE(editor().field(u"bag_length_mm"_s)->value(), before + 20);
        tap("changeCancel");
        QCOMPARE(editor().field(u"bag_length_mm"_s)->value(), before);
        QCOMPARE(editor().undoLevel(), undo);
        QCOMPARE(editor().recipeName(), name);
        m_window->tap(u"bagNumbers"_s);
        tap("changeKeypad");
        m_window->type(u"190"_s);
        tap("keypadAccept");
        QCOMPARE(editor().field(u"bag_length_mm"_s)->value(), 190.0);
        QVERIFY2(m_window->find(u"changeApply"_s)->isEnabled(), "the sheet is still open");
        tap("sheetClose");
        QCOMPARE(editor().field(u"bag_length_mm"_s)->value(), before);
    }

    // A code may be scanned while the sheet is open: its recipe is not undone with the sheet's edits.
    void anotherRecipeEndsTheChange()
    {
        enter(Situation::Running);
        m_window->tap(u"bagNumbers"_s);
        tap("changeMore");
        program::Recipe other = editor().recipe();
        other.name = "Rusk";
        other.cutter().bagLengthMm = 190;
        editor().open(other);
        tap("changeCancel");
        QCOMPARE(editor().recipeName(), u"Rusk"_s);
        QCOMPARE(editor().field(u"bag_length_mm"_s)->value(), 190.0);
    }

    void whatTheMachineCannotDoIsRefusedInTheSheet()
    {
        enter(Situation::Running);
        m_window->tap(u"packingRate"_s);
        tap("changeKeypad");
        m_window->type(u"390"_s);
        tap("keypadAccept");
        QVERIFY(!m_window->find(u"changeApply"_s)->isEnabled());
        QVERIFY2(!textOf("changeText").startsWith(u"Not possible"_s), "the reason is told");
        tap("changeSuggestion");
        QVERIFY(m_window->find(u"changeApply"_s)->isEnabled());
        tap("changeCancel");
    }

    void aCamShowsTheLine_data()
    {
        QTest::addColumn<looks::DemoLink::Kind>("kind");
        QTest::newRow("point cam") << looks::DemoLink::Kind::PointCam;
        QTest::newRow("segment cam") << looks::DemoLink::Kind::SegmentCam;
    }

    void aCamShowsTheLine()
    {
        QFETCH(const looks::DemoLink::Kind, kind);
        m_window->link().show(Situation::Running, kind);
        m_window->checkClock();
        tap("nav_run");
        QCOMPARE(propertyOf("masterSpeed", "note"), QString());
        tap("masterSpeed");
        QVERIFY(controller().commandMessage().isEmpty());
        m_window->link().setLed(true);
        QTRY_COMPARE(plain(propertyOf("masterSpeed", "note")), u"Engaged · 250 mm/s"_s);
        QVERIFY(!m_window->find(u"directionChoice"_s)->isEnabled());
        QCOMPARE(textOf("directionText"), u"The line sets the direction: an encoder leads the machine."_s);
        tap("masterSpeed");
        const QString reason = plain(controller().commandMessage());
        QVERIFY2(reason.startsWith(u"The line sets the rate: an encoder leads the machine."),
                 qPrintable(reason));
        QVERIFY2(reason.endsWith(u"Engaged · 250 mm/s. Encoder at 265°, phase 0.00°."), qPrintable(reason));
    }
};

CAMPANEL_TEST(TestPanelRun)

} // namespace test_panel_run

#include "test_panel_run.moc"
