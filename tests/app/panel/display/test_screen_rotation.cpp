// SPDX-License-Identifier: Apache-2.0
// The rotations of a screen, and the trial that goes back unless a person keeps it.
#include "tests/app/panel/panel_rig.h"

#include "app/panel/display/screen_rotation.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

namespace test_screen_rotation {

using namespace campanel;
using panel::Level;
using panel::ScreenRotation;

struct RotationRig : test::PanelRig {
    ScreenRotation rotation{machine, settings, nullptr};

    RotationRig() { rotation.setScreen({1024, 600}); }
    [[nodiscard]] int stored() const { return settings.values().whole("display.rotation"); }
};

class TestScreenRotation : public QObject {
    Q_OBJECT

private slots:
    void onlyRotationsWithTheWidthOfThePanelAreOffered()
    {
        RotationRig rig;
        QCOMPARE(rig.rotation.choices(), (QList<int>{0, 180}));
        rig.rotation.tryOut(90);
        QCOMPARE(rig.rotation.degrees(), 0);
        rig.rotation.setScreen({480, 800});
        QCOMPARE(rig.rotation.choices(), (QList<int>{90, 270}));
        QCOMPARE(rig.rotation.degrees(), 90);
    }

    void aConfigurationForAnotherScreenIsReplaced()
    {
        RotationRig rig;
        rig.settings.overrideValue("display.rotation", QStringLiteral("270"));
        QCOMPARE(rig.rotation.degrees(), 0);
        rig.rotation.setScreen({600, 1024});
        QCOMPARE(rig.rotation.degrees(), 270);
    }

    void aTriedRotationGoesBackInTime()
    {
        RotationRig rig;
        rig.rotation.tryOut(180);
        QCOMPARE(rig.rotation.degrees(), 180);
        QCOMPARE(rig.rotation.secondsLeft(), ScreenRotation::trialTimeS);
        for (int second = 1; second < ScreenRotation::trialTimeS; ++second)
            rig.rotation.tick();
        QCOMPARE(rig.rotation.degrees(), 180);
        rig.rotation.tick();
        QCOMPARE(rig.rotation.degrees(), 0);
        QCOMPARE(rig.rotation.secondsLeft(), 0);
        QCOMPARE(rig.stored(), 0);
    }

    void aKeptRotationIsStored()
    {
        RotationRig rig;
        rig.rotation.tryOut(180);
        QCOMPARE(rig.stored(), 0);
        rig.rotation.keep();
        QCOMPARE(rig.rotation.secondsLeft(), 0);
        const panel::Settings again(rig.folder.filePath(QStringLiteral("settings.ini")), nullptr);
        QCOMPARE(again.values().whole("display.rotation"), 180);
        QCOMPARE(rig.rotation.degrees(), 180);
    }

    void levelServiceIsNeeded()
    {
        RotationRig rig;
        rig.settings.guardBy(rig.machine.accessCheck());
        rig.machine.accessCheck().setLevel(Level::Technician);
        const QSignalSpy refused(&rig.machine.accessCheck(), &panel::AccessCheck::refused);
        rig.rotation.tryOut(180);
        QCOMPARE(refused.size(), 1);
        QCOMPARE(rig.rotation.degrees(), 0);
    }

    void theScreenIsNotTurnedWhileTheMachineMoves()
    {
        RotationRig rig;
        rig.connectIdle();
        rig.rotation.tryOut(180);
        rig.connectRunning();
        QCOMPARE(rig.rotation.degrees(), 0);
        QVERIFY(!rig.rotation.blockedReason().isEmpty());
        rig.rotation.tryOut(180);
        QCOMPARE(rig.rotation.degrees(), 0);
    }
};

CAMPANEL_TEST(TestScreenRotation)

} // namespace test_screen_rotation

#include "test_screen_rotation.moc"
