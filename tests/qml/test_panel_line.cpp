// SPDX-License-Identifier: Apache-2.0
// The panel's reports of its line, by touch: link doctor, frames, a silent line, a waiting Stop, the proof,
// simulated faults.
#include "panel_test.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>

namespace test_panel_line {

using Kind = campanel::looks::DemoLink::Kind;
namespace panel = campanel::panel;

class TestPanelLine : public campanel::test::PanelTest {
    Q_OBJECT

    // Collects every visible text with a digit, or with a value's name, below the page or the top bar's
    // state.
    static void collectTexts(QQuickItem& below, QList<QQuickItem*>& texts)
    {
        if (!below.isVisible() || below.opacity() == 0)
            return;
        if (below.inherits("QQuickText"))
            texts << &below;
        for (QQuickItem* child : below.childItems())
            collectTexts(*child, texts);
    }

private slots:
    void aFoundConnectionIsTakenOverInOneTap()
    {
        m_window->link().show(campanel::looks::DemoLink::Situation::Stopped);
        tap("nav_maintenance");
        tap("doctorSearch");
        QVERIFY2(textOf("doctorState").contains(QStringLiteral("/dev/ttyUSB1")),
                 qPrintable(textOf("doctorState")));
        QVERIFY(!m_window->find(QStringLiteral("doctorSearch")));
        tap("doctorCancel");
        QVERIFY(!m_window->find(QStringLiteral("doctorTake")));
        tap("doctorSearch");
        m_window->link().endScan(true);
        m_window->settle();
        tap("doctorTake");
        const panel::ConnectionChoice& choice = m_window->panel().settings().connection();
        QVERIFY(!choice.simulated);
        QCOMPARE(choice.portName, QStringLiteral("/dev/ttyUSB1"));
        QCOMPARE(choice.baud, 19200);
        QCOMPARE(choice.parity, QStringLiteral("E"));
        QCOMPARE(choice.unit, 7);
        QVERIFY(!m_window->find(QStringLiteral("doctorTake")));
    }

    void doctorDoesNotDisturbARunningMachine()
    {
        tap("nav_maintenance");
        QVERIFY(!m_window->find(QStringLiteral("doctorSearch"))->isEnabled());
        QVERIFY(!textOf("doctorBlocked").isEmpty());
    }

    void framesAreWatchedOnlyInSight()
    {
        const auto& frames = *m_window->panel().maintenance().frames();
        tap("nav_maintenance");
        QVERIFY(!frames.watched());
        tap("maintenance3");
        QVERIFY(frames.watched());
        tap("nav_run");
        QVERIFY(!frames.watched());
        tap("nav_maintenance");
        QVERIFY(frames.watched());
        tap("maintenance1");
        QVERIFY(!frames.watched());
        QVERIFY(m_window->panel().maintenance().figures()->watched());
    }
    void absentPortIsSaidAfterAMoment()
    {
        m_window->link().show(campanel::looks::DemoLink::Situation::Absent);
        m_window->settle();
        QVERIFY2(!m_window->find(QStringLiteral("banner")), "a link that is just coming up is no trouble");
        QTRY_VERIFY(m_window->find(QStringLiteral("banner")));
        QVERIFY2(textOf("banner").contains(QStringLiteral("/dev/ttyUSB0")), qPrintable(textOf("banner")));
        m_window->link().show(campanel::looks::DemoLink::Situation::Running);
        QTRY_VERIFY(!m_window->find(QStringLiteral("banner")));
    }
    void silenceTurnsEveryLiveValueGrey_data()
    {
        QTest::addColumn<int>("kind");
        for (int kind = 1; kind <= 5; ++kind)
            QTest::addRow("kind %d", kind) << kind;
    }
    void silenceTurnsEveryLiveValueGrey()
    {
        QFETCH(int, kind);
        show(static_cast<Kind>(kind));
        tap("nav_run");
        const auto grey = [this](const QQuickItem& text) {
            return text.property("color").value<QColor>() == m_window->theme()
                                                                 ->property("color")
                                                                 .value<QObject*>()
                                                                 ->property("disabledInk")
                                                                 .value<QColor>();
        };
        // Texts of the program that are not measured.
        const QStringList given{"toleranceText", "gateText"};
        const auto live = [&] {
            QList<QQuickItem*> texts;
            QList<QQuickItem*> values;
            collectTexts(m_window->root(), texts);
            static const QRegularExpression digit(QStringLiteral("[0-9]"));
            const QRectF page =
                m_window->find(QStringLiteral("sheetHost"))
                    ->mapRectToScene(m_window->find(QStringLiteral("sheetHost"))->boundingRect());
            for (QQuickItem* text : texts) {
                const bool isOnPage = page.contains(text->mapToScene({1, 1}));
                if (text->objectName() == QStringLiteral("stateText") ||
                    text->objectName() == QStringLiteral("directionText") ||
                    (isOnPage && !given.contains(text->objectName()) &&
                     text->property("text").toString().contains(digit)))
                    values << text;
            }
            return values;
        };
        const auto fresh = live();
        QVERIFY2(fresh.size() >= 4, qPrintable(QString::number(fresh.size())));
        for (const QQuickItem* text : fresh)
            QVERIFY2(!grey(*text), qPrintable(text->property("text").toString()));
        auto now = m_window->link().now() + std::chrono::milliseconds(1200);
        m_window->panel().controller().setClock([&] { return now; });
        m_window->settle();
        const auto stale = live();
        QVERIFY(stale.size() >= fresh.size());
        for (const QQuickItem* text : stale)
            QVERIFY2(grey(*text), qPrintable(text->objectName() + u' ' + text->property("text").toString()));
        for (const char* plot : {"bagChart", "knifeDial", "filmPicture"}) {
            if (const QQuickItem* item = m_window->find(QString::fromLatin1(plot)))
                QVERIFY2(item->property("stale").toBool(), plot);
        }
        QCOMPARE(textOf("ageText"), QStringLiteral("1 s ago"));
        now += std::chrono::seconds(41);
        m_window->panel().controller().setClock([&] { return now; });
        QCOMPARE(textOf("ageText"), QStringLiteral("42 s ago"));
        m_window->checkClock();
    }

    void aWaitingStopIsShownAndWithdrawn()
    {
        m_window->link().show(campanel::looks::DemoLink::Situation::Lost);
        m_window->settle();
        QVERIFY2(textOf("banner").startsWith(QStringLiteral("No connection since 14:06:58")),
                 qPrintable(textOf("banner")));
        tap("startKey");
        QCOMPARE(textOf("banner"), QStringLiteral("There is no connection to the controller."));
        const qsizetype stops = m_window->link().stopRequests();
        tap("stopKey");
        QCOMPARE(m_window->link().stopRequests(), stops + 1);
        m_window->link().showWaitingStop();
        m_window->settle();
        QVERIFY2(textOf("banner").startsWith(QStringLiteral("Stop is not sent yet.")),
                 qPrintable(textOf("banner")));
        QCOMPARE(textOf("bannerButton"), QStringLiteral("Withdraw"));
        tap("bannerButton");
        QCOMPARE(m_window->link().withdrawals, 1);
    }

    void theActiveProgramIsProven()
    {
        for (const char* name : {"nav_motion", "more", "proofButton", "proofCompare"})
            tap(name);
        QVERIFY2(textOf("proofText").startsWith(QStringLiteral("Identical: all ")),
                 qPrintable(textOf("proofText")));
        tap("proofCancel"); // "Close" at this time
        QVERIFY(!m_window->find(QStringLiteral("sheetPanel")));
    }

    void faultsAreForASimulatedLine()
    {
        tap("nav_maintenance");
        QVERIFY(!m_window->find(QStringLiteral("maintenance4")));
        m_window->link().setSimulated(true);
        m_window->settle();
        tap("maintenance4");
        tap("fault0often");
        QCOMPARE(textOf("faultsText"), QStringLiteral("Active: Late responses"));
        tap("faultsOff");
        QVERIFY(textOf("faultsText").startsWith(QStringLiteral("No faults")));
        tap("fault1often");
        m_window->link().setSimulated(false); // replaced by another section
        m_window->settle();
        QVERIFY(!m_window->find(QStringLiteral("faultList")));
        QVERIFY(m_window->find(QStringLiteral("maintenance3")));
    }
};

CAMPANEL_TEST(TestPanelLine)

} // namespace test_panel_line

#include "test_panel_line.moc"
