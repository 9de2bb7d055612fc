// SPDX-License-Identifier: Apache-2.0
// The section of Service for packing machines by touch: a value, a switch, the wizard to its end.
#include "panel_test.h"

#include "app/plot/film/edge_picture.h"
#include "tests/looks/screens.h"
#include "tests/support/test_program.h"

#include <cmath>

namespace test_panel_packing {

using Step = campanel::panel::MarkWizard::Step;

class TestPanelPacking : public campanel::test::PanelTest {
    Q_OBJECT

    auto& packing() { return *m_window->panel().maintenance().packing(); }
    void enter(const char* name)
    {
        for (const auto& screen : campanel::looks::allScreens()) {
            if (screen.name == QLatin1String(name))
                campanel::looks::enterScreen(*m_window, screen);
        }
    }

private slots:
    void marksAreToldInWords()
    {
        enter("packing");
        QVERIFY2(textOf("packingTeachText").startsWith(QStringLiteral("The mark distance is 250.31 mm")),
                 qPrintable(textOf("packingTeachText")));
        QVERIFY(!m_window->find(QStringLiteral("packingSave"))->isEnabled());
    }

    void aNumberIsEntered()
    {
        enter("packing-keypad");
        QVERIFY(m_window->find(QStringLiteral("keypad")));
        tap("keypadDefault");
        tap("keypadAccept");
        m_window->settle();
        QVERIFY(!m_window->find(QStringLiteral("keypad")));
        QCOMPARE(textOf("packingText"),
                 QStringLiteral("Phase gain: correction of slip: 0.25, read back from the controller."));
        QVERIFY(packing().fields()->unsaved());
        tap("packingSave");
        QVERIFY(!packing().fields()->unsaved());
    }

    void trackingIsSwitchedByOneTap()
    {
        enter("packing");
        tap("packing0choice0");
        m_window->settle();
        QCOMPARE(packing().fields()->value("parameter.mark_tracking"), 0.0);
        tap("packing0choice1");
        m_window->settle();
        QCOMPARE(packing().fields()->value("parameter.mark_tracking"), 1.0);
    }

    void theEdgesSayWhyAMarkWasNotTaken()
    {
        enter("packing");
        tap("packingEdges");
        QVERIFY2(textOf("edgeRejected")
                     .startsWith(
                         QStringLiteral("Not taken: 9.4 mm behind the expected mark; the window is ±6 mm.")),
                 qPrintable(textOf("edgeRejected")));
        QVERIFY(textOf("edgeNewest").startsWith(QStringLiteral("Taken: ")));
        QVERIFY2(textOf("edgeVerdict1").startsWith(QStringLiteral("outside the window: ")) &&
                     textOf("edgeVerdict1") != QStringLiteral("outside the window: 0"),
                 qPrintable(textOf("edgeVerdict1")));
        tap("edgesShow"); // its place is on the screen, and stays there
        QVERIFY(packing().edges()->paused());
        auto& picture =
            *qobject_cast<campanel::plot::EdgePicture*>(m_window->find(QStringLiteral("edgePicture")));
        const double x = picture.xOf(packing().edges()->rejectedPlace());
        QVERIFY2(x > 0.3 * picture.width() && x < 0.7 * picture.width(), qPrintable(QString::number(x)));
        tap("sheetClose");
        QVERIFY(!m_window->find(QStringLiteral("edgePicture")));
        QVERIFY(!packing().edges()->paused());
    }

    void earlierEdgesComeByAFinger()
    {
        enter("packing");
        tap("packingEdges");
        QCOMPARE(m_window->find(QStringLiteral("edgePicture"))->property("back").toDouble(), 0.0);
        const QPoint middle = centerOf(QStringLiteral("edgesView"));
        m_window->touch(QStringLiteral("edgesView"));
        for (int px = 20; px <= 200; px += 20)
            m_window->slide(middle + QPoint(px, 0));
        m_window->lift();
        m_window->settle();
        QVERIFY(m_window->find(QStringLiteral("edgePicture"))->property("back").toDouble() > 100);
    }

    void theJamsAreTheirPicture()
    {
        enter("packing");
        tap("packingJam");
        QVERIFY(packing().jam()->watched());
        QVERIFY2(textOf("jamState").startsWith(QStringLiteral("Armed.")), qPrintable(textOf("jamState")));
        QCOMPARE(textOf("jamLast"), QStringLiteral("No jam since power-up."));
        const auto picture = [this] { return m_window->find(QStringLiteral("jamPlot")); };
        QCOMPARE(picture()->property("expected").value<QList<QPointF>>().size(), qsizetype(32));
        QCOMPARE(picture()->property("closing").toDouble(), -45.0);
        QVERIFY(std::isnan(picture()->property("jam").toPointF().x()));
        tap("sheetClose");
        QVERIFY(!packing().jam()->watched());

        enter("packing-jam-seen");
        QVERIFY2(textOf("jamLast").startsWith(QStringLiteral("Torque 71.2 %, 16.4° before the cut")),
                 qPrintable(textOf("jamLast")));
        QCOMPARE(picture()->property("jam").toPointF(), QPointF(-16.4, 71.2));
        tap("sheetClose");
        enter("packing-jam-slow");
        QVERIFY(textOf("jamState").contains(QStringLiteral("Connect its torque-limit output")));
        tap("sheetClose");
        enter("packing-jam-empty");
        QVERIFY(textOf("jamEmpty").startsWith(QStringLiteral("No packing machine data.")));
        QVERIFY(!picture());
    }

    void aSuggestionIsTakenByOneTap()
    {
        enter("packing-suggested");
        tap("packing1take");
        m_window->settle();
        QCOMPARE(packing().fields()->value("parameter.phase_gain"), 0.1);
        QVERIFY(!m_window->find(QStringLiteral("packing1take")));
    }

    void measurementsAreEnteredAndWritten()
    {
        enter("packing-wizard-measure");
        QCOMPARE(packing().wizard()->measuredText(), QStringLiteral("−3.10 · −2.90 · −3.05"));
        tap("wizardEnter");
        tap("keypadDefault");
        tap("keypadAccept");
        QVERIFY(!m_window->find(QStringLiteral("keypad")));
        QCOMPARE(packing().wizard()->measuredText(), QStringLiteral("−3.10 · −2.90 · −3.05 · 0.00"));
        tap("wizardDrop");
        tap("wizardNext");
        QCOMPARE(packing().fields()->value("parameter.mark_distance"), 900.0);
        tap("wizardNext");
        m_window->settle();
        QCOMPARE(packing().wizard()->step(), Step::Watch);
        QVERIFY(std::abs(packing().fields()->value("parameter.mark_distance") - 903.017) < 1e-6);
    }

    void aClosedWizardChangesNothing()
    {
        enter("packing-wizard-confirm");
        tap("wizardCancel");
        QVERIFY(!m_window->find(QStringLiteral("wizardText")));
        QCOMPARE(packing().fields()->value("parameter.mark_distance"), 900.0);
        tap("packingWizard");
        QCOMPARE(packing().wizard()->step(), Step::Explain);
    }
};

CAMPANEL_TEST(TestPanelPacking)

} // namespace test_panel_packing

#include "test_panel_packing.moc"
