// SPDX-License-Identifier: Apache-2.0
// The operator's hand on the speed: what is written, what is shown meanwhile, and where it is not offered.
#include "app/panel/hand/hand_speed.h"
#include "tests/app/panel/hand/hand_rig.h"
#include "tests/app/panel/kind_steps.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace test_hand_speed {

using namespace campanel;
using namespace campanel::test;
using namespace Qt::StringLiterals;
using panel::HandSpeed;

namespace {

struct SpeedRig : HandRig {
    HandSpeed hand{machine, nullptr};

    [[nodiscard]] QList<double> written() const { return HandRig::written("hand.speed"); }
};

} // namespace

class TestHandSpeed : public QObject {
    Q_OBJECT

private slots:
    void stepsAreWritten()
    {
        SpeedRig rig;
        rig.connectRunning();
        QVERIFY(rig.hand.offered());
        QCOMPARE(rig.hand.percent(), 100.0);
        QVERIFY(!rig.hand.canFaster());
        const double rate = rig.machine.active().rateBagsPerMin;
        rig.hand.slower();
        QCOMPARE(rig.hand.percent(), 95.0); // at the touch
        QCOMPARE(rig.written(), QList<double>{95.0});
        rig.answer();
        QCOMPARE(rig.hand.percent(), 95.0);
        QVERIFY(rig.hand.rateText().startsWith(QString::number(rate * 0.95, 'f', 1)));
        rig.hand.full();
        rig.answer();
        QCOMPARE(rig.registers["hand.speed"], 100.0);
        rig.hand.faster();
        QCOMPARE(rig.hand.percent(), 100.0);
    }

    void touchesOnASlowLineAreOneWrite()
    {
        SpeedRig rig;
        rig.connectRunning();
        for (int i = 0; i < 30; ++i)
            rig.hand.slower();
        QCOMPARE(rig.hand.percent(), 20.0);
        QVERIFY(!rig.hand.canSlower());
        QCOMPARE(rig.written(), QList<double>{95.0}); // the first is on its way
        rig.answer();
        QCOMPARE(rig.written(), (QList<double>{95.0, 20.0}));
        rig.answer();
        QCOMPARE(rig.hand.percent(), 20.0);
        QCOMPARE(rig.registers["hand.speed"], 20.0);
    }

    void aWriteThatFailsIsTold()
    {
        SpeedRig rig;
        rig.connectRunning();
        rig.hand.slower();
        rig.answer(link::ParameterEnd::OutcomeUnknown);
        rig.answer();
        QVERIFY(!rig.hand.message().isEmpty());
        QCOMPARE(rig.hand.percent(), 100.0); // as read
        rig.hand.slower();
        rig.answer();
        QVERIFY(rig.hand.message().isEmpty());
        QCOMPARE(rig.hand.percent(), 95.0);
    }

    void isOfferedWhereAHandMaySetIt()
    {
        SpeedRig older;
        older.mapMinor = 5;
        older.connectRunning();
        QVERIFY(!older.hand.offered() && std::isnan(older.hand.percent()));

        SpeedRig rig;
        rig.connectRunning();
        rig.become(modbus::State::Ready);
        QVERIFY(!rig.hand.offered()); // at standstill nobody asks for it
        rig.become(modbus::State::Running);
        rig.hand.slower();
        rig.answer();
        rig.become(modbus::State::Ready);
        QVERIFY(rig.hand.offered()); // but the next run will be slower
        rig.machine.parameter("master.source").write(1, {});
        rig.answer();
        QVERIFY(rig.machine.masterSetting()->leads());
        QVERIFY(!rig.hand.offered());
        rig.hand.slower();
        QCOMPARE(rig.registers["hand.speed"], 95.0);
    }

    void isForOperators()
    {
        SpeedRig rig;
        rig.connectRunning();
        rig.machine.accessCheck().setLevel(panel::Level::Viewer);
        QSignalSpy refused(&rig.machine.accessCheck(), &panel::AccessCheck::refused);
        rig.hand.slower();
        QCOMPARE(refused.size(), 1);
        QVERIFY(rig.written().isEmpty());
        rig.machine.accessCheck().setLevel(panel::Level::Operator);
        rig.hand.slower();
        QCOMPARE(rig.written().size(), 1);
    }

    void aRowOfTouchesIsOneRowOfTheTrail()
    {
        SpeedRig rig;
        rig.connectRunning();
        QSignalSpy noted(&rig.hand, &HandSpeed::noted);
        for (int i = 0; i < 4; ++i) {
            rig.hand.slower();
            rig.answer();
        }
        QTRY_COMPARE_WITH_TIMEOUT(noted.size(), 1, 10'000);
        const auto entry = noted.first().first().value<store::AuditEntry>();
        QCOMPARE(entry.what, u"hand.speed"_s);
        QCOMPARE(entry.before, u"100 %"_s);
        QCOMPARE(entry.after, u"80 %"_s);
    }
};

CAMPANEL_TEST(TestHandSpeed)

} // namespace test_hand_speed

#include "test_hand_speed.moc"
