// SPDX-License-Identifier: Apache-2.0
// A progressive cam on the panel: the advance in verdict, download and run, its confirmation, and the key
// that closes the cam.
#include "app/panel/recipe/recipe_comparison.h"
#include "app/program/cam_advance.h"
#include "tests/app/panel/access_rig.h"
#include "tests/app/panel/kind_steps.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_cam_advance {

using namespace campanel;
using namespace campanel::test;
using panel::ProgramDownload;
using State = panel::ProgramDownload::State;

namespace {

void endAt(Editor& editor, double slaveMm)
{
    if (editor.kind() == Editor::Kind::PointCam) {
        choose(editor, "Spline ends", "Natural"); // the last knot alone
        editor.knots()->select(editor.knots()->count() - 1);
        editor.knots()->slave()->set(slaveMm);
        choose(editor, "Spline ends", "Periodic");
    } else {
        editor.segments()->select(2);
        editor.segments()->field("segmentEnd")->set(slaveMm);
    }
}

} // namespace

class TestPanelCamAdvance : public QObject {
    Q_OBJECT

private slots:
    void anAdvanceIsConfirmedOnce_data()
    {
        QTest::addColumn<ProgramKind>("kind");
        QTest::newRow("knots") << ProgramKind::PointCam;
        QTest::newRow("segments") << ProgramKind::SegmentCam;
    }
    void anAdvanceIsConfirmedOnce()
    {
        QFETCH(ProgramKind, kind);
        PanelRig rig;
        begin(rig, kind);
        Editor& editor = rig.editor;
        const ProgramDownload& download = *editor.programDownload();
        rig.connectIdle();
        QCOMPARE(download.state(), State::Ready);
        QVERIFY2(!editor.verdict().contains("advances"), qPrintable(editor.verdict()));
        endAt(editor, 0.6);
        QCOMPARE(editor.verdict(), "Within all limits. The axis advances by +0.6 mm per cycle.");
        QCOMPARE(editor.severity(), Editor::Severity::Warning);
        QCOMPARE(download.state(), State::Unconfirmed);
        QCOMPARE(download.text(),
                 "The axis advances by +0.6 mm in every cycle, and no travel limit stops it. "
                 "Confirm the advance, or close the cam.");
        editor.download();
        QVERIFY(rig.link.banks.isEmpty());

        editor.confirmAdvance();
        QCOMPARE(editor.severity(), Editor::Severity::Good);
        QCOMPARE(download.state(), State::Ready);
        QCOMPARE(download.text(),
                 "The axis advances by +0.6 mm per cycle. The new recipe is used from the next start.");
        enter(editor, Field::MasterRate, 30); // no other advance
        QCOMPARE(download.state(), State::Ready);
        enter(editor, Field::MasterRate, -30);
        QCOMPARE(download.state(), State::Unconfirmed);
        QVERIFY2(editor.verdict().contains(QChar(0x2212) + QString("0.6 mm")), qPrintable(editor.verdict()));
        editor.undo();
        editor.download();
        QCOMPARE(rig.link.banks.size(), 1);

        // The confirmation is a change of the recipe: kept, compared, undone.
        program::Recipe without = editor.recipe();
        program::setConfirmedAdvance(without.program, 0);
        const auto rows = panel::RecipeComparison::rows(without, editor.recipe());
        QCOMPARE(rows.size(), 1);
        QCOMPARE(rows.first().name, "Confirmed advance");
        QCOMPARE(rows.first().editedText, "+0.6 mm per cycle");
        editor.undo(); // the rate
        editor.undo();
        QCOMPARE(editor.severity(), Editor::Severity::Warning);
    }

    void oneKeyClosesTheCam_data() { anAdvanceIsConfirmedOnce_data(); }
    void oneKeyClosesTheCam()
    {
        QFETCH(ProgramKind, kind);
        PanelRig rig;
        begin(rig, kind);
        rig.connectIdle();
        endAt(rig.editor, 25);
        const program::Recipe open = rig.editor.recipe();
        rig.editor.closeCam();
        QCOMPARE(program::advanceMm(rig.editor.recipe().program), 0.0);
        QCOMPARE(rig.editor.programDownload()->state(), State::Ready);
        QCOMPARE(rig.editor.verdict(), "Within all limits.");
        rig.editor.undo();
        QCOMPARE(program::advanceMm(rig.editor.recipe().program), 25.0);
        QVERIFY(program::kindInfo(kind).list->isEqual(rig.editor.recipe().program, open.program));
    }

    void aClosingErrorIsNamedAndNeedsNoConfirmation()
    {
        PanelRig rig;
        begin(rig, ProgramKind::PointCam);
        rig.connectIdle();
        endAt(rig.editor, -0.4);
        QCOMPARE(rig.editor.verdict(),
                 "Within all limits. The ends of the cam differ by 0.4 mm; the table closes the cam.");
        QCOMPARE(
            rig.editor.knots()->wrapText(),
            "The cycle closes smoothly. The ends of the cam differ by 0.4 mm; the table closes the cam.");
        QCOMPARE(rig.editor.programDownload()->state(), State::Ready);
        // The controller then has the same program.
        rig.link.activate(rig.image(), rig.now);
        QCOMPARE(rig.editor.programDownload()->state(), State::NothingToDo);
        QCOMPARE(rig.machine.direction()->advanceText(), QString());
    }

    void aProgramInTheControllerNeedsNoConfirmation()
    {
        PanelRig rig;
        begin(rig, ProgramKind::SegmentCam);
        endAt(rig.editor, 25);
        rig.connectRunning();
        QCOMPARE(rig.editor.programDownload()->state(), State::NothingToDo);
        QCOMPARE(rig.machine.direction()->advanceText(), "+25 mm");
        const link::ParameterRequest& asked = rig.link.parameters.first();
        emit rig.link.parameterEnded({asked.id, asked.name, link::ParameterEnd::Done, 1.0, std::nullopt});
        QCOMPARE(rig.machine.direction()->advanceText(), QChar(0x2212) + QString("25 mm")); // reversed
    }

    void anOperatorConfirmsAndATechnicianCloses()
    {
        AccessRig rig;
        begin(rig, ProgramKind::PointCam);
        endAt(rig.editor, 30);
        rig.add("Anna", panel::Access::Service, "258036");
        rig.access.logOut(); // what nobody logged in for is an operator's
        rig.editor.closeCam();
        QCOMPARE(program::advanceMm(rig.editor.recipe().program), 30.0);
        rig.editor.confirmAdvance();
        QVERIFY(program::isAdvanceConfirmed(rig.editor.recipe().program));
        rig.editor.undo();
        QVERIFY(!program::isAdvanceConfirmed(rig.editor.recipe().program));
        rig.editor.undo(); // the technician's knot
        QCOMPARE(program::advanceMm(rig.editor.recipe().program), 30.0);
    }
};

CAMPANEL_TEST(TestPanelCamAdvance)

} // namespace test_cam_advance

#include "test_cam_advance.moc"
