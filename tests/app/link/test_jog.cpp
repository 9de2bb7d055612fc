// SPDX-License-Identifier: Apache-2.0
// Held jog keys: the bits of the next exchange, and with the real controller program the movement of the axis
// exactly while the key is held.
#include "app/link/held_jog.h"
#include "link_panel.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QTest>
#include <QTimer>

namespace test_jog {

using namespace campanel;
using namespace std::chrono_literals;
using link::HeldJog;
using link::JogDirection;
using modbus::Command;
using modbus::State;
using test::ControllerProcess;
using test::imageOf;
using test::Panel;
using test::portSettings;
using test::timeoutMs;

namespace {

constexpr std::uint16_t forward = 1U << static_cast<unsigned>(modbus::JogBit::Forward);
constexpr std::uint16_t reverse = 1U << static_cast<unsigned>(modbus::JogBit::Reverse);
constexpr qsizetype statusesToBelieve = 40;

// Holds a key during its lifetime by repeated calls.
class HeldKey {
public:
    HeldKey(Panel& panel, JogDirection direction)
        : m_panel(panel)
    {
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer,
                         [&panel, direction] { panel.link.setJog(direction); });
        m_timer.start(50);
        panel.link.setJog(direction);
    }
    ~HeldKey() { m_panel.link.setJog(JogDirection::None); }
    HeldKey(const HeldKey&) = delete;
    HeldKey& operator=(const HeldKey&) = delete;

private:
    Panel& m_panel;
    QTimer m_timer;
};

} // namespace

class TestJog : public QObject {
    Q_OBJECT

    // Checks that the axis stands and remains at rest.
    static void verifyStandstill(Panel& panel)
    {
        const qsizetype seen = panel.statuses;
        const auto position = panel.status->commandedPositionPulses;
        QTRY_VERIFY_WITH_TIMEOUT(panel.statuses > seen + statusesToBelieve, timeoutMs);
        QCOMPARE(panel.status->commandedPositionPulses, position);
        QVERIFY(!panel.isIn(State::Jogging));
    }

private slots:
    void bitsAreThoseOfTheFinger()
    {
        HeldJog jog;
        const link::SteadyTime start{1h};
        QCOMPARE(jog.bits(start), std::uint16_t{0});
        jog.hold({JogDirection::Forward, start + link::jogCounts});
        QVERIFY(jog.isPollDue(start, start));
        QCOMPARE(jog.bits(start + 1ms), forward);
        jog.noteAnswer();
        QVERIFY(!jog.isPollDue(start + 39ms, start));
        QVERIFY(jog.isPollDue(start + 40ms, start));
        jog.hold({JogDirection::None, {}});
        QVERIFY(jog.isPollDue(start + 41ms, start + 41ms));
        QCOMPARE(jog.bits(start + 42ms), std::uint16_t{0});
        QVERIFY(jog.isPollDue(start + 42ms, start + 42ms)); // it was not answered
        jog.noteAnswer();
        QVERIFY(!jog.isPollDue(start + 100ms, start + 42ms));
        jog.hold({JogDirection::Reverse, start + 300ms});
        QCOMPARE(jog.bits(start + 110ms), reverse);
    }

    void whatWasNotToldAgainIsOverUntilTheKeyIsLetGo()
    {
        HeldJog jog;
        const link::SteadyTime start{1h};
        jog.hold({JogDirection::Forward, start + link::jogCounts});
        QCOMPARE(jog.bits(start), forward);
        jog.noteAnswer();
        QVERIFY(jog.isPollDue(start + 200ms, start + 190ms));
        QCOMPARE(jog.bits(start + 200ms), std::uint16_t{0});
        jog.hold({JogDirection::Forward, start + 500ms});
        QCOMPARE(jog.bits(start + 310ms), std::uint16_t{0});
        jog.hold({JogDirection::None, {}});
        jog.hold({JogDirection::Forward, start + 520ms});
        QCOMPARE(jog.bits(start + 330ms), forward);
        // No request in between.
        jog.hold({JogDirection::Forward, start + 1000ms});
        QCOMPARE(jog.bits(start + 810ms), std::uint16_t{0});
    }

    void movesWhileTheKeyIsHeldAndNoLonger()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        for (const JogDirection direction : {JogDirection::Forward, JogDirection::Reverse}) {
            const auto before = panel.status->commandedPositionPulses;
            QElapsedTimer sinceLetGo;
            {
                const HeldKey key(panel, direction);
                QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(State::Jogging), timeoutMs);
                // Longer than the controller's own limit.
                const qsizetype seen = panel.statuses;
                QTRY_VERIFY_WITH_TIMEOUT(panel.statuses > seen + 2 * statusesToBelieve, timeoutMs);
                QVERIFY(panel.isIn(State::Jogging));
                sinceLetGo.start();
            }
            QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(State::Idle), timeoutMs);
            qInfo("stands %lld ms after the key was let go", sinceLetGo.elapsed());
            QVERIFY2(sinceLetGo.elapsed() < 200, qPrintable(QString::number(sinceLetGo.elapsed())));
            const auto moved = panel.status->commandedPositionPulses - before;
            QVERIFY2(direction == JogDirection::Forward ? moved > 300 : moved < -300,
                     qPrintable(QString::number(moved)));
            verifyStandstill(panel);
        }
    }

    void whoStopsTellingHasLetGo()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        QElapsedTimer sinceTold;
        sinceTold.start();
        panel.link.setJog(JogDirection::Forward);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(State::Jogging), timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(State::Idle), timeoutMs);
        qInfo("stands %lld ms after it was told once", sinceTold.elapsed());
        QVERIFY2(sinceTold.elapsed() < 400, qPrintable(QString::number(sinceTold.elapsed())));
        const auto position = panel.status->commandedPositionPulses;
        QVERIFY2(position > 0 && position < 400, qPrintable(QString::number(position)));
        const HeldKey key(panel, JogDirection::Forward); // without a release in between
        verifyStandstill(panel);
    }

    void stopEndsItUntilTheKeyIsLetGo()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        {
            const HeldKey key(panel, JogDirection::Forward);
            QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(State::Jogging), timeoutMs);
            panel.link.request({1, Command::StopAtCycleEnd, {}});
            QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(State::Idle), timeoutMs);
            verifyStandstill(panel);
        }
        const HeldKey key(panel, JogDirection::Forward);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(State::Jogging), timeoutMs);
    }

    void lostLineEndsItUntilTheKeyIsLetGo()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        const HeldKey key(panel, JogDirection::Forward);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(State::Jogging), timeoutMs);
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, link::LinkState::Lost, timeoutMs);
        controller.start();
        panel.status.reset();
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        verifyStandstill(panel);
        QCOMPARE(panel.status->commandedPositionPulses, 0);
    }

    void goesOnThroughADownload()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        qsizetype interrupted = 0;
        {
            const HeldKey key(panel, JogDirection::Forward);
            QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(State::Jogging), timeoutMs);
            QObject::connect(&panel.link, &link::Link::statusReceived, &panel,
                             [&](const link::StatusBatch& batch) {
                                 for (const link::StatusSample& sample : batch.samples)
                                     interrupted += sample.status.state != State::Jogging ? 1 : 0;
                             });
            panel.link.download(imageOf(250).registers);
            QTRY_VERIFY_WITH_TIMEOUT(panel.download.fraction > 0.5, timeoutMs);
            QCOMPARE(interrupted, 0);
        }
        QTRY_VERIFY_WITH_TIMEOUT(!panel.isIn(State::Jogging), timeoutMs);
    }
};

CAMPANEL_TEST(TestJog)

} // namespace test_jog

#include "test_jog.moc"
