// SPDX-License-Identifier: Apache-2.0
// The knots of a point cam: entered, inserted, dragged, removed, repaired; and the texts for invalid ones.
#include "tests/app/panel/kind_steps.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_knots {

using namespace campanel;
using namespace campanel::test;
using panel::ProgramDownload;

class TestKnots : public QObject {
    Q_OBJECT

private slots:
    void knotsAreEnteredInsertedAndRemoved()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        KnotModel& knots = *rig.editor.knots();
        knots.select(1);
        QCOMPARE(knots.master()->value(), 90.0);
        QCOMPARE(knots.slave()->value(), 20.0);
        knots.slave()->set(22.5);
        knots.master()->set(80);
        QCOMPARE(knotText(knots, 1), "80.0 22.5");
        QVERIFY(!knots.master()->check(180).isEmpty()); // on its neighbor
        knots.insert(0.375);                            // 135 degrees of 1 s
        QCOMPARE(knots.count(), 6);
        QCOMPARE(knots.selected(), 2);
        QVERIFY(std::abs(knots.master()->value() - 135) < 1e-3);
        QVERIFY(knots.canRemove());
        knots.insertAfterSelected();
        QCOMPARE(knots.count(), 7);
        QCOMPARE(knots.selected(), 3);
        QVERIFY(std::abs(knots.master()->value() - 157.5) < 1e-3);
        knots.removeSelected();
        QCOMPARE(knots.count(), 6);
        for (int i = 0; i < 5; ++i)
            rig.editor.undo();
        QCOMPARE(knots.count(), 5);
        QCOMPARE(knotText(knots, 1), "90.0 20.0");
        knots.removeSelected(); // five is the minimum
        QCOMPARE(knots.count(), 5);
        knots.select(0);
        QVERIFY(!knots.canRemove());
        QVERIFY(!knots.master()->check(10).isEmpty()); // the first stays at 0
        knots.slave()->set(5);                         // a closed cam stays closed
        QCOMPARE(knotText(knots, 0), "0.0 5.0");
        QCOMPARE(knotText(knots, 4), "360.0 5.0");
        knots.select(4);
        knots.insertAfterSelected();
        QVERIFY(std::abs(knots.master()->value() - 315) < 1e-3);
        knots.select(99);
        QCOMPARE(knots.selected(), 4);
    }

    void aDraggedKnotIsOneStepOfUndo_data()
    {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("scale");
        QTest::newRow("forwards") << 60.0 << 1.0;
        QTest::newRow("backwards, twice as large") << -60.0 << 2.0;
        QTest::newRow("half the speed, mirrored") << 30.0 << -1.0;
    }

    void aDraggedKnotIsOneStepOfUndo()
    {
        QFETCH(double, rate);
        QFETCH(double, scale);
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        if (rate != 60)
            enter(rig.editor, Field::MasterRate, rate);
        if (scale != 1)
            enter(rig.editor, Field::SlaveScale, scale);
        const auto before = camOf(rig.editor).knots;
        KnotModel& knots = *rig.editor.knots();
        const double cycle = rig.editor.plot().cycleSeconds;
        const double timeBefore = knots.times()[2];
        knots.beginDrag(2);
        for (int step = 1; step <= 10; ++step)
            knots.drag(cycle * 0.005 * step, 0.4 * step);
        QVERIFY(std::abs(knots.times()[2] - timeBefore - cycle * 0.05) < 1e-4);
        knots.endDrag();
        const profile::Knot moved = camOf(rig.editor).knots[2];
        QVERIFY(std::abs(moved.masterDeg - (180 + (rate < 0 ? -18 : 18))) < 1e-3);
        QVERIFY(std::abs(moved.slaveMm - (50 + 4 / scale)) < 1e-2);
        rig.editor.undo();
        QVERIFY(camOf(rig.editor).knots == before);
        rig.editor.redo();
        QVERIFY(camOf(rig.editor).knots[2] == moved);
        // Beyond its neighbor it stops beside it.
        knots.beginDrag(2);
        knots.drag(10 * cycle, 0);
        knots.endDrag();
        const auto& after = camOf(rig.editor).knots;
        QVERIFY(after[2].masterDeg < after[3].masterDeg && after[2].masterDeg > after[1].masterDeg);
        // Touched without a drag.
        rig.editor.undo();
        QVERIFY(rig.editor.canRedo());
        knots.beginDrag(1);
        knots.endDrag();
        QVERIFY(rig.editor.canRedo());
    }

    void aWrapIsToldAndRepaired()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        KnotModel& knots = *rig.editor.knots();
        QCOMPARE(knots.wrapText(), "The cycle closes smoothly.");
        QVERIFY(!knots.canRepair());
        choose(rig.editor, "Spline ends", "Natural");
        QVERIFY2(knots.wrapText().contains("jumps by"), qPrintable(knots.wrapText()));
        QVERIFY(knots.canRepair());
        knots.repairWrap();
        QVERIFY(!knots.canRepair());
        QCOMPARE(camOf(rig.editor).ends, profile::SplineEnds::Periodic);
        knots.select(4);
        rig.editor.undo();
        knots.slave()->set(120); // not closed any more: a net advance
        knots.repairWrap();
        QVERIFY2(knots.wrapText().contains("advances by +120 mm"), qPrintable(knots.wrapText()));
    }

    void knotsStandWhereTheMasterPassesThem()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        QCOMPARE(rig.editor.knots()->times(), (QList<double>{0, 0.25, 0.5, 0.75, 1}));
        enter(rig.editor, Field::MasterRate, -60);
        QCOMPARE(rig.editor.knots()->times(), (QList<double>{1, 0.75, 0.5, 0.25, 0}));
        enter(rig.editor, Field::MasterRate, 60);
        enter(rig.editor, Field::Phase, 90);
        QCOMPARE(rig.editor.knots()->times()[2], 0.25);
        rig.editor.knots()->insert(0.125); // 45 degrees after the phase
        QVERIFY(std::abs(rig.editor.knots()->master()->value() - 135) < 1e-3);
    }

    void wrongKnotsAreSentences_data()
    {
        QTest::addColumn<QString>("knots"); // of a recipe file
        QTest::addColumn<QString>("words");
        QTest::newRow("four") << "[[0,0],[90,1],[180,2],[360,0]]"
                              << "The cam has 4 knots";
        QTest::newRow("backwards") << "[[0,0],[90,1],[80,2],[270,1],[360,0]]"
                                   << "Knot 3 at 80° must come after the previous knot at 90°";
        QTest::newRow("too close") << "[[0,0],[90,1],[90.01,2],[270,1],[360,0]]"
                                   << "Knot 3 is only 0.01°";
        QTest::newRow("beyond the cycle") << "[[0,0],[90,1],[180,2],[270,1],[400,0]]"
                                          << "Knot 5 at 400°";
        QTest::newRow("begins late") << "[[10,0],[90,1],[180,2],[270,1],[360,0]]"
                                     << "Knot 1 is at 10°; the cam needs a knot at 0°";
        QTest::newRow("too far") << "[[0,0],[90,1],[180,2000000],[270,1],[360,0]]"
                                 << "Knot 3 at";
        QTest::newRow("overshoot") << "[[0,0],[175,0],[180,50],[185,50],[360,0]]"
                                   << "Near knot";
    }

    void wrongKnotsAreSentences()
    {
        QFETCH(QString, knots);
        QFETCH(QString, words);
        QTemporaryDir folder;
        QFile file(folder.filePath("working_copy.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"format":"campanel-recipe","format_version":1,"name":"Cam","program":
            {"kind":"point_cam","master_rate_rev_per_min":1,"knots":)" +
                   knots.toUtf8() + "}}");
        file.close();
        test::FakeLink link;
        panel::Settings settings{folder.filePath("settings.ini"), nullptr};
        panel::Controller machine{link, settings, nullptr};
        Editor editor{machine, folder.path(), nullptr};
        QCOMPARE(editor.kind(), Editor::Kind::PointCam);
        QVERIFY(!editor.feasible());
        QVERIFY2(editor.verdict().contains(words), qPrintable(editor.verdict()));
        // An invalid cam is not edited knot by knot, and causes no error.
        editor.knots()->select(2);
        editor.knots()->insertAfterSelected();
        editor.knots()->beginDrag(2);
        editor.knots()->drag(0.1, 1);
        editor.knots()->endDrag();
        QVERIFY(!editor.knots()->wrapText().contains("nan"));
    }

    void aJumpAtTheWrapIsASentence()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        choose(rig.editor, "Spline ends", "Natural");
        enter(rig.editor, Field::MaxAcceleration, 5000);
        enter(rig.editor, Field::MasterRate, 100);
        QVERIFY2(rig.editor.verdict().contains("at the end of the cycle. Choose periodic ends"),
                 qPrintable(rig.editor.verdict()));
        choose(rig.editor, "Spline ends", "Periodic");
        QVERIFY2(rig.editor.feasible(), qPrintable(rig.editor.verdict()));
    }

    void movedKnotsAreADifference()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        rig.connectIdle();
        rig.link.activate(rig.image(), rig.now);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::NothingToDo);
        rig.editor.knots()->select(2);
        rig.editor.knots()->slave()->set(51);
        QCOMPARE(rig.editor.programDownload()->state(), ProgramDownload::State::Ready);
        QCOMPARE(rig.editor.programDownload()->differenceCount(), 1);
        QCOMPARE(rig.editor.programDownload()->differences()->rows().first().name, "Knots");
        enter(rig.editor, Field::MasterRamp, 1.5);
        QCOMPARE(rig.editor.programDownload()->differenceCount(), 2);
        QCOMPARE(rig.editor.programDownload()->differences()->rows().first().editedText, "1.50 s");
    }
};

CAMPANEL_TEST(TestKnots)

} // namespace test_knots

#include "test_knots.moc"
