// SPDX-License-Identifier: Apache-2.0
// campanelctl jog-bag, cut and take, as a person calls them at a simulated machine.
#include "campanelctl_call.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QtTest>

namespace test_hand_bags {

using namespace Qt::StringLiterals;
using namespace campanel::test;

class HandBagsTest : public QObject {
    Q_OBJECT

private slots:
    void bagsAreMadeCutAndTaken()
    {
        const ControllerProcess controller({u"--speed"_s, u"20"_s});
        const QStringList port{u"--port"_s, controller.port()};
        const auto run = [&port](const QStringList& words) {
            const Result result = call(words + port);
            QTest::qCompare(result.code, int{Ok}, result.complaint.constData(), "Ok", __FILE__, __LINE__);
            return result;
        };
        const auto refused = [&port](const QString& command, const char* sentence) {
            const Result result = call(QStringList{command} + port);
            QCOMPARE(result.code, int{Refused});
            QVERIFY2(result.complaint.contains(sentence), result.complaint.constData());
        };
        const auto order = [&run] { return run({u"order"_s, u"status"_s, u"--format"_s, u"json"_s}).json(); };
        const auto state = [&run] {
            return run({u"status"_s, u"--format"_s, u"json"_s}).json()[u"state"_s].toString();
        };
        run({u"download"_s});
        refused(u"jog-bag"_s, "reference run");
        refused(u"cut"_s, "reference run");
        refused(u"take"_s, "not running");
        run({u"home"_s});
        QTRY_COMPARE_WITH_TIMEOUT(state(), u"Ready"_s, 20'000);
        run({u"order"_s, u"start"_s, u"--quantity"_s, u"1000"_s, u"--lot"_s, u"L"_s});
        const int before = order()[u"cut"_s].toInt();
        for (int i = 1; i <= 3; ++i) { // the first one has no cut at its front that was measured
            run({u"jog-bag"_s});
            QTRY_COMPARE_WITH_TIMEOUT(state(), u"Ready"_s, 20'000);
            QVERIFY(order()[u"cut"_s].toInt() - before >= i - 1);
        }
        QCOMPARE(order()[u"rejected"_s].toInt(), order()[u"cut"_s].toInt());
        run({u"start"_s});
        QTRY_VERIFY_WITH_TIMEOUT(order()[u"good"_s].toInt() > 3, 20'000);
        refused(u"take"_s, "No cam switch rejects bags");
        run({u"set"_s, u"parameter.switch1_mode"_s, u"2"_s});
        const int rejected = order()[u"rejected"_s].toInt();
        run({u"take"_s});
        QTRY_COMPARE_WITH_TIMEOUT(order()[u"rejected"_s].toInt(), rejected + 1, 20'000);
        run({u"stop"_s});
        QTRY_COMPARE_WITH_TIMEOUT(state(), u"Ready"_s, 20'000);
        refused(u"cut"_s, "A product is under the knife");
    }

    void anOlderControllerHasNone()
    {
        const ControllerProcess controller({u"--map-minor"_s, u"5"_s});
        for (const QString& command : {u"jog-bag"_s, u"cut"_s, u"take"_s}) {
            const Result result = call({command, u"--port"_s, controller.port()});
            QCOMPARE(result.code, int{Refused});
            QVERIFY2(result.complaint.contains("does not support this command"),
                     result.complaint.constData());
        }
    }
};

CAMPANEL_TEST(HandBagsTest)

} // namespace test_hand_bags

#include "test_hand_bags.moc"
