// SPDX-License-Identifier: Apache-2.0
// A calibration from the crosses to the request, and the question after the restart, on a stand-in of
// systemd.
#include "tests/app/panel/panel_rig.h"

#include "app/panel/display/touch_calibration.h"
#include "tests/support/fake_package.h"
#include "tests/support/test_program.h"
#include "tests/support/unit_service.h"

#include <QSignalSpy>
#include <QTest>

#include <memory>

namespace test_touch_calibration {

using namespace Qt::StringLiterals;
using namespace campanel;
using campanel::panel::Level;
using campanel::panel::TouchCalibration;

namespace {

const QByteArray turned = "0.000000 1.000000 0.000000 -1.000000 0.000000 1.000000";

} // namespace

class TestTouchCalibration : public QObject {
    Q_OBJECT

    std::unique_ptr<test::PanelRig> m_rig;
    std::unique_ptr<test::UnitBus> m_bus;
    std::unique_ptr<TouchCalibration> m_touch;
    QList<store::AuditEntry> m_noted;

    QString path(const QString& name) { return m_rig->folder.filePath(name); }
    void write(const QString& name, const QByteArray& bytes) { QVERIFY(test::writeFile(path(name), bytes)); }
    QByteArray read(const QString& name)
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void setRule(const QByteArray& matrix)
    {
        write(u"rule"_s, "ENV{LIBINPUT_CALIBRATION_MATRIX}=\"" + matrix + "\"\n");
    }
    // A new panel on the same files.
    void start()
    {
        m_touch = std::make_unique<TouchCalibration>(m_rig->machine, nullptr);
        m_touch->setPlaces({path(u"run"_s), path(u"touch"_s), path(u"rule"_s), path(u"devices"_s)});
        m_touch->setBus(m_bus->bus());
        m_noted.clear();
        connect(m_touch.get(), &TouchCalibration::noted, this,
                [this](const store::AuditEntry& entry) { m_noted << entry; });
        m_touch->resume();
        m_touch->setWatched(true);
        QTRY_VERIFY(m_touch->isAsked());
    }
    void touch(const QList<QPointF>& touched)
    {
        const QList<QPointF> crosses{{0.1, 0.1}, {0.8, 0.1}, {0.8, 0.9}, {0.1, 0.9}};
        m_touch->begin();
        for (qsizetype i = 0; i < touched.size(); ++i) {
            QCOMPARE(m_touch->crossIndex(), static_cast<int>(i));
            m_touch->setProperty("cross", crosses[i]);
            m_touch->touch(touched[i]);
        }
    }
    void touchTurned() { touch({{0.9, 0.1}, {0.9, 0.8}, {0.1, 0.8}, {0.1, 0.1}}); }

private slots:
    void init()
    {
        m_rig = std::make_unique<test::PanelRig>();
        m_bus = std::make_unique<test::UnitBus>();
        QVERIFY(QDir(m_rig->folder.path()).mkpath(u"run"_s));
        write(u"devices/c13:64"_s, "E:ID_INPUT_KEYBOARD=1\n");
        write(u"devices/c13:65"_s, "I:5\nE:ID_INPUT=1\nE:ID_INPUT_TOUCHSCREEN=1\n");
        start();
    }
    void cleanup()
    {
        m_touch.reset();
        m_bus.reset();
        m_rig.reset();
    }

    void fourCrossesBecomeARequest()
    {
        QCOMPARE(m_touch->blockedReason(), QString());
        touchTurned();
        QTRY_COMPARE(m_bus->service.m_started, QStringList{u"campanel-touch.service replace"_s});
        QCOMPARE(read(u"run/touch-request"_s), turned + '\n');
        QVERIFY(m_touch->message().startsWith(u"The panel closes"_s));
        QTRY_COMPARE(m_noted.size(), 1);
        QCOMPARE(m_noted[0].object, u"touchscreen"_s);
        QCOMPARE(m_noted[0].before, u"none"_s);
        QCOMPARE(m_noted[0].after, QString::fromLatin1(turned));
        QCOMPARE(m_noted[0].outcome, u"requested"_s);
    }

    void theNewMapComesAfterTheOneInForce()
    {
        write(u"devices/c13:65"_s,
              "E:ID_INPUT_TOUCHSCREEN=1\nE:LIBINPUT_CALIBRATION_MATRIX=0 -1 1 1 0 0\nE:DEVNAME=x\n");
        touchTurned(); // the inverse of the map in force
        QTRY_COMPARE(read(u"run/touch-request"_s),
                     QByteArray("1.000000 0.000000 0.000000 0.000000 1.000000 0.000000\n"));
    }

    void badTouchesChangeNothing()
    {
        touch({{0.1, 0.1}, {0.8, 0.1}, {0.6, 0.9}, {0.1, 0.9}});
        QVERIFY(m_touch->failed());
        QVERIFY(m_touch->message().startsWith(u"A cross was missed."_s));
        touch({{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}});
        QVERIFY(m_touch->message().startsWith(u"The touches do not fit"_s));
        QVERIFY(m_bus->service.m_started.isEmpty());
        QVERIFY(!QFile::exists(path(u"run/touch-request"_s)));
        m_touch->cancel();
        QVERIFY(!m_touch->isOpen());
    }

    void whyItCannotBeCalibrated()
    {
        QVERIFY(QFile::remove(path(u"devices/c13:65"_s)));
        start();
        QCOMPARE(m_touch->blockedReason(), u"This computer has no touchscreen."_s);
        m_touch->begin();
        QVERIFY(!m_touch->isOpen());
        m_bus->service.m_fileState.clear();
        start();
        QVERIFY(m_touch->blockedReason().contains(u"operating system"_s));
        m_bus->service.m_fileState = u"masked"_s;
        start();
        QVERIFY(m_touch->blockedReason().contains(u"operating system"_s));
    }

    void aMachineThatMovesEndsTheCrosses()
    {
        m_rig->connectIdle();
        m_touch->begin();
        QCOMPARE(m_touch->crossIndex(), 0);
        m_rig->connectRunning();
        QVERIFY(!m_touch->isOpen());
        QVERIFY(m_touch->blockedReason().startsWith(u"The machine is moving."_s));
        m_touch->begin();
        QVERIFY(!m_touch->isOpen());
    }

    void levelServiceIsNeeded()
    {
        m_rig->machine.accessCheck().setLevel(Level::Technician);
        const QSignalSpy refused(&m_rig->machine.accessCheck(), &panel::AccessCheck::refused);
        m_touch->begin();
        QVERIFY(!m_touch->isOpen());
        setRule(turned);
        m_touch->remove();
        QCOMPARE(refused.size(), 2);
        QVERIFY(m_bus->service.m_started.isEmpty());
    }

    void crossesThatNobodyTouchesGoAway()
    {
        m_touch->begin();
        for (int second = 1; second < TouchCalibration::idleTimeS; ++second)
            m_touch->tick();
        QVERIFY(m_touch->isOpen());
        m_touch->tick();
        QVERIFY(!m_touch->isOpen());
    }

    void aForbiddenUnitIsSaid()
    {
        m_bus->service.m_isForbidden = true;
        touchTurned();
        QTRY_VERIFY(m_touch->failed());
        QVERIFY(m_touch->message().contains(u"polkit"_s));
        QVERIFY(!QFile::exists(path(u"run/touch-request"_s)));
        QVERIFY(!QFile::exists(path(u"touch/trial"_s)));
        QCOMPARE(m_noted.last().outcome, u"failed"_s);
    }

    void aUnitThatDoesNothingIsSaid()
    {
        m_touch->setPatience(std::chrono::milliseconds(1));
        touchTurned();
        QTRY_VERIFY(m_touch->failed());
        QVERIFY(m_touch->message().contains(u"journalctl -u campanel-touch"_s));
        QVERIFY(!QFile::exists(path(u"touch/trial"_s)));
    }

    void aKeptCalibrationStays()
    {
        touchTurned();
        setRule(turned);
        start();
        QCOMPARE(m_touch->secondsLeft(), TouchCalibration::trialTimeS);
        m_touch->keep();
        QCOMPARE(m_touch->secondsLeft(), 0);
        QCOMPARE(m_noted.last().outcome, u"done"_s);
        QVERIFY(m_touch->calibrated());
        start();
        QCOMPARE(m_touch->secondsLeft(), 0);
    }

    void withoutAnAnswerTheOneBeforeReturns()
    {
        setRule("1.100000 0.000000 0.000000 0.000000 1.000000 0.000000");
        touchTurned();
        setRule(turned);
        start();
        m_rig->machine.accessCheck().setLevel(Level::Viewer); // nobody is logged in after the restart
        for (int second = 1; second < TouchCalibration::trialTimeS; ++second)
            m_touch->tick();
        QCOMPARE(m_touch->secondsLeft(), 1);
        QCOMPARE(m_bus->service.m_started.size(), 1);
        m_touch->tick();
        QTRY_COMPARE(m_bus->service.m_started.size(), 2);
        QCOMPARE(read(u"run/touch-request"_s),
                 QByteArray("1.100000 0.000000 0.000000 0.000000 1.000000 0.000000\n"));
        QTRY_COMPARE(m_noted.size(), 1); // after the bus has answered
        QCOMPARE(m_noted[0].outcome, u"withdrawn"_s);
        setRule("1.100000 0.000000 0.000000 0.000000 1.000000 0.000000");
        start();
        QCOMPARE(m_touch->secondsLeft(), 0);
        QVERIFY(!QFile::exists(path(u"touch/trial"_s)));
    }

    void aWayBackThatFailsIsSaidAndAskedAgain()
    {
        touchTurned();
        setRule(turned);
        start();
        m_bus->service.m_isForbidden = true;
        m_touch->goBack();
        QTRY_VERIFY(m_touch->notice().startsWith(u"The earlier calibration"_s));
        m_touch->dismissNotice();
        QCOMPARE(m_touch->notice(), QString());
        start();
        QCOMPARE(m_touch->secondsLeft(), TouchCalibration::trialTimeS);
    }

    void aPowerCutBeforeTheUnitLeavesNoQuestion()
    {
        touchTurned();
        start();
        QCOMPARE(m_touch->secondsLeft(), 0);
        QVERIFY(!QFile::exists(path(u"touch/trial"_s)));
    }

    void aCalibrationIsRemoved()
    {
        QVERIFY(!m_touch->calibrated());
        m_touch->remove();
        QVERIFY(!m_touch->isOpen());
        setRule(turned);
        QVERIFY(m_touch->calibrated());
        m_touch->remove();
        QTRY_COMPARE(read(u"run/touch-request"_s), QByteArray("none\n"));
        QTRY_VERIFY(!m_noted.isEmpty() && m_noted.last().after == u"none"_s);
    }
};

CAMPANEL_TEST(TestTouchCalibration)

} // namespace test_touch_calibration

#include "test_touch_calibration.moc"
