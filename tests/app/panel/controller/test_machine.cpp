// SPDX-License-Identifier: Apache-2.0
// The panel's view of the controller: nothing before there is data, its age, the trace, the bags, commands.
#include "app/panel/display/display.h"
#include "app/panel/kit/singleton.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QLocale>
#include <QQmlComponent>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace test_machine {

using namespace campanel;
using panel::Controller;
using test::PanelRig;
using namespace std::chrono_literals;

class TestMachine : public QObject {
    Q_OBJECT

private slots:
    void showsNothingBeforeItKnows()
    {
        PanelRig rig;
        for (const double value : {rig.machine.live().rateBagsPerMin,
                                   rig.machine.live().masterAngleDeg,
                                   rig.machine.live().knifeAngleDeg,
                                   rig.machine.live().knifeSpeedMmPerS,
                                   rig.machine.live().followingErrorPulses,
                                   rig.machine.live().followingErrorMm,
                                   rig.machine.live().pulseFrequencyHz,
                                   rig.machine.live().cycleCount,
                                   rig.machine.bags().count,
                                   rig.machine.bags().lengthMm,
                                   rig.machine.bags().deviationMm,
                                   rig.machine.bags().meanMm,
                                   rig.machine.bags().scatterMm,
                                   rig.machine.generation(),
                                   rig.machine.active().version,
                                   rig.machine.active().bagLengthMm,
                                   rig.machine.active().rateBagsPerMin,
                                   rig.machine.active().cycleSeconds,
                                   rig.machine.active().syncStartDeg,
                                   rig.machine.active().syncEndDeg,
                                   rig.machine.active().cutAngleDeg,
                                   rig.machine.ageMs(),
                                   rig.machine.statusPerSecond()})
            QVERIFY(std::isnan(value));
        QVERIFY(rig.machine.active().name.isEmpty());
        QVERIFY(!rig.machine.active().curves.isValid());
        QVERIFY(!rig.machine.fresh());
        QVERIFY(!rig.machine.canStart());
        QVERIFY(!rig.machine.startBlockedReason().isEmpty());
        QCOMPARE(rig.machine.state(), Controller::State::Unknown);
    }

    void dataGrowsOldAfterASecond()
    {
        PanelRig rig;
        rig.connectRunning();
        QVERIFY(rig.machine.fresh());
        QCOMPARE(rig.machine.ageMs(), 0.0);
        rig.now += 999ms;
        rig.machine.setClock([&] { return rig.now; });
        QVERIFY(rig.machine.fresh());
        QSignalSpy changed(&rig.machine, &Controller::freshChanged);
        rig.now += 1ms;
        rig.machine.setClock([&] { return rig.now; });
        QVERIFY(!rig.machine.fresh());
        QCOMPARE(changed.size(), 1);
        QCOMPARE(rig.machine.ageMs(), 1000.0);
        QVERIFY(!std::isnan(rig.machine.bags().count)); // the old value stays, grey
        QVERIFY(!rig.machine.canStart());
    }

    void showsTheActiveProgramFromTheController()
    {
        PanelRig rig;
        rig.connectRunning();
        QVERIFY(rig.machine.active().isPresent);
        QCOMPARE(rig.machine.active().name, "Biscuit 250");
        QCOMPARE(rig.machine.active().version, 1.0);
        QCOMPARE(rig.machine.active().bagLengthMm, 250.0);
        QCOMPARE(rig.machine.active().cycleSeconds, 1.0);
        QCOMPARE(rig.machine.live().rateBagsPerMin, 60.0);
        QVERIFY(rig.machine.active().curves.isValid());
        // One knife: the shaft turns once a cycle, slower than the master while it seals.
        QVERIFY(rig.machine.active().syncStartDeg > 0);
        QVERIFY(rig.machine.active().syncStartDeg < rig.machine.active().cutAngleDeg);
        QVERIFY(rig.machine.active().cutAngleDeg < rig.machine.active().syncEndDeg);
        QVERIFY(rig.machine.active().syncEndDeg < 360);
        QVERIFY(std::abs(rig.machine.active().cutAngleDeg - 180) <
                0.1); // the recipe is symmetric but for rounding
        emit rig.link.programRead({rig.link.status.generation, 0, {}});
        QVERIFY(!rig.machine.active().isPresent);
        QVERIFY(std::isnan(rig.machine.live().rateBagsPerMin));
    }

    void garbageHeaderGivesNoNumbers()
    {
        PanelRig rig;
        rig.connectRunning();
        std::vector<std::uint16_t> header(modbus::bankHeaderRegisters, 0xFFFF);
        header[modbus::registerNamed("bank.kind").address] =
            static_cast<std::uint16_t>(modbus::ProgramKind::RotaryCutter);
        header[modbus::registerNamed("bank.layout").address] =
            static_cast<std::uint16_t>(modbus::TableLayout::StepTable);
        emit rig.link.programRead({rig.link.status.generation, *rig.link.status.activeCrc, header});
        QVERIFY(rig.machine.active().isPresent);
        for (const double number : {rig.machine.active().version, rig.machine.active().bagLengthMm,
                                    rig.machine.active().rateBagsPerMin, rig.machine.active().cycleSeconds,
                                    rig.machine.live().rateBagsPerMin, rig.machine.active().syncStartDeg})
            QVERIFY2(std::isnan(number), qPrintable(QString::number(number)));
    }

    void traceRunsLikeARecordersPen()
    {
        PanelRig rig;
        rig.connectRunning();
        const auto sampleAt = [&](std::uint32_t cycle, double angleDeg, std::int32_t frequencyHz) {
            rig.link.status.cycleCount = cycle;
            rig.link.status.masterAngleDeg = angleDeg;
            rig.link.status.actualFrequencyHz = frequencyHz;
            rig.link.sendStatus(rig.now);
        };
        for (int step = 0; step < 36; ++step)
            sampleAt(1, step * 10, 1000);
        QCOMPARE(rig.machine.actualTrace().size(), 36);
        for (int step = 0; step < 10; ++step)
            sampleAt(2, 5 + step * 10, 2000);
        const auto points = rig.machine.actualTrace();
        for (qsizetype i = 1; i < points.size(); ++i)
            QVERIFY(points[i].x() > points[i - 1].x());
        // The new cycle up to the pen at 95 degrees, the previous one behind it.
        const double newSpeed = points.first().y();
        for (const QPointF& point : points)
            QCOMPARE(point.y(), point.x() * 360 < 95.1 ? newSpeed : newSpeed / 2);
        QCOMPARE(points.size(), 10 + 26);
        // More than a cycle was missed: the old trace is cleared.
        sampleAt(5, 180, 1000);
        QCOMPARE(rig.machine.actualTrace().size(), 1);
    }

    void traceStaysShort()
    {
        PanelRig rig;
        rig.connectRunning();
        for (int step = 0; step < 5000; ++step) {
            rig.link.status.cycleCount = 1;
            rig.link.status.masterAngleDeg = step * 0.07;
            rig.link.sendStatus(rig.now);
        }
        QVERIFY(rig.machine.actualTrace().size() <= 1000);
        QVERIFY(rig.machine.actualTrace().size() > 500);
    }

    // The cycles that earlier programs made do not count for the present one.
    void cyclesBeginWithTheProgram()
    {
        PanelRig rig;
        rig.connectRunning();
        const auto cyclesAt = [&rig](std::uint32_t count) {
            rig.link.status.cycleCount = count;
            rig.link.sendStatus(rig.now);
            return rig.machine.live().cycleCount;
        };
        rig.link.status.uptimeS = 100;
        QCOMPARE(cyclesAt(1172), 1172.0); // made before the panel was switched on
        std::vector<std::uint16_t> header(modbus::bankHeaderRegisters, 0);
        header[modbus::registerNamed("bank.kind").address] =
            static_cast<std::uint16_t>(modbus::ProgramKind::PositionMove);
        ++rig.link.status.generation;
        emit rig.link.programRead({rig.link.status.generation, *rig.link.status.activeCrc, header});
        QCOMPARE(rig.machine.live().cycleCount, 0.0);
        QCOMPARE(cyclesAt(1175), 3.0);
        rig.link.status.uptimeS = 0; // the controller was restarted
        QCOMPARE(cyclesAt(2), 2.0);
    }

    void bagsAreCountedOnceAndMeasured()
    {
        PanelRig rig;
        rig.connectRunning();
        // Begun before the program became active: displayed, not counted.
        rig.link.status.bagCount = 1;
        rig.link.status.bagDeviationMm = -25;
        rig.link.status.bagLengthMm = 225;
        rig.link.sendStatus(rig.now);
        QCOMPARE(rig.machine.bags().lengthMm, 225.0);
        QVERIFY(std::isnan(rig.machine.bags().meanMm));
        const QList<double> deviations{0.1, -0.1, 0.3, 0.1};
        for (qsizetype i = 0; i < deviations.size(); ++i) {
            rig.link.status.bagCount = static_cast<std::uint32_t>(i + 2);
            rig.link.status.bagDeviationMm = deviations[i];
            rig.link.status.bagLengthMm = 250 + deviations[i];
            for (int repeat = 0; repeat < 3; ++repeat)
                rig.link.sendStatus(rig.now);
        }
        QCOMPARE(rig.machine.bags().series, deviations);
        QCOMPARE(rig.machine.bags().count, 5.0);
        QCOMPARE(rig.machine.bags().lengthMm, 250.1);
        QVERIFY(std::abs(rig.machine.bags().meanMm - 250.1) < 1e-9);
        QVERIFY(std::abs(rig.machine.bags().scatterMm - std::sqrt(0.08 / 3)) < 1e-9);
        for (int i = 0; i < 100; ++i) {
            ++rig.link.status.bagCount;
            rig.link.sendStatus(rig.now);
        }
        QCOMPARE(rig.machine.bags().series.size(), 60);
    }

    void stopIsAlwaysSentAndAPressMoreStopsNow()
    {
        PanelRig rig;
        rig.machine.stop(); // also without a connection: the link answers it
        QCOMPARE(rig.link.requests.last().command, modbus::Command::StopAtCycleEnd);
        emit rig.link.commandEnded({rig.link.requests.last().id, modbus::Command::StopAtCycleEnd,
                                    link::CommandEnd::NotSent, modbus::Refusal::None, std::nullopt});
        QVERIFY(rig.machine.commandMessage().contains("not sent"));
        rig.connectRunning();
        rig.machine.stop();
        QCOMPARE(rig.link.requests.last().command, modbus::Command::StopAtCycleEnd);
        QVERIFY(rig.machine.commandMessage().isEmpty());
        rig.link.status.state = modbus::State::Stopping;
        rig.link.sendStatus(rig.now);
        const auto sent = rig.link.requests.size();
        rig.now += 60ms; // a finger that bounces
        rig.machine.stop();
        rig.now += 300ms;
        rig.machine.stop();
        QCOMPARE(rig.link.requests.size(), sent);
        rig.now += 40ms;
        rig.machine.stop();
        QCOMPARE(rig.link.requests.last().command, modbus::Command::StopNow);
    }

    void theFirstTouchOfStopCountsAtOnce()
    {
        PanelRig rig;
        rig.connectRunning();
        rig.link.status.state = modbus::State::Stopping; // by another master
        rig.link.sendStatus(rig.now);
        rig.machine.stop();
        QCOMPARE(rig.link.requests.last().command, modbus::Command::StopNow);
    }

    void startIsRefusedHereWhenItCannotBe()
    {
        PanelRig rig;
        rig.connectIdle();
        rig.machine.start();
        QVERIFY(rig.link.requests.isEmpty());
        QVERIFY(rig.machine.commandMessage().contains("Download"));
        rig.machine.dismissMessage();
        QVERIFY(rig.machine.commandMessage().isEmpty());
        rig.link.activate(rig.image(), rig.now);
        QVERIFY(rig.machine.canStart());
        rig.machine.start();
        QCOMPARE(rig.link.requests.last().command, modbus::Command::Start);
    }

    void refusalOfTheLastCommandIsShown()
    {
        PanelRig rig;
        rig.connectRunning();
        rig.machine.home();
        const quint32 id = rig.link.requests.last().id;
        emit rig.link.commandEnded({id + 1000,
                                    modbus::Command::SetClock,
                                    link::CommandEnd::Refused,
                                    modbus::Refusal::BadArgument,
                                    {}});
        QVERIFY(rig.machine.commandMessage().isEmpty());
        emit rig.link.commandEnded(
            {id, modbus::Command::Home, link::CommandEnd::Refused, modbus::Refusal::NotStandstill, {}});
        QVERIFY(rig.machine.commandMessage().startsWith("Reference run was refused"));
        QVERIFY(rig.machine.commandMessage().contains("standstill"));
    }

    void faultsSayWhatToDo()
    {
        PanelRig rig;
        rig.connectRunning();
        QVERIFY(rig.machine.alarmText().isEmpty());
        rig.link.status.state = modbus::State::Fault;
        rig.link.status.faultBits = 1u << static_cast<unsigned>(modbus::FaultBit::FollowingError);
        rig.link.sendStatus(rig.now);
        QVERIFY(rig.machine.faulted());
        QCOMPARE(rig.machine.stateText(), "Fault");
        QVERIFY(rig.machine.alarmText().contains("reset the fault"));
    }

    void stateOfANewerControllerIsUnknown()
    {
        PanelRig rig;
        rig.connectRunning();
        rig.link.status.state.reset();
        rig.link.sendStatus(rig.now);
        QCOMPARE(rig.machine.state(), Controller::State::Unknown);
        QCOMPARE(rig.machine.stateText(), "Unknown state");
    }

    void lostConnectionKeepsTheLastValuesAndSaysSo()
    {
        PanelRig rig;
        rig.connectRunning();
        rig.link.becomeLost();
        QCOMPARE(rig.machine.connection(), Controller::Connection::Lost);
        QCOMPARE(rig.machine.state(), Controller::State::Unknown);
        QVERIFY(rig.machine.connectionText().contains("reconnects automatically"));
        QVERIFY(rig.machine.active().isPresent);
        QCOMPARE(rig.machine.linkQuality(), 0);
    }

    void linkQualityFollowsTheFailures()
    {
        PanelRig rig;
        rig.connectRunning();
        const auto run = [&](int good, int failed) {
            for (int i = 0; i < good; ++i) {
                rig.now += 12ms;
                rig.link.sendStatus(rig.now);
            }
            for (int i = 0; i < failed; ++i)
                emit rig.link.statusReceived({{}, 1});
        };
        run(200, 0);
        QCOMPARE(rig.machine.linkQuality(), 4);
        QVERIFY(std::abs(rig.machine.statusPerSecond() - 83) <= 1);
        run(0, 1);
        QCOMPARE(rig.machine.linkQuality(), 3);
        run(0, 5);
        QCOMPARE(rig.machine.linkQuality(), 2);
        run(0, 50);
        QCOMPARE(rig.machine.linkQuality(), 1);
        rig.now += 6s;
        QCOMPARE(rig.machine.linkQuality(), 0);
    }

    void opensTheConnectionOfTheSettings()
    {
        PanelRig rig;
        rig.settings.setSimulated(false);
        rig.settings.setPortName("/dev/ttyUSB7");
        rig.settings.edit("connection.baud", panel::settingText(19200));
        rig.settings.setParity("E");
        QVERIFY(rig.settings.connectionDirty());
        rig.machine.open();
        QVERIFY(rig.link.connections.last().simulated);
        rig.settings.applyConnection();
        QVERIFY(!rig.settings.connectionDirty());
        QCOMPARE(rig.link.connections.size(), 2);
        QCOMPARE(rig.link.connections.last().port, "/dev/ttyUSB7");
        QCOMPARE(rig.link.connections.last().line.baud, 19200u);
        QCOMPARE(rig.link.connections.last().line.parity, modbus::Parity::Even);
        panel::Settings again(rig.folder.filePath("settings.ini"), nullptr);
        QCOMPARE(again.portName(), "/dev/ttyUSB7");
        QCOMPARE(again.parity(), "E");
    }

    // Without a word the simulated controller would take the machine's place.
    void missingSettingsOfAPanelThatWasSetUpAreALoss()
    {
        for (const bool wasSetUp : {false, true}) {
            const QTemporaryDir folder;
            panel::Settings settings(folder.filePath("settings.ini"), nullptr);
            settings.offerFirstStart(wasSetUp);
            QCOMPARE(settings.firstStart(), !wasSetUp);
            QCOMPARE(settings.simulated(), !wasSetUp);
            QCOMPARE(settings.notice().contains("No controller is selected"), wasSetUp);
            panel::Settings again(folder.filePath("settings.ini"), nullptr);
            QCOMPARE(again.simulated(), !wasSetUp);
        }
    }

    void nonsenseInTheSettingsFileBecomesTheStandard()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("settings.ini");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("language=tlh\ntheme=pink\n[connection]\nbaud=1\nparity=X\nunit=9999\nstop_bits=-3\n");
        file.close();
        const panel::Settings settings(path, nullptr);
        QVERIFY(panel::languageCodes(settings.installedLanguages()).contains(settings.language()));
        QCOMPARE(settings.values().text("display.theme"), "light");
        QCOMPARE(settings.connection().baud, 115200);
        QCOMPARE(settings.parity(), "N");
        QCOMPARE(settings.connection().unit, 247);
        QCOMPARE(settings.stopBits(), 1);
    }

    // Damage as after a power cut.
    void damagedSettingsNeverChooseAnotherController()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("settings.ini");
        const panel::ConnectionChoice real{false, "/dev/ttyUSB7", 19200, "E", 2, 9};
        {
            panel::Settings settings(path, nullptr);
            settings.set("display.theme", "dark");
            settings.setSimulated(false);
            settings.setPortName(real.portName);
            settings.edit("connection.baud", panel::settingText(real.baud));
            settings.setParity(real.parity);
            settings.setStopBits(real.stopBits);
            settings.edit("connection.unit", panel::settingText(real.unit));
            settings.applyConnection();
            QCOMPARE(settings.notice(), QString());
        }
        QVERIFY(QFile::resize(path, 20));
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("settings file .* damaged .* last good copy"));
        panel::Settings mended(path, nullptr);
        QCOMPARE(mended.connection(), real);
        QCOMPARE(mended.values().text("display.theme"), "dark");
        QVERIFY2(mended.notice().contains("last good copy"), qPrintable(mended.notice()));
        mended.dismissNotice();
        QCOMPARE(mended.notice(), QString());
        QCOMPARE(panel::Settings(path, nullptr).notice(), QString());

        QVERIFY(QFile::resize(path, 0));
        QVERIFY(QFile::remove(path + ".bak"));
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("settings file .* no good copy"));
        const panel::Settings lost(path, nullptr);
        QVERIFY(!lost.connection().simulated);
        QCOMPARE(lost.connection().portName, QString());
        QVERIFY2(lost.notice().contains("No controller"), qPrintable(lost.notice()));
        // The next start does not either, and the panel is not a new one.
        panel::Settings next(path, nullptr);
        QVERIFY(!next.connection().simulated);
        next.offerFirstStart();
        QVERIFY(!next.firstStart());
    }

    void withoutAChosenControllerItSaysSo()
    {
        PanelRig rig;
        link::LinkReport report;
        report.simulated = false;
        report.state = link::LinkState::PortProblem;
        report.error = modbus::LinkError{modbus::LinkErrorKind::PortAbsent, {}, {}, {}, 0};
        emit rig.link.reported(report);
        QVERIFY2(rig.machine.connectionText().startsWith("No controller is selected."),
                 qPrintable(rig.machine.connectionText()));
    }

    // A file of an earlier version has no checksum: an unknown key counts as damage.
    void everyKeyOfTheSettingsIsKnown()
    {
        PanelRig rig;
        rig.settings.set("display.language", "zh_CN");
        rig.settings.set("display.theme", "dark");
        rig.settings.set("display.units", "inch");
        rig.settings.set("display.gloves", panel::settingText(true));
        rig.settings.set("bags.tolerance_mm", panel::settingText(1.5));
        rig.settings.set("access.auto_logout_minutes", panel::settingText(30));
        rig.settings.set("access.operators_log_in", panel::settingText(true));
        rig.settings.set("access.hold_to_start", "on");
        rig.settings.set("recipes.order", "use");
        rig.settings.set("hand.trim_step_mm", "0.2");
        rig.settings.set("machine.name", "Line 3");
        rig.settings.set("scanner.prefix", "~~");
        rig.settings.set("scanner.suffix", "tab");
        rig.settings.set("scanner.key_time_ms", "50");
        rig.settings.set("stops.ask_after_seconds", "90");
        rig.settings.set("stops.ideal_rate", "120");
        rig.settings.set("stops.shift_starts", "06:00 18:00");
        rig.settings.set("stops.working_days", "12345");
        rig.settings.set("stops.reasons", "material");
        rig.settings.set("display.rotation", "180");
        rig.settings.noteProgramIn(7);
        rig.settings.beginFirstStart();
        rig.settings.applyConnection();
        panel::Display display(rig.machine, rig.settings, nullptr);
        rig.settings.set("display.brightness", panel::settingText(50));
        rig.settings.set("display.dark_after_minutes", panel::settingText(30));
        const QByteArray written = rig.settings.contents();
        const QString path = rig.folder.filePath("earlier.ini");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(written.mid(written.indexOf('\n') + 1));
        file.close();
        panel::Settings again(path, nullptr);
        QVERIFY(again.file().origin() == store::SettingsFile::Origin::File);
        QCOMPARE(again.contents(), written);
        QCOMPARE(written.count('='), panel::Settings::fileKeys().size() + 1);
        QLocale::setDefault(QLocale("en"));
        panel::Units::setInch(false);
    }

    void qmlSeesTheAttachedObjects()
    {
        PanelRig rig;
        rig.connectRunning();
        QQmlEngine engine;
        panel::attachToEngine(engine, rig.alarms, rig.machine, rig.editor, rig.records, rig.maintenance,
                              rig.settings, rig.trends);
        QQmlComponent component(&engine);
        component.setData(
            "import QtQuick\nimport CamPanel.Panel\nQtObject {\n"
            "  property double length: Editor.field('bag_length_mm').value\n"
            "  property bool running: Controller.state === Controller.State.Running\n"
            "  property bool connected: Controller.connection === Controller.Connection.Connected\n"
            "  property string language: Settings.setting('display.language').key\n"
            "  property int laws: Editor.laws.count\n}",
            QUrl());
        const std::unique_ptr<QObject> object(component.create());
        QVERIFY2(object, qPrintable(component.errorString()));
        QCOMPARE(object->property("length").toDouble(), 250.0);
        QVERIFY(object->property("running").toBool());
        QVERIFY(object->property("connected").toBool());
        QCOMPARE(object->property("laws").toInt(), 0); // solved only while somebody looks at them
        rig.editor.watchLaws(true);
        QVERIFY(object->property("laws").toInt() > 5);
        rig.editor.bagLength()->set(260);
        QCOMPARE(object->property("length").toDouble(), 260.0);
    }
};

CAMPANEL_TEST(TestMachine)

} // namespace test_machine

#include "test_machine.moc"
