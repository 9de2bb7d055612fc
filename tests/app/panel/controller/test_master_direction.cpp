// SPDX-License-Identifier: Apache-2.0
// The direction of a point cam's master: displayed as reported by the controller, never as requested.
#include "tests/app/panel/kind_steps.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace test_master_direction {

using namespace campanel;
using namespace campanel::test;
using panel::MasterDirection;
using Way = panel::MasterDirection::Way;

namespace {

// A point cam in the controller, with a cycle of one second.
struct Rig : PanelRig {
    explicit Rig(double rate = 60, double slaveScale = 1)
    {
        begin(*this, ProgramKind::PointCam);
        if (slaveScale != 1)
            enter(editor, Field::SlaveScale, slaveScale);
        if (rate != 60)
            enter(editor, Field::MasterRate, rate);
        connectRunning();
    }

    [[nodiscard]] MasterDirection& direction() { return *machine.direction(); }

    // Answers the last request.
    void answer(double value, link::ParameterEnd end = link::ParameterEnd::Done)
    {
        const link::ParameterRequest& asked = link.parameters.last();
        link::ParameterOutcome outcome{asked.id, asked.name, end, std::nullopt, std::nullopt};
        if (end == link::ParameterEnd::Done)
            outcome.value = value;
        emit link.parameterEnded(outcome);
    }
    // Advances the master by this angle in 20 ms.
    void advance(double deg, double speedPercent = 100)
    {
        pass(deg, speedPercent);
        link.sendStatus(now);
    }
    void pass(double deg, double speedPercent = 100)
    {
        now += std::chrono::milliseconds(20);
        link.status.masterAngleDeg = std::fmod(link.status.masterAngleDeg.value_or(0) + deg + 360, 360);
        link.status.sampleTimeMs = static_cast<std::uint16_t>(link.status.sampleTimeMs + 20);
        link.status.masterSpeedPercent = speedPercent;
    }
};

} // namespace

class TestMasterDirection : public QObject {
    Q_OBJECT

private slots:
    void isReadAfterConnecting()
    {
        Rig rig;
        QCOMPARE(rig.link.parameters.size(), 1);
        QCOMPARE(rig.link.parameters[0].name, "parameter.master_direction");
        QVERIFY(!rig.link.parameters[0].value);
        QCOMPARE(rig.direction().way(), Way::Unknown);
        QVERIFY(!rig.direction().canChange());
        rig.advance(7.2);
        QCOMPARE(rig.link.parameters.size(), 1); // one request
        rig.answer(1);
        QCOMPARE(rig.direction().way(), Way::Backward);
        QVERIFY(rig.direction().canChange());
        // Another panel may have reversed it in the meantime.
        rig.link.becomeLost();
        QCOMPARE(rig.direction().way(), Way::Unknown);
        QVERIFY(!rig.direction().canChange());
        QCOMPARE(rig.direction().text(), "There is no connection to the controller.");
        rig.link.becomeConnected();
        QCOMPARE(rig.link.parameters.size(), 2);
        rig.answer(0);
        QCOMPARE(rig.direction().way(), Way::Forward);
    }

    void isReadAgainWhenTheControllerStartedAnew()
    {
        Rig rig;
        rig.link.status.uptimeS = 500;
        rig.advance(7.2);
        rig.answer(1);
        rig.link.status.uptimeS = 0;
        rig.advance(7.2);
        QCOMPARE(rig.direction().way(), Way::Unknown);
        QCOMPARE(rig.link.parameters.size(), 2);
    }

    void isNotAskedOfOtherKinds()
    {
        PanelRig rig;
        rig.connectRunning(); // a cutter
        QCOMPARE(rig.link.parameters.size(), 0);
        QCOMPARE(rig.machine.direction()->way(), Way::Unknown);
        rig.machine.direction()->turn(Way::Backward);
        QCOMPARE(rig.link.parameters.size(), 0);
    }

    void aFailedReadIsRepeated()
    {
        Rig rig;
        rig.answer(0, link::ParameterEnd::OutcomeUnknown);
        QCOMPARE(rig.link.parameters.size(), 1);
        rig.advance(7.2);
        QCOMPARE(rig.link.parameters.size(), 2);
        rig.answer(0);
        QCOMPARE(rig.direction().way(), Way::Forward);
        QVERIFY(rig.machine.commandMessage().isEmpty());
    }

    void anOldControllerSaysSo()
    {
        Rig rig;
        rig.answer(0, link::ParameterEnd::Refused);
        rig.advance(7.2);
        QCOMPARE(rig.link.parameters.size(), 1);
        QVERIFY(!rig.direction().canChange());
        QVERIFY2(rig.direction().text().contains("Update its firmware"), qPrintable(rig.direction().text()));
    }

    void theProgramsOwnSignCounts_data()
    {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("parameter");
        QTest::addColumn<Way>("way");
        QTest::addColumn<double>("written");
        QTest::newRow("forward") << 60.0 << 0.0 << Way::Forward << 1.0;
        QTest::newRow("turned round") << 60.0 << 1.0 << Way::Backward << 0.0;
        QTest::newRow("backward program") << -60.0 << 0.0 << Way::Backward << 1.0;
        QTest::newRow("backward program, turned round") << -60.0 << 1.0 << Way::Forward << 0.0;
    }
    void theProgramsOwnSignCounts()
    {
        QFETCH(double, rate);
        QFETCH(double, parameter);
        QFETCH(Way, way);
        QFETCH(double, written);
        Rig rig(rate);
        rig.answer(parameter);
        QCOMPARE(rig.direction().way(), way);
        rig.direction().turn(way); // unchanged: nothing to write
        QCOMPARE(rig.link.parameters.size(), 1);
        rig.direction().turn(way == Way::Forward ? Way::Backward : Way::Forward);
        QCOMPARE(rig.link.parameters.size(), 2);
        QCOMPARE(rig.link.parameters[1].name, "parameter.master_direction");
        QCOMPARE(rig.link.parameters[1].value, std::optional(written));
        QCOMPARE(rig.direction().way(), way); // until the controller has proven it
        rig.answer(written);
        QVERIFY(rig.direction().way() != way && rig.direction().way() != Way::Unknown);
    }

    void turnsUntilTheMasterHasComeRound()
    {
        Rig rig;
        rig.answer(0);
        rig.advance(7.2);
        rig.advance(7.2);
        QCOMPARE(rig.direction().text(), "runs forward");
        rig.direction().turn(Way::Backward);
        QVERIFY(!rig.direction().turning()); // the request is not accepted yet
        rig.answer(1);
        QVERIFY(rig.direction().turning());
        QCOMPARE(rig.direction().text(), "Changing to reverse …");
        rig.advance(3, 50);
        rig.advance(0.5, 5);
        rig.advance(0, 0);
        QVERIFY(rig.direction().turning());
        QSignalSpy told(&rig.direction(), &MasterDirection::changed);
        rig.advance(-0.5, 5);
        QVERIFY(!rig.direction().turning());
        QCOMPARE(rig.direction().text(), "runs in reverse");
        QVERIFY(!told.isEmpty());
        for (int i = 0; i < 60; ++i) { // over the end of the cycle
            rig.advance(-7.2);
            QVERIFY(!rig.direction().turning());
        }
    }

    void atStandstillItSaysHowItWillStart()
    {
        Rig rig;
        rig.answer(0);
        rig.link.status.state = modbus::State::Ready;
        rig.advance(0, 0);
        QCOMPARE(rig.direction().text(), "starts forward");
        rig.direction().turn(Way::Backward);
        rig.answer(1);
        QVERIFY(!rig.direction().turning());
        QCOMPARE(rig.direction().text(), "starts in reverse");
    }

    void aMasterTooFastToFollowIsNotGuessedAt()
    {
        Rig rig(600, 0.02); // 72 degrees in 20 ms, but 3 cycles between two statuses 300 ms apart
        rig.answer(0);
        rig.advance(72);
        rig.advance(72);
        QCOMPARE(rig.direction().text(), "runs forward");
        rig.link.status.sampleTimeMs = static_cast<std::uint16_t>(rig.link.status.sampleTimeMs + 280);
        rig.advance(-10);
        QVERIFY(!rig.direction().turning());
        QCOMPARE(rig.direction().text(), "set to forward");
    }

    void aBatchIsFollowedSampleBySample()
    {
        Rig rig(600, 0.02);
        rig.answer(0);
        link::StatusBatch batch;
        for (int i = 0; i < 4; ++i) {
            rig.pass(72);
            batch.samples << link::StatusSample{rig.now, rig.link.status};
        }
        emit rig.link.statusReceived(batch);
        QCOMPARE(rig.direction().text(), "runs forward");
    }

    void aWriteThatFailsIsSaidAndReadAgain_data()
    {
        QTest::addColumn<link::ParameterEnd>("end");
        QTest::addColumn<QString>("words");
        QTest::newRow("not sent") << link::ParameterEnd::NotSent << "there is no connection";
        QTest::newRow("refused") << link::ParameterEnd::Refused << "was not changed";
        QTest::newRow("unknown") << link::ParameterEnd::OutcomeUnknown << "not confirmed";
    }
    void aWriteThatFailsIsSaidAndReadAgain()
    {
        QFETCH(link::ParameterEnd, end);
        QFETCH(QString, words);
        Rig rig;
        rig.answer(0);
        rig.direction().turn(Way::Backward);
        rig.answer(1, end);
        QVERIFY2(rig.machine.commandMessage().contains(words), qPrintable(rig.machine.commandMessage()));
        QCOMPARE(rig.direction().way(), Way::Unknown);
        rig.advance(7.2);
        QCOMPARE(rig.link.parameters.size(), 3);
        QVERIFY(!rig.link.parameters[2].value);
        rig.answer(0);
        QCOMPARE(rig.direction().way(), Way::Forward);
    }
};

CAMPANEL_TEST(TestMasterDirection)

} // namespace test_master_direction

#include "test_master_direction.moc"
