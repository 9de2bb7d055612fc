// SPDX-License-Identifier: Apache-2.0
// The torque on Run: read while it is watched, compared at full speed only, and what is missing said.
#include "app/panel/kit/format.h"
#include "profile/cam/point_cam.h"
#include "profile/segments/segment_cam.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_torque_watch {

using namespace campanel;
using panel::TorqueWatch;
using test::PanelRig;

namespace {

// A cam whose axis needs 20 kg cm^2 x acceleration + 0.25 Nm of 2.4 Nm.
program::Recipe camRecipe(profile::ProgramKind kind = profile::ProgramKind::PointCam)
{
    program::Recipe recipe = program::defaultRecipe(kind);
    recipe.machine.inertiaKgCm2 = 20;
    recipe.machine.frictionNm = 0.25;
    recipe.machine.ratedTorqueNm = 2.4;
    recipe.machine.maxTorqueNm = 0;
    return recipe;
}

void report(PanelRig& rig, std::uint16_t mapMinor)
{
    link::LinkReport report;
    report.state = link::LinkState::Connected;
    report.portName = QStringLiteral("/dev/fake");
    report.identity = test::FakeLink::identity();
    report.identity->mapMinor = mapMinor;
    emit rig.link.reported(report);
}

// Reports this torque in 0.1 % at this angle in 0.01 degrees; bit 3 of `available` says that there is one.
void answer(PanelRig& rig, int torque, int angle, std::uint16_t available = 0x000B)
{
    const std::vector<std::uint16_t> registers{available, 0, 0, static_cast<std::uint16_t>(torque),
                                               0,         0, 0, static_cast<std::uint16_t>(angle)};
    emit rig.link.registersRead(
        {rig.link.reads.last(), link::ReadEnd::Done, registers, rig.now, std::nullopt});
}

struct RunningRig : PanelRig {
    explicit RunningRig(const program::Recipe& recipe = camRecipe())
    {
        editor.open(recipe);
        connectRunning();
        report(*this, modbus::ioMapMinor);
        torque.setWatched(true);
    }

    // Waits for the next reading and answers it.
    void read(int tenthPercent, int angle)
    {
        const qsizetype before = link.reads.size();
        QTRY_VERIFY(link.reads.size() > before);
        answer(*this, tenthPercent, angle);
    }

    TorqueWatch& torque = *machine.torque();
};

} // namespace

class TestTorqueWatch : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void readsWhileItIsWatched()
    {
        RunningRig rig;
        QCOMPARE(rig.link.reads.size(), 1);
        QCOMPARE(rig.link.reads[0].address, modbus::ioAddress);
        answer(rig, 317, 0);
        QCOMPARE(rig.torque.measuredPercent(), 31.7);
        rig.torque.setWatched(false);
        const qsizetype before = rig.link.reads.size();
        QTest::qWait(700); // twice the period
        QCOMPARE(rig.link.reads.size(), before);
        QVERIFY(std::isnan(rig.torque.measuredPercent()));
    }

    void comparesAtFullSpeedOnly()
    {
        const program::Recipe recipe = camRecipe();
        RunningRig rig(recipe);
        answer(rig, 300, 9000);
        const profile::MotionPoint point =
            profile::forwardMotion(std::get<profile::PointCamProgram>(recipe.program))
                .at(profile::camCycleS(std::get<profile::PointCamProgram>(recipe.program)) / 4);
        const double expected =
            100 * profile::axisLoad(recipe.machine).at(point.velocityMmPerS, point.accelerationMmPerS2) / 2.4;
        QVERIFY(std::abs(rig.torque.predictedPercent() - expected) < 1e-9);
        QVERIFY(rig.torque.readings().isEmpty()); // not before the next status
        QVERIFY(std::isnan(rig.torque.differencePercent()));
        rig.link.sendStatus(rig.now);
        QCOMPARE(rig.torque.readings().size(), 1);
        QVERIFY(std::abs(rig.torque.differencePercent() - std::abs(30 - expected)) < 1e-9);
        QCOMPARE(rig.torque.text(),
                 QStringLiteral("Torque 30 % of rated, predicted %1 %, largest difference %2 %")
                     .arg(panel::Format().number(expected, 0),
                          panel::Format().number(std::abs(30 - expected), 1)));
        // The machine began to slow down: that reading is of another motion.
        rig.read(900, 9000);
        rig.link.status.masterSpeedPercent = 80;
        rig.link.sendStatus(rig.now);
        QCOMPARE(rig.torque.readings().size(), 1);
        rig.read(900, 9000);
        QVERIFY(std::isnan(rig.torque.predictedPercent()));
        QCOMPARE(rig.torque.measuredPercent(), 90.0);
    }

    void followsASegmentCamBackward()
    {
        program::Recipe recipe = camRecipe(profile::ProgramKind::SegmentCam);
        auto& cam = std::get<profile::SegmentCamProgram>(recipe.program);
        cam.masterRateRevPerMin = -60;
        RunningRig rig(recipe);
        answer(rig, 300, 0);
        const profile::MotionProfile forward = profile::forwardMotion(cam);
        for (const int angleDeg : {20, 150, 200, 330}) {
            rig.read(300, 100 * angleDeg);
            const profile::MotionPoint point = forward.at(forward.durationS() * angleDeg / 360);
            const double expected =
                100 * profile::axisLoad(recipe.machine).at(-point.velocityMmPerS, point.accelerationMmPerS2) /
                2.4;
            QVERIFY2(std::abs(rig.torque.predictedPercent() - expected) < 1e-9,
                     qPrintable(QStringLiteral("%1 deg: %2 instead of %3")
                                    .arg(angleDeg)
                                    .arg(rig.torque.predictedPercent())
                                    .arg(expected)));
        }
    }

    void saysWhatIsMissing()
    {
        RunningRig rig;
        QCOMPARE(rig.torque.missingText(), QString());
        rig.editor.item(profile::Field::Inertia)->set(0);
        QCOMPARE(rig.torque.missingText(), QStringLiteral("The inertia is missing in Settings, Machine."));
        rig.editor.item(profile::Field::RatedTorque)->set(0);
        QCOMPARE(rig.torque.missingText(),
                 QStringLiteral("Inertia and rated torque are missing in Settings, Machine."));
        rig.editor.item(profile::Field::Inertia)->set(20);
        QCOMPARE(rig.torque.missingText(),
                 QStringLiteral("The rated torque is missing in Settings, Machine."));
        answer(rig, 100, 0);
        QCOMPARE(rig.torque.text(), QStringLiteral("Torque 10 %"));
        rig.editor.item(profile::Field::RatedTorque)->set(2.4);
        rig.editor.item(profile::Field::FeedPerMotorRev)->set(77);
        QCOMPARE(rig.torque.missingText(), QStringLiteral("The program was made for other machine data."));
        // A drive without torque, and an older controller.
        rig.read(0, 0);
        const qsizetype before = rig.link.reads.size();
        QTRY_VERIFY(rig.link.reads.size() > before);
        answer(rig, 0, 0, 0x0003);
        QCOMPARE(rig.torque.missingText(), QStringLiteral("The drive reports no torque."));
        QVERIFY(std::isnan(rig.torque.measuredPercent()));
        report(rig, modbus::ioMapMinor - 1);
        QCOMPARE(rig.torque.missingText(), QStringLiteral("The drive reports no torque."));
        rig.link.becomeLost();
        QVERIFY(std::isnan(rig.torque.measuredPercent()));
    }
};

CAMPANEL_TEST(TestTorqueWatch)

} // namespace test_torque_watch

#include "test_torque_watch.moc"
