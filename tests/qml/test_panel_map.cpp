// SPDX-License-Identifier: Apache-2.0
// The regime map under a finger, the window that one key widens, and the seal time on Motion and Run.
#include "panel_test.h"

#include "profile/cutter/regime_map.h"
#include "tests/support/test_program.h"

namespace test_panel_map {

using namespace campanel;
using profile::Field;

class TestPanelMap : public test::PanelTest {
    Q_OBJECT

    void openMap()
    {
        for (const char* name : {"nav_motion", "more", "mapButton"})
            tap(name);
        m_window->settle();
    }
    // Drags from one place to the other with some moves in between.
    void drag(QPoint from, QPoint to)
    {
        constexpr int moves = 10;
        QTest::mousePress(&m_window->window(), Qt::LeftButton, {}, from);
        for (int i = 1; i <= moves; ++i)
            QTest::mouseMove(&m_window->window(), from + (to - from) * i / moves);
        QTest::mouseRelease(&m_window->window(), Qt::LeftButton, {}, to);
        m_window->settle();
    }
    // Returns the place of a recipe on the map.
    QPoint placeOf(double lengthMm, double rate)
    {
        QQuickItem* plot = m_window->find(QStringLiteral("regimePlot"));
        double x = 0;
        double y = 0;
        QMetaObject::invokeMethod(plot, "xOfLength", Q_RETURN_ARG(double, x), Q_ARG(double, lengthMm));
        QMetaObject::invokeMethod(plot, "yOfRate", Q_RETURN_ARG(double, y), Q_ARG(double, rate));
        return plot->mapToScene({x, y}).toPoint();
    }

private slots:
    void theDotFollowsTheFinger()
    {
        openMap();
        const QPoint dot = centerOf(QStringLiteral("regimeDot"));
        QVERIFY((placeOf(250, 60) - dot).manhattanLength() <= 3);
        const QPoint to = placeOf(400, 150);
        drag(dot, to);
        QVERIFY(std::abs(editor().bagLength()->value() - 400) <= 4);
        QVERIFY(std::abs(editor().rate()->value() - 150) <= 4);
        QVERIFY((centerOf(QStringLiteral("regimeDot")) - to).manhattanLength() <= 5);
        QVERIFY(editor().feasible());
        tap("regimeUndo");
        QCOMPARE(editor().bagLength()->value(), 250.0);
        QCOMPARE(editor().rate()->value(), 60.0);
        QVERIFY((centerOf(QStringLiteral("regimeDot")) - dot).manhattanLength() <= 1);
        QVERIFY2(!m_window->find(QStringLiteral("regimeUndo"))->isEnabled(), "the whole drag was one step");
    }

    void aFingerBesideTheDotChangesNothing()
    {
        openMap();
        drag(placeOf(600, 300), placeOf(400, 150));
        QCOMPARE(editor().bagLength()->value(), 250.0);
        QVERIFY(!editor().canUndo());
    }

    void theDotRestsInTheRefusedRegion()
    {
        openMap();
        drag(centerOf(QStringLiteral("regimeDot")), placeOf(120, 390));
        QVERIFY(!editor().feasible());
        QVERIFY2(textOf("regimeVerdict").contains(QStringLiteral("acceleration")),
                 qPrintable(textOf("regimeVerdict")));
        QVERIFY((centerOf(QStringLiteral("regimeDot")) - placeOf(120, 390)).manhattanLength() <= 8);
        tap("regimeSuggestion"); // a lower rate
        QVERIFY(editor().feasible());
        QVERIFY(std::abs(editor().bagLength()->value() - 120) <= 4);
    }

    void oneKeyWidensTheWindow()
    {
        editor().item(Field::ContactAngle)->set(20);
        editor().bagLength()->set(100);
        tap("nav_motion");
        QVERIFY2(textOf("verdict").contains(QStringLiteral("sync window of 22°")),
                 qPrintable(textOf("verdict")));
        QCOMPARE(textOf("nextStep"), QStringLiteral("Widen the window"));
        tap("nextStep");
        QVERIFY(editor().feasible());
        QCOMPARE(editor().bagLength()->value(), 100.0);
        QVERIFY(editor().k2()->value() > 2.59);
    }

    void sealTimeIsEnteredAndShown()
    {
        editor().item(Field::ContactAngle)->set(20);
        tap("nav_motion");
        tap("more");
        tap("field_min_seal_time_ms");
        m_window->type(QStringLiteral("50"));
        tap("keypadAccept");
        QCOMPARE(editor().minSealTime()->value(), 50.0);
        if (m_window->find(QStringLiteral("sheetClose")))
            tap("sheetClose");
        QVERIFY2(textOf("verdict").contains(QStringLiteral("seal time")), qPrintable(textOf("verdict")));
    }
};

CAMPANEL_TEST(TestPanelMap)

} // namespace test_panel_map

#include "test_panel_map.moc"
