// SPDX-License-Identifier: Apache-2.0
// The whole panel in a window, operated by a TouchDriver, on the demonstration link: keypad, pins, handles,
// navigation, Stop, language.
#include "panel_test.h"

#include "profile/segments/segments_csv.h"
#include "tests/looks/checks/screen_checks.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QJSValue>
#include <QTemporaryDir>

#include <cmath>

namespace test_panel {

using Kind = campanel::looks::DemoLink::Kind;
namespace panel = campanel::panel;
namespace program = campanel::program;

class TestPanel : public campanel::test::PanelTest {
    Q_OBJECT

    QList<double> knots(QString panel::KnotRow::*text)
    {
        QList<double> values;
        for (const panel::KnotRow& row : editor().knots()->rows()->rows())
            values << QLocale().toDouble(row.*text);
        return values;
    }

private slots:
    void paleTextIsFound()
    {
        const campanel::looks::ScreenLimits anySize;
        QCOMPARE(checkScreen(m_window->root(), anySize, m_window->grab()), QStringList());
        m_window->find(QStringLiteral("stateText"))->setProperty("color", QColor(0x98, 0x98, 0x98));
        const QStringList faults = checkScreen(m_window->root(), anySize, m_window->grab());
        QCOMPARE(faults.size(), 1);
        QCOMPARE(
            faults.constFirst(),
            QStringLiteral("stateText \"Running\" in #989898 on #ffffff has a contrast of 2.88, it needs 3"));
    }

    void keypadTakesANumber()
    {
        tap("nav_motion");
        tap("field_bag_length_mm");
        m_window->type(QStringLiteral("262.5"));
        QCOMPARE(textOf("keypadText"), QStringLiteral("262.5"));
        tap("keypadAccept");
        QCOMPARE(editor().bagLength()->value(), 262.5);
        QVERIFY(!m_window->find(QStringLiteral("keypad")));
    }

    void keypadRefusesWithTheLimit()
    {
        tap("nav_motion");
        tap("field_bag_length_mm");
        m_window->type(QStringLiteral("99999"));
        QVERIFY2(textOf("keypadHint").contains(QStringLiteral("2000")), qPrintable(textOf("keypadHint")));
        QVERIFY(!m_window->find(QStringLiteral("keypadAccept"))->isEnabled());
        tap("keypadCancel");
        QCOMPARE(editor().bagLength()->value(), 250.0);
    }

    void keypadLeavesItsFieldAndStopFree_data()
    {
        QTest::addColumn<QStringList>("way");
        QTest::newRow("bag length") << QStringList{"nav_motion", "field_bag_length_mm"};
        QTest::newRow("film speed") << QStringList{"nav_motion", "field_film_speed_mm_per_s"};
        QTest::newRow("machine parameter")
            << QStringList{"nav_settings", "section2", "field_knife_radius_mm"};
    }
    void keypadLeavesItsFieldAndStopFree()
    {
        QFETCH(QStringList, way);
        for (const QString& name : way)
            m_window->tap(name);
        const auto rectOf = [this](const QString& name) {
            const QQuickItem* item = m_window->find(name);
            return item->mapRectToScene(item->boundingRect());
        };
        const QRectF keypad = rectOf(QStringLiteral("keypad"));
        QVERIFY(!keypad.intersects(rectOf(way.constLast())));
        QVERIFY(!keypad.intersects(rectOf(QStringLiteral("stopKey"))));
        QVERIFY(!keypad.intersects(rectOf(QStringLiteral("startKey"))));
    }

    void enteringADerivedValuePinsIt()
    {
        tap("nav_motion");
        QVERIFY(editor().filmSpeed()->derived());
        tap("field_film_speed_mm_per_s");
        m_window->type(QStringLiteral("300"));
        tap("keypadAccept");
        QVERIFY(editor().filmSpeed()->pinned());
        QCOMPARE(editor().filmSpeed()->value(), 300.0);
        tap("undo");
        QVERIFY(editor().filmSpeed()->derived());
        tap("redo");
        QVERIFY(editor().filmSpeed()->pinned());
    }

    void holdingADerivedValueExplainsIt()
    {
        tap("nav_motion");
        m_window->hold(QStringLiteral("field_base_speed_mm_per_s"));
        QVERIFY(m_window->find(QStringLiteral("sheetPanel")));
        tap("sheetClose");
        QVERIFY(!m_window->find(QStringLiteral("sheetPanel")));
    }

    void aHandleMovesItsRatio()
    {
        tap("nav_motion");
        const double before = editor().k2()->value();
        const double first = editor().k1()->value();
        const QPoint handle = centerOf(QStringLiteral("handle1"));
        QTest::mousePress(&m_window->window(), Qt::LeftButton, {}, handle);
        QTest::mouseMove(&m_window->window(), handle - QPoint(15, 0));
        QTest::mouseMove(&m_window->window(), handle - QPoint(30, 0));
        QTest::mouseRelease(&m_window->window(), Qt::LeftButton, {}, handle - QPoint(30, 0));
        QVERIFY2(editor().k2()->value() > before, "an earlier end of the ramp is a larger k");
        QCOMPARE(editor().k1()->value(), first);
        m_window->settle();
        QVERIFY((centerOf(QStringLiteral("handle1")) - handle).manhattanLength() > 20);
        tap("undo");
        QCOMPARE(editor().k2()->value(), before);
    }

    void aNewProgramOfEachKind_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("shown");
        QTest::newRow("cutter") << 1 << QStringLiteral("field_bag_length_mm");
        QTest::newRow("position move") << 2 << QStringLiteral("field_distance_mm");
        QTest::newRow("speed move") << 3 << QStringLiteral("field_end_speed_mm_per_s");
        QTest::newRow("point cam") << 4 << QStringLiteral("knotsButton");
        QTest::newRow("press") << 5 << QStringLiteral("field_approach_position_mm");
    }
    void aNewProgramOfEachKind()
    {
        QFETCH(int, kind);
        QFETCH(QString, shown);
        const int before = kind == 1 ? 2 : 1;
        editor().newProgram(before);
        tap("nav_motion");
        tap("more");
        tap("kindButton");
        tap(qPrintable(QStringLiteral("choice_%1").arg(kind)));
        QCOMPARE(static_cast<int>(editor().kind()), kind);
        QVERIFY2(!m_window->find(QStringLiteral("sheetPanel")), "the choice closes its sheet");
        QVERIFY2(m_window->find(shown), qPrintable(shown));
        QVERIFY(editor().feasible());
        tap("undo");
        QCOMPARE(static_cast<int>(editor().kind()), before);
    }

    void aKnotFollowsTheFinger()
    {
        editor().newProgram(4);
        tap("nav_motion");
        const QList<double> before = knots(&panel::KnotRow::slaveText);
        const QPoint handle = centerOf(QStringLiteral("handle1"));
        QTest::mousePress(&m_window->window(), Qt::LeftButton, {}, handle);
        QTest::mouseMove(&m_window->window(), handle - QPoint(0, 8));
        QTest::mouseMove(&m_window->window(), handle - QPoint(0, 16));
        QTest::mouseRelease(&m_window->window(), Qt::LeftButton, {}, handle - QPoint(0, 16));
        const QList<double> after = knots(&panel::KnotRow::slaveText);
        QVERIFY2(after[1] > before[1] + 1, "a finger that goes up lifts the knot");
        QCOMPARE(after[2], before[2]);
        tap("undo");
        QCOMPARE(knots(&panel::KnotRow::slaveText), before);
    }

    void knotsAreAddedRemovedAndRepaired()
    {
        editor().newProgram(4);
        tap("nav_motion");
        tap("knotsButton");
        QCOMPARE(editor().knots()->count(), 5);
        tap("knot1");
        tap("knotInsert");
        QCOMPARE(editor().knots()->count(), 6);
        QCOMPARE(knots(&panel::KnotRow::masterText)[2], 135.0);
        tap("knotRemove");
        QCOMPARE(editor().knots()->count(), 5);
        QVERIFY(!m_window->find(QStringLiteral("knotRemove"))->isEnabled());
        QVERIFY2(!m_window->find(QStringLiteral("knotRepair"))->isEnabled(), "nothing is broken yet");
        editor().setChoice(0, 0); // natural ends: speed jumps at the wrap
        m_window->settle();
        QVERIFY(editor().knots()->wrapText().contains(QStringLiteral("jumps")));
        tap("knotRepair");
        QVERIFY(!m_window->find(QStringLiteral("knotRepair"))->isEnabled());
    }

    void knotsComeFromAFileAndGoIntoOne()
    {
        const QTemporaryDir stick;
        QFile file(stick.filePath(QStringLiteral("cam.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("master_deg,slave_mm\n0,0\n60,3\n120,9\n200,8\n300,1\n360,0\n");
        file.close();
        editor().newProgram(4);
        panel::CamFiles& files = *editor().camFiles();
        files.setScanner([path = stick.path()](const QString&, const campanel::profile::Program& cam) {
            const QList<campanel::store::Place> places{{path, QStringLiteral("STICK"), false}};
            return panel::CamFiles::Found{places, campanel::store::offeredLists(places, cam)};
        });
        tap("nav_motion");
        tap("knotsButton");
        tap("knotFilesButton");
        m_window->waitFor(files);
        QVERIFY(!m_window->find(QStringLiteral("offerGo"))->isEnabled());
        tap("offer0");
        QVERIFY2(textOf("offerDetail").startsWith(QStringLiteral("6 knots")),
                 qPrintable(textOf("offerDetail")));
        QCOMPARE(editor().knots()->count(), 5);
        tap("offerGo");
        QCOMPARE(editor().knots()->count(), 6);
        QVERIFY2(m_window->find(QStringLiteral("knotList")), "back among the knots");
        tap("knotFilesButton");
        m_window->waitFor(files);
        tap("listExport");
        m_window->waitFor(files);
        tap("offer0");
        tap("offerGo");
        m_window->waitFor(files);
        const QString written = stick.filePath(editor().recipeName() + QStringLiteral(".csv"));
        QCOMPARE(textOf("offerDetail"), QStringLiteral("Written: ") + written);
        QVERIFY(QFile::exists(written));
        tap("sheetClose");
        tap("undo");
        QCOMPARE(editor().knots()->count(), 5);
    }

    void segmentsComeFromAFile()
    {
        const QTemporaryDir stick;
        QFile file(stick.filePath(QStringLiteral("cam.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        editor().newProgram(6);
        auto cam = std::get<campanel::profile::SegmentCamProgram>(editor().recipe().program);
        cam.segments[0].endMm = cam.segments[1].endMm = 40;
        file.write(QByteArray::fromStdString(campanel::profile::writeSegmentsCsv(cam.segments)));
        file.close();
        panel::CamFiles& files = *editor().camFiles();
        files.setScanner([path = stick.path()](const QString&, const campanel::profile::Program& program) {
            const QList<campanel::store::Place> places{{path, QStringLiteral("STICK"), false}};
            return panel::CamFiles::Found{places, campanel::store::offeredLists(places, program)};
        });
        tap("nav_motion");
        tap("segmentsButton");
        tap("segmentFilesButton");
        m_window->waitFor(files);
        tap("offer0");
        QVERIFY2(textOf("offerDetail").startsWith(QStringLiteral("4 segments, position 0 to 40 mm")),
                 qPrintable(textOf("offerDetail")));
        tap("offerGo");
        QVERIFY2(m_window->find(QStringLiteral("segmentList")), "back among the segments");
        const auto& taken = std::get<campanel::profile::SegmentCamProgram>(editor().recipe().program);
        QCOMPARE(taken.segments[0].endMm, 40.0);
        QVERIFY(taken.segments == cam.segments);
    }

    void aCorrectedFileIsReadAgain()
    {
        const QTemporaryDir stick;
        const QString path = stick.filePath(QStringLiteral("cam.csv"));
        const auto write = [&path](const QByteArray& knots) {
            QFile file(path);
            return file.open(QIODevice::WriteOnly) && file.write("master_deg,slave_mm\n" + knots) > 0;
        };
        QVERIFY(write("0,0\n60,3\n50,9\n200,8\n300,1\n360,0\n"));
        editor().newProgram(4);
        panel::CamFiles& files = *editor().camFiles();
        files.setScanner([path = stick.path()](const QString&, const campanel::profile::Program& cam) {
            const QList<campanel::store::Place> places{{path, QStringLiteral("STICK"), false}};
            return panel::CamFiles::Found{places, campanel::store::offeredLists(places, cam)};
        });
        tap("nav_motion");
        tap("knotsButton");
        tap("knotFilesButton");
        m_window->waitFor(files);
        tap("offer0");
        QVERIFY(textOf("offerDetail").startsWith(QStringLiteral("Line 4")));
        QVERIFY(!m_window->find(QStringLiteral("offerGo"))->isEnabled());
        QVERIFY(write("0,0\n60,3\n120,9\n200,8\n300,1\n360,0\n"));
        QTRY_VERIFY(m_window->find(QStringLiteral("offerGo"))->isEnabled());
        QVERIFY(textOf("offerDetail").startsWith(QStringLiteral("6 knots")));
        tap("offerGo");
        QCOMPARE(editor().knots()->count(), 6);
    }

    void aLawThatBreaksALimitCanBeHeldButNotChosen()
    {
        editor().rate()->set(390);
        tap("nav_motion");
        tap("lawButton");
        QString lawId;
        for (const panel::LawRow& law : editor().laws()->rows()) {
            if (lawId.isEmpty() && !law.usable && !law.current)
                lawId = law.lawId;
        }
        QVERIFY2(!lawId.isEmpty(), "no law breaks a limit");
        const QString before = editor().lawName();
        tap(qPrintable(QStringLiteral("law_") + lawId));
        QCOMPARE(editor().lawName(), before);
        m_window->hold(QStringLiteral("law_") + lawId);
        QVERIFY(!editor().overlayName().isEmpty());
        QCOMPARE(editor().lawName(), before);
    }

    void theRecipeOfTheControllerIsNamedWhenItIsAnother()
    {
        QVERIFY(!m_window->find(QStringLiteral("openTitle")));
        show(Kind::Press);
        QCOMPARE(textOf("recipeTitle"), QStringLiteral("Bearing 6204 · v1"));
        QVERIFY(m_window->find(QStringLiteral("openTitle")));
    }

    void theMasterIsTurnedByATouch()
    {
        show(Kind::PointCam);
        tap("nav_run");
        QCOMPARE(textOf("directionText"), QStringLiteral("runs forward"));
        tap("directionBackward");
        QTest::qWait(700);
        QCOMPARE(textOf("directionText"), QStringLiteral("runs forward"));
        holdFor("directionBackward", 700);
        QCOMPARE(textOf("directionText"), QStringLiteral("Changing to reverse …"));
        m_window->link().show(campanel::looks::DemoLink::Situation::Lost, Kind::PointCam);
        m_window->settle();
        QVERIFY(!m_window->find(QStringLiteral("directionChoice"))->isEnabled());
        QCOMPARE(textOf("directionText"), QStringLiteral("There is no connection to the controller."));
    }

    void aHeldLawIsDrawnBehind()
    {
        editor().newProgram(2);
        tap("nav_motion");
        tap("lawButton");
        m_window->hold(QStringLiteral("law_cubic"));
        QCOMPARE(editor().overlayName(), QStringLiteral("Cubic"));
        m_window->hold(QStringLiteral("law_cubic"));
        QCOMPARE(editor().overlayName(), QString());
    }

    void runShowsThePress()
    {
        show(Kind::Press);
        QCOMPARE(textOf("pressForce"), QStringLiteral("3,900"));
        QCOMPARE(textOf("pressPosition"), QStringLiteral("100.00"));
        QCOMPARE(textOf("goodStrokes"), QStringLiteral("23 / 24"));
        QVERIFY(m_window->find(QStringLiteral("stage3"))->property("current").toBool());
        QVERIFY(!m_window->find(QStringLiteral("stage2"))->property("current").toBool());
        QVERIFY(m_window->find(QStringLiteral("stroke0"))->property("good").toBool());
        const QQuickItem* bad = m_window->find(QStringLiteral("stroke3"));
        QVERIFY(!bad->property("good").toBool());
        QCOMPARE(bad->property("resultText").toString(), QStringLiteral("Force too low"));
        const auto curve =
            m_window->find(QStringLiteral("forcePlot"))->property("curve").value<QList<QPointF>>();
        QVERIFY(curve.size() > 100);
        QVERIFY2(std::abs(curve.constLast().x() - 100) < 0.1, "it stands in its hold");
        QVERIFY(!m_window->find(QStringLiteral("axisSpeed")));
    }

    void runShowsWhatEachKindHas_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QStringList>("shown");
        QTest::addColumn<QStringList>("hidden");
        const QStringList axis{"axisSpeed", "axisPosition", "axisCount"};
        QTest::newRow("position move") << 2 << axis << QStringList{"masterSpeed", "pressForce", "bagChart"};
        QTest::newRow("speed move") << 3 << axis << QStringList{"masterSpeed", "pressForce", "bagChart"};
        QTest::newRow("point cam") << 4 << axis + QStringList{"masterSpeed"}
                                   << QStringList{"pressForce", "bagChart"};
        QTest::newRow("cutter") << 1 << QStringList{"bagChart"} << axis;
    }
    void runShowsWhatEachKindHas()
    {
        QFETCH(int, kind);
        QFETCH(QStringList, shown);
        QFETCH(QStringList, hidden);
        show(static_cast<Kind>(kind));
        for (const QString& name : shown)
            QVERIFY2(m_window->find(name), qPrintable(name));
        for (const QString& name : hidden)
            QVERIFY2(!m_window->find(name), qPrintable(name));
    }

    void stopIsReachedOverDialogsAndKeypad_data()
    {
        QTest::addColumn<QStringList>("way");
        QTest::newRow("run") << QStringList{"nav_run"};
        QTest::newRow("settings") << QStringList{"nav_settings"};
        QTest::newRow("search") << QStringList{"nav_maintenance", "doctorSearch"};
        QTest::newRow("keypad") << QStringList{"nav_motion", "field_rate_bags_per_min"};
        QTest::newRow("dialog") << QStringList{"nav_motion", "lawButton"};
        QTest::newRow("dialog from a dialog") << QStringList{"nav_motion", "more", "tableButton"};
    }
    void stopIsReachedOverDialogsAndKeypad()
    {
        QFETCH(QStringList, way);
        if (way.contains(QStringLiteral("doctorSearch"))) // not while the machine runs
            m_window->link().show(campanel::looks::DemoLink::Situation::Stopped);
        for (const QString& name : way)
            m_window->tap(name);
        const qsizetype before = m_window->link().stopRequests();
        tap("stopKey");
        QCOMPARE(m_window->link().stopRequests(), before + 1);
    }

    void aSectionWithinAnotherHasAWayBack()
    {
        for (const auto& [section, opened] : {std::pair{"section0", "sectionSystem"},
                                              {"section2", "openStops"},
                                              {"section2", "openPermit"}}) {
            tap("nav_settings");
            tap(section);
            QVERIFY(!m_window->find(QStringLiteral("sectionBack")));
            tap(opened);
            QVERIFY(!m_window->find(QString::fromLatin1(opened)));
            tap("sectionBack");
            QVERIFY(m_window->find(QString::fromLatin1(opened)));
        }
    }

    void theDrawingMarksTheChosenField()
    {
        const auto marked = [this] {
            const QQuickItem* drawing = m_window->find(QStringLiteral("machineDrawing"));
            return drawing ? drawing->property("marked").value<QJSValue>().toVariant().toStringList()
                           : QStringList("no drawing");
        };
        tap("nav_settings");
        tap("section2");
        QCOMPARE(marked(), QStringList());
        for (const auto& [field, part] :
             {std::pair{"field_knife_radius_mm", "radius"}, {"field_knives", "knives"}}) {
            tap(field);
            tap("keypadCancel");
            QCOMPARE(marked(), QStringList(QString::fromLatin1(part)));
        }
        // Every field of the machine's data has its part.
        const QQuickItem* drawing = m_window->find(QStringLiteral("machineDrawing"));
        QVERIFY(drawing);
        const QVariantMap parts = drawing->property("parts").value<QJSValue>().toVariant().toMap();
        for (const program::KindInfo& kind : program::kinds()) {
            editor().newProgram(static_cast<int>(kind.kind));
            for (const QVariant& field : editor().machineFields()) {
                const QString id = field.value<panel::EditorField*>()->fieldId();
                QVERIFY2(parts.contains(id), qPrintable(id));
            }
        }
    }

    void languageChangesAtOnce()
    {
        QCOMPARE(textOf("stopKey"), QStringLiteral("Stop"));
        m_window->panel().settings().set("display.language", QStringLiteral("zh_CN"));
        m_window->settle();
        QCOMPARE(textOf("stopKey"), QString::fromUtf8("停止"));
        QCOMPARE(textOf("stateText"), QString::fromUtf8("运行"));
        m_window->panel().settings().set("display.language", QStringLiteral("en"));
        m_window->settle();
        QCOMPARE(textOf("stateText"), QStringLiteral("Running"));
    }

    void onlyTheRunPageIsMadeAtStart()
    {
        QVERIFY(!m_window->root().findChild<QObject*>(QStringLiteral("motionPlot")));
        tap("nav_motion");
        QVERIFY(m_window->find(QStringLiteral("motionPlot")));
    }

    void whatIsRefusedIsSeenWhereverTheFingerWas_data()
    {
        QTest::addColumn<QStringList>("way");
        QTest::addColumn<bool>("isFirstStart");
        const QString start = QStringLiteral("startKey");
        const QString motion = QStringLiteral("nav_motion");
        QTest::newRow("first start") << QStringList{start} << true;
        QTest::newRow("Run") << QStringList{start} << false;
        QTest::newRow("Motion") << QStringList{motion, start} << false;
        QTest::newRow("sheet") << QStringList{motion, QStringLiteral("nextStep"), start} << false;
        QTest::newRow("keypad") << QStringList{motion, QStringLiteral("field_bag_length_mm"), start} << false;
    }

    void whatIsRefusedIsSeenWhereverTheFingerWas()
    {
        QFETCH(QStringList, way);
        QFETCH(bool, isFirstStart);
        m_window->link().show(campanel::looks::DemoLink::Situation::Empty);
        if (isFirstStart)
            m_window->panel().settings().beginFirstStart();
        m_window->settle();
        for (const QString& name : way)
            m_window->tap(name);
        QCOMPARE(textOf("banner"), QStringLiteral("The controller has no program. Download a recipe first."));
        const QQuickItem* banner = m_window->find(QStringLiteral("banner"));
        const QRectF notice = banner->mapRectToScene(banner->boundingRect());
        for (const char* name : {"nextStep", "downloadStart", "firstNext", "firstDownload", "keypadAccept"}) {
            if (const QQuickItem* wanted = m_window->find(QString::fromLatin1(name)))
                QVERIFY2(!notice.intersects(wanted->mapRectToScene(wanted->boundingRect())), name);
        }
        tap("bannerButton"); // nothing is above it
        QVERIFY(!m_window->find(QStringLiteral("banner")));
    }

    void whatStoodOnThePageDoesNotCoverASheet()
    {
        m_window->link().show(campanel::looks::DemoLink::Situation::Empty);
        m_window->settle();
        for (const char* name : {"nav_motion", "startKey", "nextStep"})
            tap(name);
        QVERIFY(!m_window->find(QStringLiteral("banner")));
        tap("startKey");
        QVERIFY(m_window->find(QStringLiteral("banner")));
        tap("bannerButton");
        tap("downloadCancel");
        QVERIFY(!m_window->find(QStringLiteral("banner")));
    }

    // Power-on with an empty controller: the next step is a key on Run, Motion and the sheet.
    void withoutAProgramTheNextStepIsAKey()
    {
        m_window->link().show(campanel::looks::DemoLink::Situation::Empty);
        m_window->settle();
        for (const char* name : {"nav_run", "openMotion", "nextStep"})
            tap(name);
        QVERIFY(m_window->find(QStringLiteral("downloadStart")));
    }

    void homeIsOfferedWhenTheControllerTakesIt()
    {
        m_window->link().show(campanel::looks::DemoLink::Situation::Empty);
        m_window->settle();
        QVERIFY(!m_window->find(QStringLiteral("middleKey")));
        m_window->link().show(campanel::looks::DemoLink::Situation::Fresh);
        m_window->settle();
        QCOMPARE(textOf("middleKey"), QStringLiteral("Reference run"));
        m_window->link().show(campanel::looks::DemoLink::Situation::Running);
        m_window->settle();
        QVERIFY(!m_window->find(QStringLiteral("middleKey")));
        m_window->link().show(campanel::looks::DemoLink::Situation::Fault);
        m_window->settle();
        QCOMPARE(textOf("middleKey"), QStringLiteral("Reset"));
    }

    // Half a second under a filling ring; the machine starts once, while the finger is still there.
    void startIsHeld()
    {
        const QString key = QStringLiteral("startKey");
        m_window->link().show(campanel::looks::DemoLink::Situation::Stopped);
        m_window->settle();
        m_window->panel().settings().set("access.hold_to_start", QStringLiteral("on"));
        int starts = 0;
        QObject::connect(&m_window->link(), &campanel::link::Link::commandEnded, m_window->root().window(),
                         [&](const campanel::link::CommandOutcome& outcome) {
                             starts += outcome.command == campanel::modbus::Command::Start ? 1 : 0;
                         });
        tap("startKey"); // too short
        QTest::qWait(600);
        QCOMPARE(starts, 0);
        QVERIFY(!m_window->find(QStringLiteral("banner")));

        m_window->touch(key); // the finger leaves the key
        QTRY_VERIFY(m_window->find(QStringLiteral("holdRing")));
        m_window->slide({10, 300});
        QTest::qWait(600);
        m_window->lift();
        QCOMPARE(starts, 0);
        QVERIFY(!m_window->find(QStringLiteral("holdRing")));

        m_window->touch(key);
        QTest::qWait(300);
        QCOMPARE(starts, 0);
        QTRY_COMPARE(starts, 1);
        QVERIFY(!m_window->find(QStringLiteral("holdRing")));
        QTest::qWait(600);
        m_window->lift();
        QCOMPARE(starts, 1);
        QVERIFY(!m_window->find(QStringLiteral("banner")));
    }

    void aTapStartsWithoutHolding()
    {
        m_window->link().show(campanel::looks::DemoLink::Situation::Stopped);
        m_window->settle();
        QVERIFY(!m_window->panel().settings().startIsHeld()); // the simulated controller
        int starts = 0;
        QObject::connect(&m_window->link(), &campanel::link::Link::commandEnded, m_window->root().window(),
                         [&](const campanel::link::CommandOutcome& outcome) {
                             starts += outcome.command == campanel::modbus::Command::Start ? 1 : 0;
                         });
        tap("startKey");
        QTRY_COMPARE(starts, 1);
    }

    void startRefusedSaysWhy()
    {
        tap("startKey");
        const QQuickItem* banner = m_window->find(QStringLiteral("banner"));
        QVERIFY(banner);
        QVERIFY(!banner->property("text").toString().isEmpty());
    }
};

CAMPANEL_TEST(TestPanel)

} // namespace test_panel

#include "test_panel.moc"
