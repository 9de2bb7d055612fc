// SPDX-License-Identifier: Apache-2.0
// Single bags by hand at the panel: what is sent in which state, why a key is off, and who may touch it.
#include "app/panel/hand/hand_bags.h"
#include "tests/app/panel/hand/hand_rig.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

namespace test_hand_bags {

using namespace campanel;
using namespace campanel::test;
using namespace Qt::StringLiterals;
using modbus::Command;
using modbus::State;
using panel::HandBags;

namespace {

struct BagRig : HandRig {
    HandBags hand{machine, nullptr};

    BagRig() { registers["master_status.available"] = 1; }
    void stand()
    {
        connectRunning();
        machine.parameter("master.place").readIfUncertain();
        become(State::Ready);
    }
    // Returns what was sent since the last call.
    QList<Command> sent()
    {
        QList<Command> commands;
        for (; m_seen < link.requests.size(); ++m_seen)
            commands << link.requests[m_seen].command;
        return commands;
    }

private:
    qsizetype m_seen = 0;
};

} // namespace

class TestHandBags : public QObject {
    Q_OBJECT

private slots:
    void eachIsSentWhereItCanBe()
    {
        BagRig rig;
        rig.stand();
        QVERIFY(rig.hand.offered());
        QCOMPARE(rig.hand.bagReason(), QString());
        QCOMPARE(rig.hand.cutReason(), QString());
        QCOMPARE(rig.hand.takeReason(), u"The machine is not running."_s);
        (void)rig.sent();
        rig.link.permit = 0;
        rig.hand.makeBag();
        QVERIFY(rig.link.permit != 0); // as Start
        rig.hand.cut();
        rig.hand.take();
        QCOMPARE(rig.sent(), (QList{Command::JogBag, Command::SingleCut}));

        rig.become(State::Running);
        QCOMPARE(rig.hand.takeReason(), QString());
        QVERIFY(rig.hand.bagReason().contains(u"Stop it first"_s));
        rig.hand.makeBag();
        rig.hand.cut();
        rig.hand.take();
        QCOMPARE(rig.sent(), QList{Command::TakeBag});
    }

    void aKeyThatIsOffSaysWhy()
    {
        BagRig rig;
        rig.stand();
        rig.link.status.warningBits = 1U << static_cast<unsigned>(modbus::WarningBit::NotHomed);
        rig.become(State::Ready);
        QVERIFY(rig.hand.bagReason().contains(u"reference run"_s));
        QVERIFY(rig.hand.cutReason().contains(u"reference run"_s));
        rig.link.status.warningBits = 0;
        rig.become(State::Ready);
        rig.machine.setStartInterlock([] { return u"Wrong reel."_s; });
        QCOMPARE(rig.hand.bagReason(), u"Wrong reel."_s);
        QCOMPARE(rig.hand.cutReason(), u"Wrong reel."_s);
        rig.machine.setStartInterlock({});
        rig.machine.parameter("master.source").write(1, {});
        rig.answer();
        QCOMPARE(rig.hand.bagReason(), QString()); // behind a shaft it is made by the clock
        rig.machine.parameter("master.place").write(1, {});
        rig.answer();
        QVERIFY(rig.hand.bagReason().contains(u"drives the film"_s));
        QCOMPARE(rig.hand.cutReason(), QString());
    }

    void anOlderControllerHasNone()
    {
        BagRig rig;
        rig.mapMinor = 5;
        rig.stand();
        QVERIFY(!rig.hand.offered());
    }

    void isForOperators()
    {
        BagRig rig;
        rig.stand();
        (void)rig.sent();
        rig.machine.accessCheck().setLevel(panel::Level::Viewer);
        QSignalSpy refused(&rig.machine.accessCheck(), &panel::AccessCheck::refused);
        rig.hand.makeBag();
        rig.hand.cut();
        rig.hand.take();
        QCOMPARE(refused.size(), 3);
        QCOMPARE(rig.sent(), QList<Command>());
    }
};

CAMPANEL_TEST(TestHandBags)

} // namespace test_hand_bags

#include "test_hand_bags.moc"
