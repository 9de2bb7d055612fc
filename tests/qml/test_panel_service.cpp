// SPDX-License-Identifier: Apache-2.0
// The machine's sections of Service by touch: a held jog key, the events that release it, and the dial of the
// dry run.
#include "panel_test.h"
#include "tests/looks/scenes.h"
#include "tests/support/test_program.h"

#include <cmath>

namespace test_panel_service {

using campanel::link::JogDirection;
using Situation = campanel::looks::DemoLink::Situation;

class TestPanelService : public campanel::test::PanelTest {
    Q_OBJECT

    auto& jog() { return *m_stage->panel().service().jog(); }
    auto& link() { return m_stage->link(); }
    void enter(const char* name)
    {
        for (const auto& scene : campanel::looks::allScenes()) {
            if (scene.name == QLatin1String(name))
                campanel::looks::enterScene(*m_stage, scene);
        }
    }
    void touch(const char* name)
    {
        m_stage->touch(QString::fromLatin1(name));
        m_stage->settle();
    }

private slots:
    void theAxisIsAskedToMoveWhileTheFingerIsDown()
    {
        enter("jog");
        QCOMPARE(link().jog(), JogDirection::None);
        touch("jogForward");
        QCOMPARE(link().jog(), JogDirection::Forward);
        m_stage->lift();
        QCOMPARE(link().jog(), JogDirection::None);
        touch("jogReverse");
        QCOMPARE(link().jog(), JogDirection::Reverse);
        m_stage->lift();
        QCOMPARE(link().jog(), JogDirection::None);
    }

    void slidingOffEndsItAndSlidingBackDoesNotBegin()
    {
        enter("jog");
        const QPointF on = centerOf(QStringLiteral("jogForward"));
        touch("jogForward");
        m_stage->slide(on - QPointF(0, 400));
        QCOMPARE(link().jog(), JogDirection::None);
        m_stage->slide(on);
        QCOMPARE(link().jog(), JogDirection::None);
        m_stage->lift();
    }

    void whatTakesTheKeysAwayLetsGo_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("another page") << 0;
        QTest::newRow("another section") << 1;
        QTest::newRow("a sheet") << 2;
        QTest::newRow("the login") << 3;
        QTest::newRow("Stop") << 4;
    }

    void whatTakesTheKeysAwayLetsGo()
    {
        QFETCH(const int, what);
        enter("jog");
        touch("jogForward");
        QCOMPARE(link().jog(), JogDirection::Forward);
        if (what == 0)
            QMetaObject::invokeMethod(m_stage->frame(), "openPage", Q_ARG(QString, QStringLiteral("run")));
        else if (what == 1)
            QMetaObject::invokeMethod(m_stage->find(QStringLiteral("serviceHoming")), "clicked");
        else if (what == 2)
            QMetaObject::invokeMethod(m_stage->find(QStringLiteral("jogSpeed")), "clicked");
        else if (what == 3)
            emit m_stage->panel().access().loginRequested(campanel::panel::Access::Technician);
        else
            m_stage->panel().machine().stop();
        m_stage->settle();
        QCOMPARE(link().jog(), JogDirection::None);
        QCOMPARE(jog().held(), 0);
        m_stage->lift();
        m_stage->closeDialogs();
    }

    void windowThatIsNotInFrontLetsGo()
    {
        enter("jog");
        m_stage->window().show();
        m_stage->window().requestActivate();
        QVERIFY(QTest::qWaitForWindowActive(&m_stage->window()));
        touch("jogForward");
        QCOMPARE(link().jog(), JogDirection::Forward);
        QQuickWindow other;
        other.show();
        other.requestActivate();
        QTRY_COMPARE(link().jog(), JogDirection::None);
        m_stage->lift();
    }

    void aRunningMachineDoesNotJogAndThePageSaysWhy()
    {
        enter("jog-blocked");
        touch("jogForward");
        m_stage->lift();
        QCOMPARE(link().jog(), JogDirection::None);
        QCOMPARE(textOf("jogText"), QStringLiteral("The machine is running. Stop it first."));
    }

    void theDialIsTurned()
    {
        enter("dry-run");
        auto& run = *m_stage->panel().service().dryRun();
        tap("dryRunStart");
        QCOMPARE(run.masterDeg(), 0.0);
        tap("dryRunOn");
        tap("dryRunOn");
        tap("dryRunBack");
        QVERIFY(std::abs(run.masterDeg() - 1) < 1e-9);
        QQuickItem* dial = m_stage->find(QStringLiteral("dryRunDial"));
        QVERIFY(dial);
        const QPointF center = dial->mapToScene(dial->boundingRect().center());
        const double radius = dial->width() / 3;
        touch("dryRunDial"); // its center, or any place
        m_stage->slide(center + QPointF(0, -radius));
        const double before = run.masterDeg();
        m_stage->slide(center + QPointF(radius, 0));
        QVERIFY(std::abs(std::remainder(run.masterDeg() - before - 90, 360)) < 1.0);
        m_stage->lift();
        tap("dryRunPlay");
        QVERIFY(run.playing());
        tap("nav_run");
        QVERIFY(!run.playing());
    }
};

CAMPANEL_TEST(TestPanelService)

} // namespace test_panel_service

#include "test_panel_service.moc"
