// SPDX-License-Identifier: Apache-2.0
// Knots and segments beside their curve: on each size of screen the curve stays in sight and follows each
// entry.
#include "app/program/cam_advance.h"
#include "panel_test.h"
#include "tests/support/test_program.h"

namespace test_panel_cams {

using namespace campanel;
using namespace Qt::StringLiterals;

class TestPanelCams : public test::PanelTest {
    Q_OBJECT

    QRectF placeOf(const QString& name)
    {
        const QQuickItem* item = m_window->find(name);
        return item ? item->mapRectToScene(item->boundingRect()) : QRectF();
    }
    panel::CamHandles& handles() { return *editor().handles(); }
    double positionAt(double seconds)
    {
        QList<double> values;
        QMetaObject::invokeMethod(m_window->find(u"motionPlot"_s), "valuesAt",
                                  Q_RETURN_ARG(QList<double>, values), Q_ARG(double, seconds));
        return values.value(0);
    }

    void expectTheCurveBeside(const QString& name)
    {
        const QRectF plot = placeOf(u"motionPlot"_s);
        const QRectF beside = placeOf(name);
        QVERIFY2(!plot.isEmpty() && !beside.isEmpty(), qPrintable(name));
        QVERIFY2(!plot.intersects(beside), qPrintable(name));
        QVERIFY2(plot.right() <= placeOf(u"stopKey"_s).left(), "the curve is not under the commands");
        QVERIFY2(plot.width() > 150, "a curve that can be read");
    }
    // The mark of the selection begins or ends at the handle of the selected entry, in the curve.
    void expectTheSelectionMarked()
    {
        const QRectF marked = placeOf(u"selection0"_s);
        const QPoint handle = centerOf(u"handle%1"_s.arg(handles().selected()));
        QVERIFY(placeOf(u"motionPlot"_s).adjusted(-3, -3, 3, 3).contains(marked));
        QVERIFY2(std::abs(marked.left() - handle.x()) <= 3 || std::abs(marked.right() - handle.x()) <= 3,
                 qPrintable(u"%1 %2 %3"_s.arg(marked.left()).arg(marked.right()).arg(handle.x())));
    }
    void open(const QSize& size, bool gloves, int kind)
    {
        m_window = std::make_unique<looks::TestWindow>(looks::Variant{u"en"_s, u"light"_s, size, gloves});
        m_window->panel().settings().set("display.gloves", panel::settingText(gloves));
        editor().newProgram(kind);
        tap("nav_motion");
        tap(kind == 4 ? "knotsButton" : "segmentsButton");
    }

private slots:
    void theCurveStaysInSight_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("gloves");
        QTest::addColumn<int>("kind");
        for (const bool gloves : {false, true}) {
            for (const QSize size : {QSize(800, 480), QSize(1024, 600), QSize(1280, 800)}) {
                for (const int kind : {4, 6})
                    QTest::addRow("%s %dx%d%s", kind == 4 ? "knots" : "segments", size.width(), size.height(),
                                  gloves ? " gloves" : "")
                        << size << gloves << kind;
            }
        }
    }
    void theCurveStaysInSight()
    {
        QFETCH(QSize, size);
        QFETCH(bool, gloves);
        QFETCH(int, kind);
        open(size, gloves, kind);
        expectTheCurveBeside(u"sheetPanel"_s);
        // Forward and back without closing.
        QVERIFY(!m_window->find(u"previousEntry"_s)->isEnabled());
        for (int entry = 1; entry < handles().count(); ++entry) {
            tap("nextEntry");
            QCOMPARE(handles().selected(), entry);
            expectTheSelectionMarked();
        }
        QVERIFY(!m_window->find(u"nextEntry"_s)->isEnabled());
        const int edited = kind == 4 ? 1 : 0; // a rise
        while (handles().selected() > edited)
            tap("previousEntry");
        expectTheSelectionMarked();

        // A typed number changes the curve beside the keypad, and the sheet is still there.
        const double time = handles().times().at(edited);
        const double before = positionAt(time);
        // With gloves the numbers of a segment scroll on the smaller screens.
        QQuickItem* numbers = m_window->find(u"entryNumbers"_s);
        const double below = numbers->property("contentHeight").toDouble() - numbers->height();
        numbers->setProperty("contentY", std::max(0.0, below));
        tap(kind == 4 ? "field_knotSlave" : "field_segmentEnd");
        expectTheCurveBeside(u"keypad"_s);
        m_window->type(u"13"_s);
        tap("keypadAccept");
        QVERIFY(std::abs(before - 13) > 0.1);
        QVERIFY2(std::abs(positionAt(time) - 13) < 0.1, qPrintable(QString::number(positionAt(time))));
        expectTheCurveBeside(u"sheetPanel"_s);

        // A finger on the curve selects and moves, and the list follows.
        const QString handle = u"handle2"_s;
        const double beforeDrag = positionAt(handles().times().at(2));
        m_window->touch(handle);
        m_window->slide(centerOf(handle) + QPointF(0, 12));
        QCOMPARE(handles().selected(), 2);
        m_window->lift();
        m_window->settle();
        QVERIFY(std::abs(positionAt(handles().times().at(2)) - beforeDrag) > 0.01);
        QVERIFY2(m_window->find(u"sheetPanel"_s), "the sheet stays open");
        expectTheSelectionMarked();
        QVERIFY(m_window->find(kind == 4 ? u"knot2"_s : u"segment2"_s)->property("selected").toBool());
    }

    void aRefusedCamIsNamedAboveItsCurve()
    {
        open({800, 480}, false, 4);
        for (const QVariant& each : editor().fields()) {
            auto* field = each.value<panel::EditorField*>();
            if (field->fieldId() == u"master_rate_rev_per_min"_s)
                field->set(900);
        }
        m_window->settle();
        QVERIFY(!editor().feasible());
        QCOMPARE(textOf("curveLine"), plain(editor().verdict()));
    }

    void theMotionOfASegmentIsChosenBesideTheCurve()
    {
        open({800, 480}, false, 6);
        tap("segmentMotion");
        expectTheCurveBeside(u"sheetPanel"_s);
        const int other = editor().segments()->motion() == 1 ? 2 : 1;
        tap(qPrintable(u"choice_%1"_s.arg(other)));
        QCOMPARE(editor().segments()->motion(), other);
        QVERIFY2(m_window->find(u"segmentList"_s), "back among the segments");
    }

    // A cam that moves its axis on is downloaded after one confirmation, or closed by one key.
    void aProgressiveCamIsConfirmedOrClosed_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("closes");
        for (const QSize size : {QSize(800, 480), QSize(1024, 600), QSize(1280, 800)}) {
            for (const bool closes : {false, true})
                QTest::addRow("%s at %d", closes ? "closed" : "confirmed", size.width()) << size << closes;
        }
    }
    void aProgressiveCamIsConfirmedOrClosed()
    {
        QFETCH(QSize, size);
        QFETCH(bool, closes);
        open(size, false, 4);
        show(looks::DemoLink::Kind::PointCam);
        editor().setChoice(0, 0);
        editor().knots()->select(4);
        editor().knots()->slave()->set(25);
        editor().setChoice(0, 2);
        tap("sheetClose");
        QVERIFY2(textOf("verdict").contains(u"+25"_s), qPrintable(textOf("verdict")));
        tap("nextStep");
        QVERIFY(!m_window->find(u"downloadStart"_s));
        QVERIFY(m_window->find(u"closeCam"_s) && m_window->find(u"confirmAdvance"_s));
        tap(closes ? "closeCam" : "confirmAdvance");
        QVERIFY2(!m_window->find(u"confirmAdvance"_s), "asked once");
        QCOMPARE(program::advanceMm(editor().recipe().program), closes ? 0.0 : 25.0);
        if (closes) { // the program that the controller has, but for the ends of the spline
            QVERIFY2(!textOf("verdict").contains(u"+25"_s), qPrintable(textOf("verdict")));
            return;
        }
        tap("downloadStart");
        QCOMPARE(editor().programDownload()->state(), panel::ProgramDownload::State::Transferring);
    }

    void theNumbersOfRatiosAreTypedBesideTheCurve()
    {
        tap("nav_motion");
        tap("ratios");
        tap("ratioNumbers");
        expectTheCurveBeside(u"keypad"_s);
        tap("keypadCancel");
        QVERIFY(m_window->find(u"ratioSheet"_s));
    }

    void aTouchBesideTheSheetClosesIt()
    {
        open({1024, 600}, false, 4);
        m_window->touch(u"nav_run"_s); // covered by the sheet's shade
        m_window->lift();
        m_window->settle();
        QVERIFY(!m_window->find(u"sheetPanel"_s));
    }
};

CAMPANEL_TEST(TestPanelCams)

} // namespace test_panel_cams

#include "test_panel_cams.moc"
