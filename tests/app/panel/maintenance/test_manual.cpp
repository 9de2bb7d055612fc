// SPDX-License-Identifier: Apache-2.0
// The manual functions for technicians: jog, homing, inputs and outputs, dry run, and their audit entries.
#include "tests/app/panel/access_rig.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>

#include <algorithm>
#include <cmath>

namespace test_manual {

using namespace campanel;
using namespace std::chrono_literals;
using link::JogDirection;
using modbus::State;
using modbus::WarningBit;
using panel::CamSwitches;
using panel::DryRun;
using panel::Homing;
using panel::IoList;
using panel::Jog;
using test::AccessRig;
using test::PanelRig;

namespace {

constexpr auto notHomed = static_cast<std::uint16_t>(1U << static_cast<unsigned>(WarningBit::NotHomed));

void become(PanelRig& rig, State state, std::uint16_t warningBits = 0)
{
    rig.link.status.state = state;
    rig.link.status.warningBits = warningBits;
    rig.link.sendStatus(rig.now);
}

QString valueOf(IoList& io, const QString& name)
{
    for (const IoList::Row& row : io.rows()->rows()) {
        if (row.name == name)
            return row.value;
    }
    return QStringLiteral("no such row");
}

IoList::Lamp lampOf(IoList& io, const QString& name)
{
    for (const IoList::Row& row : io.rows()->rows()) {
        if (row.name == name)
            return row.lamp;
    }
    return IoList::Lamp::None;
}

// Reports a connected controller of this register map.
void report(PanelRig& rig, int mapMinor)
{
    link::LinkReport report;
    report.state = link::LinkState::Connected;
    report.portName = QStringLiteral("/dev/fake");
    report.identity = test::FakeLink::identity();
    report.identity->mapMinor = static_cast<std::uint16_t>(mapMinor);
    emit rig.link.reported(report);
}

void answer(PanelRig& rig, const std::vector<std::uint16_t>& registers)
{
    emit rig.link.registersRead(
        {rig.link.reads.last(), link::ReadEnd::Done, registers, rig.now, std::nullopt});
}

double figure(DryRun& run, const QString& label)
{
    for (const panel::FigureRow& row : run.figures()->rows()) {
        if (row.label == label)
            return row.value.section(u' ', 0, 0).toDouble();
    }
    return std::nan("");
}

} // namespace

class TestManual : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

    void theLinkIsToldAgainAsLongAsTheKeyIsHeld()
    {
        PanelRig rig;
        rig.connectIdle();
        Jog& jog = *rig.maintenance.jog();
        QVERIFY(jog.possible());
        jog.press(1);
        QCOMPARE(jog.held(), 1);
        QTRY_VERIFY(rig.link.jogs.size() >= 4);
        for (const JogDirection told : rig.link.jogs)
            QCOMPARE(told, JogDirection::Forward);
        jog.release(1);
        QCOMPARE(rig.link.jogs.last(), JogDirection::None);
        rig.link.jogs.clear();
        jog.press(-1);
        QCOMPARE(rig.link.jogs, QList<JogDirection>{JogDirection::Reverse});
        jog.release(-1);
    }

    void theEmergencyStopBlocksJogAndHome()
    {
        PanelRig rig;
        rig.connectIdle();
        rig.link.status.warningBits = modbus::RegisterInfo::bitOf(modbus::WarningBit::EmergencyStop);
        rig.link.status.state = modbus::State::Ready;
        rig.link.status.activeCrc = 1;
        rig.link.sendStatus(rig.now);
        const QString sentence =
            QStringLiteral("The emergency stop is pressed. Release it, then wait two seconds.");
        QCOMPARE(rig.maintenance.jog()->text(), sentence);
        QVERIFY(!rig.maintenance.jog()->possible());
        QCOMPARE(rig.maintenance.homing()->blockedReason(), sentence);
        QCOMPARE(rig.machine.startBlockedReason(), sentence);
        rig.link.status.warningBits = 0;
        rig.link.sendStatus(rig.now);
        QVERIFY(rig.maintenance.jog()->possible());
    }

    void whateverComesInBetweenEndsItUntilTheKeyIsLetGo_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("Stop") << 0;
        QTest::newRow("the other key") << 1;
        QTest::newRow("fault") << 2;
        QTest::newRow("line lost") << 3;
        QTest::newRow("old status") << 4;
    }

    void whateverComesInBetweenEndsItUntilTheKeyIsLetGo()
    {
        QFETCH(int, what);
        PanelRig rig;
        rig.connectIdle();
        Jog& jog = *rig.maintenance.jog();
        jog.press(1);
        become(rig, State::Jogging);
        QCOMPARE(jog.held(), 1);
        QVERIFY(!jog.blocked());
        if (what == 0)
            rig.machine.stop();
        else if (what == 1)
            jog.press(-1);
        else if (what == 2)
            become(rig, State::Fault);
        else if (what == 3)
            rig.link.becomeLost();
        else {
            rig.now += 1500ms;
            rig.machine.setClock([&rig] { return rig.now; }); // displays it
        }
        QCOMPARE(jog.held(), 0);
        QCOMPARE(rig.link.jogs.last(), JogDirection::None);
        QVERIFY(jog.blocked());
        if (what == 1)
            jog.release(-1);
        rig.link.becomeConnected();
        become(rig, State::Idle);
        const auto told = rig.link.jogs.size();
        QTest::qWait(120); // longer than the repetition of a held key
        QCOMPARE(rig.link.jogs.size(), told);
        QVERIFY(jog.blocked()); // the first key is still down
        jog.release(1);
        QVERIFY(!jog.blocked());
        jog.press(1);
        QCOMPARE(jog.held(), 1);
        jog.letGo();
        QCOMPARE(rig.link.jogs.last(), JogDirection::None);
    }

    void doesNotBeginWhileItIsBlockedAndSaysWhy()
    {
        PanelRig rig;
        Jog& jog = *rig.maintenance.jog();
        jog.press(1);
        QVERIFY(rig.link.jogs.isEmpty());
        QCOMPARE(jog.text(), QStringLiteral("There is no connection to the controller."));
        jog.release(1);
        rig.connectRunning();
        QCOMPARE(jog.text(), QStringLiteral("The machine is running. Stop it first."));
        jog.press(1);
        become(rig, State::Ready); // still under the finger: not a new touch
        QCOMPARE(jog.held(), 0);
        QVERIFY(rig.link.jogs.isEmpty());
        jog.release(1);
        jog.press(1);
        QCOMPARE(jog.held(), 1);
        QTRY_VERIFY(jog.blocked()); // the controller does not start
        QVERIFY(jog.text().startsWith(QStringLiteral("No motion")));
        become(rig, State::Jogging);
        QVERIFY(!jog.blocked());
        jog.release(1);
    }

    void aTechnicianJogsAndTheTrailSaysSo()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        rig.connectIdle();
        Jog& jog = *rig.maintenance.jog();
        jog.press(1);
        QCOMPARE(jog.held(), 0);
        QVERIFY(rig.link.jogs.isEmpty());
        jog.release(1);
        rig.logIn(QStringLiteral("Bo"), QStringLiteral("1470"));
        rig.link.status.axisPositionPulses = 100;
        become(rig, State::Idle);
        jog.press(1);
        become(rig, State::Jogging);
        jog.release(1);
        rig.link.status.axisPositionPulses = 1250; // at standstill
        become(rig, State::Idle);
        QSignalSpy ended(&jog, &Jog::ended);
        QTRY_COMPARE(ended.size(), 1);
        const auto entries = rig.entries();
        const store::AuditEntry& end = entries.last();
        const store::AuditEntry& begin = entries[entries.size() - 2];
        QCOMPARE(begin.what, QStringLiteral("command.jog_forward"));
        QCOMPARE(begin.who, QStringLiteral("Bo"));
        QCOMPARE(begin.before, QStringLiteral("100 pulses"));
        QCOMPARE(end.what, QStringLiteral("command.jog_end"));
        QCOMPARE(end.after, QStringLiteral("1250 pulses"));
        QCOMPARE(end.outcome, QStringLiteral("released"));
    }

    void homingIsFollowedToItsEnd_data()
    {
        QTest::addColumn<QList<State>>("states");
        QTest::addColumn<bool>("homed");
        QTest::addColumn<QString>("outcome");
        QTest::newRow("found") << QList{State::Homing, State::Ready} << true << QStringLiteral("done");
        QTest::newRow("start after it")
            << QList{State::Homing, State::Running} << true << QStringLiteral("done");
        QTest::newRow("stopped") << QList{State::Homing, State::Stopping, State::Ready} << false
                                 << QStringLiteral("stopped");
        QTest::newRow("no mark") << QList{State::Homing, State::Fault} << false << QStringLiteral("failed");
    }

    void homingIsFollowedToItsEnd()
    {
        QFETCH(const QList<State>, states);
        QFETCH(const bool, homed);
        QFETCH(const QString, outcome);
        AccessRig rig;
        rig.connectIdle();
        rig.link.activate(rig.image(), rig.now);
        become(rig, State::Ready, notHomed);
        Homing& homing = *rig.maintenance.homing();
        QCOMPARE(homing.place(), Homing::Place::NotHomed);
        QVERIFY(homing.possible());
        homing.home();
        QCOMPARE(rig.link.requests.last().command, modbus::Command::Home);
        for (const State state : states) {
            become(rig, state, homed && state != State::Homing ? std::uint16_t{0} : notHomed);
            if (state == State::Homing)
                QVERIFY(!homing.possible());
        }
        QCOMPARE(homing.failed(), !homed);
        QVERIFY(!homing.resultText().isEmpty());
        QCOMPARE(homing.place(), homed ? Homing::Place::Homed : Homing::Place::NotHomed);
        const auto entries = rig.entries();
        QCOMPARE(entries.last().what, QStringLiteral("command.home_end"));
        QCOMPARE(entries.last().outcome, outcome);
    }

    // With an encoder that keeps its position nothing is searched, and the page says so once it knows.
    void anAxisThatKeepsItsPlaceSearchesNothing()
    {
        PanelRig rig;
        rig.connectIdle();
        report(rig, modbus::mapMinor);
        rig.link.activate(rig.image(), rig.now);
        Homing& homing = *rig.maintenance.homing();
        QVERIFY(homing.explanation().contains(QStringLiteral("forward to the index mark")));
        homing.open();
        QCOMPARE(rig.link.reads.last().address, modbus::ioAddress);
        answer(rig, {0x0013, 0, 0, 0, 0, 0, 0, 0, 0});
        QVERIFY(homing.explanation().contains(QStringLiteral("no index mark is searched")));
        become(rig, State::Homing, notHomed);
        QCOMPARE(homing.blockedReason(), QStringLiteral("Turning to 0° …"));
        become(rig, State::Ready);
        QCOMPARE(homing.resultText(), QStringLiteral("The last reference run ended at 0°."));
    }

    void aPressTakesThePlaceWhereItStands()
    {
        PanelRig rig;
        rig.editor.newProgram(static_cast<int>(profile::ProgramKind::Press));
        rig.connectIdle();
        rig.link.activate(rig.image(), rig.now);
        become(rig, State::Ready, notHomed);
        Homing& homing = *rig.maintenance.homing();
        QVERIFY(!homing.moves());
        QVERIFY(
            homing.explanation().startsWith(QStringLiteral("No motion: the present ram position becomes")));
        homing.home();
        emit rig.link.commandEnded({rig.link.requests.last().id, modbus::Command::Home,
                                    link::CommandEnd::Done, modbus::Refusal::None, std::nullopt});
        QVERIFY(!homing.failed());
        QCOMPARE(homing.resultText(), QStringLiteral("The ram position was set as top position."));
    }

    void withoutAProgramThereIsNothingToHome()
    {
        PanelRig rig;
        rig.connectIdle();
        Homing& homing = *rig.maintenance.homing();
        QVERIFY(!homing.possible());
        homing.home();
        QVERIFY(rig.link.requests.isEmpty());
    }

    void speedIsReadAndWrittenWithProof()
    {
        PanelRig rig;
        rig.connectIdle();
        panel::ParameterField& speed = *rig.machine.parameterField("parameter.jog_frequency");
        QCOMPARE(speed.shown(), QStringLiteral("--"));
        speed.read();
        QCOMPARE(rig.link.parameters.last().name, std::string("parameter.jog_frequency"));
        emit rig.link.parameterEnded({rig.link.parameters.last().id, "parameter.jog_frequency",
                                      link::ParameterEnd::Done, 1000, std::nullopt});
        QCOMPARE(speed.shown(), QStringLiteral("1000 Hz"));
        speed.set(2500);
        QCOMPARE(rig.link.parameters.last().value, 2500.0);
        emit rig.link.parameterEnded({rig.link.parameters.last().id, "parameter.jog_frequency",
                                      link::ParameterEnd::OutcomeUnknown, std::nullopt, std::nullopt});
        QVERIFY(std::isnan(speed.value()));
        QVERIFY(!speed.failure().isEmpty());
    }

    void inputsAndOutputsAreWhatTheControllerTells()
    {
        PanelRig rig;
        IoList& io = *rig.maintenance.io();
        io.setWatched(true);
        QVERIFY(io.rows()->rows().isEmpty());
        QVERIFY(io.stale());
        rig.connectIdle();
        rig.link.status.axisPositionPulses = 12345;
        rig.link.status.commandedFrequencyHz = 1000;
        become(rig, State::Jogging, notHomed);
        io.retranslate();
        QVERIFY(!io.stale());
        QCOMPARE(valueOf(io, QStringLiteral("Encoder of the axis")), QStringLiteral("12,345 pulses"));
        QCOMPARE(lampOf(io, QStringLiteral("Pulses to the axis")), IoList::Lamp::On);
        QCOMPARE(lampOf(io, QStringLiteral("Encoder, speed")), IoList::Lamp::Off);
        QCOMPARE(lampOf(io, QStringLiteral("Index mark")), IoList::Lamp::Off);
        QCOMPARE(valueOf(io, QStringLiteral("Mark sensor")), QStringLiteral("no such row"));
        rig.link.becomeLost();
        io.retranslate();
        QVERIFY(io.stale());
        QCOMPARE(valueOf(io, QStringLiteral("Encoder of the axis")), QStringLiteral("12,345 pulses"));
    }

    void pinsAreReadWhileTheyAreWatched()
    {
        PanelRig rig;
        rig.connectIdle();
        IoList& io = *rig.maintenance.io();
        report(rig, modbus::ioMapMinor);
        QVERIFY(io.hasPins());
        QCOMPARE(rig.link.reads.size(), 0);
        io.setWatched(true);
        QCOMPARE(rig.link.reads.size(), 1);
        QCOMPARE(rig.link.reads[0].address, modbus::ioAddress);
        io.retranslate(); // one reading at a time
        QCOMPARE(rig.link.reads.size(), 1);
        // All available; emergency stop; switches 2 and 8, drive enable; -12.3 %, 65.538 mm, 1.5 mm
        answer(rig, {0x000F, 0x0002, 0x0182, 0xFF85, 0x0001, 0x0002, 1500, 0});
        QCOMPARE(lampOf(io, QStringLiteral("Emergency stop")), IoList::Lamp::Warning);
        QCOMPARE(lampOf(io, QStringLiteral("Limit switch, forward")), IoList::Lamp::Off);
        QCOMPARE(lampOf(io, QStringLiteral("Cam switch 2")), IoList::Lamp::On);
        QCOMPARE(lampOf(io, QStringLiteral("Cam switch 3")), IoList::Lamp::Off);
        QCOMPARE(lampOf(io, QStringLiteral("Cam switch 8")), IoList::Lamp::On);
        QCOMPARE(lampOf(io, QStringLiteral("Drive enable")), IoList::Lamp::On);
        QCOMPARE(valueOf(io, QStringLiteral("Torque of the axis, of rated")), QStringLiteral("−12.3 %"));
        QCOMPARE(valueOf(io, QStringLiteral("Encoder of the infeed")), QStringLiteral("65.5 mm"));
        QCOMPARE(valueOf(io, QStringLiteral("Infeed, sent minus encoder")), QStringLiteral("1.50 mm"));
        QCOMPARE(valueOf(io, QStringLiteral("Positions kept without power")), QStringLiteral("none"));
        // Each pin once, a sensor with its count.
        QCOMPARE(lampOf(io, QStringLiteral("Index mark")), IoList::Lamp::Off);
        QCOMPARE(valueOf(io, QStringLiteral("Index mark")), QStringLiteral("found or not required"));
        QCOMPARE(lampOf(io, QStringLiteral("Product eye")), IoList::Lamp::Off);
        qsizetype pinRows = 0;
        QList<int> outputs;
        for (const IoList::Row& row : io.rows()->rows()) {
            pinRows += row.purpose.isEmpty() ? 0 : 1;
            QVERIFY2(row.purpose.isEmpty() || row.purpose.endsWith(u'.'), qPrintable(row.purpose));
            if (row.output >= 0)
                outputs << row.output;
        }
        // This controller has not the outputs from Ready on.
        const auto has = static_cast<qsizetype>(modbus::OutputBit::Ready);
        QCOMPARE(pinRows, static_cast<qsizetype>(modbus::inputRows.size()) + has);
        QCOMPARE(outputs.size(), has);
        for (qsizetype i = 0; i < outputs.size(); ++i)
            QCOMPARE(outputs[i], static_cast<int>(i));
        // What the machine does not have has no row.
        io.retranslate();
        QCOMPARE(rig.link.reads.size(), 2);
        answer(rig, {0x0052, 0x0002, 0x0001, 100, 0, 0, 0, 0});
        QCOMPARE(valueOf(io, QStringLiteral("Positions kept without power")), QStringLiteral("axis, infeed"));
        QCOMPARE(valueOf(io, QStringLiteral("Emergency stop")), QStringLiteral("no such row"));
        QCOMPARE(valueOf(io, QStringLiteral("Torque of the axis, of rated")), QStringLiteral("no such row"));
        QCOMPARE(lampOf(io, QStringLiteral("Cam switch 1")), IoList::Lamp::On);
        io.setWatched(false);
        const qsizetype before = rig.link.reads.size();
        QTest::qWait(700); // twice the period
        QCOMPARE(rig.link.reads.size(), before);
    }

    void olderControllersHaveNoPins()
    {
        PanelRig rig;
        rig.connectIdle();
        IoList& io = *rig.maintenance.io();
        report(rig, modbus::ioMapMinor - 1);
        io.setWatched(true);
        io.retranslate();
        QVERIFY(!io.hasPins());
        QCOMPARE(rig.link.reads.size(), 0);
        QCOMPARE(valueOf(io, QStringLiteral("Cam switch 1")), QStringLiteral("no such row"));
        QCOMPARE(lampOf(io, QStringLiteral("Index mark")), IoList::Lamp::On);
    }

    void aCamSwitchIsOneOfEight()
    {
        AccessRig rig;
        rig.addAnnaAndBo();
        CamSwitches& switches = *rig.maintenance.switches();
        rig.connectIdle();
        report(rig, modbus::ioMapMinor);
        const auto answerAll = [&rig](double value) {
            for (const link::ParameterRequest& asked : std::exchange(rig.link.parameters, {}))
                emit rig.link.parameterEnded({asked.id, asked.name, link::ParameterEnd::Done,
                                              asked.value.value_or(value), std::nullopt});
        };
        for (int number = 1; number <= modbus::switchCount; ++number) {
            switches.choose(number);
            QStringList asked;
            for (const link::ParameterRequest& each : rig.link.parameters)
                asked << QString::fromStdString(each.name).section(u'.', 1);
            QStringList expected;
            for (const char* each : {"mode", "on_angle", "off_angle", "lead", "every"})
                expected << QStringLiteral("switch%1_%2").arg(number).arg(QLatin1String(each));
            answerAll(0);
            QCOMPARE(asked, expected);
        }
        switches.choose(3);
        QCOMPARE(switches.rowCount(), 5);
        QCOMPARE(rig.link.parameters.size(), 5);
        QCOMPARE(rig.link.parameters[1].name, "parameter.switch3_on_angle");
        answerAll(2);
        const auto at = [&switches](int row, int role) { return switches.data(switches.index(row), role); };
        QCOMPARE(at(0, CamSwitches::ValueRole).toString(), "Rejected bags");
        QCOMPARE(at(0, CamSwitches::ChoicesRole).toStringList().size(), 3);
        QCOMPARE(at(1, CamSwitches::NameRole).toString(), "Cam switch 3: on angle");
        QCOMPARE(at(3, CamSwitches::NoteRole).toString(), "0 ms to 100 ms");
        switches.setChoice(0, 1); // nobody is logged in
        QCOMPARE(rig.link.parameters.size(), 0);
        rig.logIn(QStringLiteral("Bo"), QStringLiteral("1470"));
        switches.setChoice(0, 1);
        QCOMPARE(rig.link.parameters.size(), 2); // for the audit trail the value before
        QCOMPARE(rig.link.parameters.back().value, 1.0);
        answerAll(0);
        QCOMPARE(at(0, CamSwitches::ValueRole).toString(), "By angle");
        QVERIFY(switches.unsaved());
        switches.select(1);
        QCOMPARE(switches.value()->maximum(), 359.99);
        switches.value()->set(90.5);
        answerAll(0);
        QCOMPARE(switches.outcomeText(), "Cam switch 3: on angle: 90.5°, read back from the controller.");
        switches.choose(CamSwitches::drives());
        QCOMPARE(switches.rowCount(), 1);
        answerAll(2);
        QCOMPARE(at(0, CamSwitches::ValueRole).toString(), "While running");
        const auto contacts =
            std::ranges::count(modbus::inputRows, modbus::InputSource::Contact, &modbus::InputRow::source);
        QCOMPARE(switches.names().size(), CamSwitches::drives() + contacts + 1);
        for (const char* name : {"drive_alarm", "emergency_stop", "limit_forward", "limit_reverse"}) {
            switches.choose(switches.current() + 1);
            QCOMPARE(switches.rowCount(), 2);
            QCOMPARE(rig.link.parameters[0].name, "parameter." + std::string(name) + "_contact");
            QCOMPARE(rig.link.parameters[1].name, "parameter." + std::string(name) + "_filter");
            answerAll(1);
            QCOMPARE(at(0, CamSwitches::ValueRole).toString(), "NC contact");
            QCOMPARE(at(1, CamSwitches::NoteRole).toString(), "0 ms to 100 ms");
        }
        QCOMPARE(switches.names()[switches.current() - 1], "Limit switch, reverse");
        QCOMPARE(at(1, CamSwitches::NameRole).toString(), "Limit switch, reverse: filter time");
        switches.choose(static_cast<int>(switches.names().size()));
        QCOMPARE(switches.names().last(), "Date coder pulse");
        QCOMPARE(rig.link.parameters[0].name, std::string("signal.coder_place"));
        QCOMPARE(rig.link.parameters[1].name, std::string("signal.coder_pulse"));
        answerAll(20);
        QCOMPARE(at(0, CamSwitches::NameRole).toString(), "Date coder pulse: film to the cut");
        QCOMPARE(at(1, CamSwitches::NoteRole).toString(), "1 ms to 1000 ms");
        QCOMPARE(CamSwitches::words(QStringLiteral("parameter.emergency_stop_contact")),
                 "Emergency stop: contact");
        QCOMPARE(CamSwitches::words(QStringLiteral("parameter.switch8_lead")), "Cam switch 8: lead time");
        QVERIFY(CamSwitches::words(QStringLiteral("parameter.ramp_time")).isEmpty());
    }

    void everyBitHasItsLamp()
    {
        PanelRig rig;
        rig.connectIdle();
        rig.link.status.faultBits = 0xFF;
        become(rig, State::Fault, 0x3FF);
        IoList& io = *rig.maintenance.io();
        io.setWatched(true);
        const auto lit = std::ranges::count_if(io.rows()->rows(), [](const IoList::Row& row) {
            return (row.side == IoList::Side::Fault || row.side == IoList::Side::Warning) &&
                   row.lamp != IoList::Lamp::Off;
        });
        QCOMPARE(lit, 8 + 10);
        QCOMPARE(lampOf(io, QStringLiteral("Following error too large")), IoList::Lamp::Bad);
        QCOMPARE(lampOf(io, QStringLiteral("No panel heartbeat")), IoList::Lamp::Warning);
        QCOMPARE(lampOf(io, QStringLiteral("Not referenced")), IoList::Lamp::On); // a notice, as under Alarms
    }

    void aTurnOfTheMasterIsOneBag()
    {
        PanelRig rig;
        DryRun& run = *rig.maintenance.dryRun();
        QVERIFY(run.available() && run.cutter());
        const double bagMm = run.bagLengthMm();
        QCOMPARE(bagMm, 250.0);
        const double before = run.filmPositionMm();
        for (int i = 0; i < 360; ++i)
            run.turn(1);
        QVERIFY(std::abs(run.masterDeg()) < 1e-6 || std::abs(run.masterDeg() - 360) < 1e-6);
        QVERIFY(std::abs(run.filmPositionMm() - before - bagMm) < 1e-6);
        run.turn(-360);
        QVERIFY(std::abs(run.filmPositionMm() - before) < 1e-6);
    }

    // At the cut the boundary of a bag is under the knife, and both move together.
    void theCutIsAtTheKnife()
    {
        PanelRig rig;
        DryRun& run = *rig.maintenance.dryRun();
        run.turn(run.cutMasterDeg());
        QVERIFY(run.synchronous());
        QVERIFY(std::ranges::any_of(run.cuts(), [](QPointF cut) { return std::abs(cut.x()) < 1e-9; }));
        QVERIFY(std::abs(run.knifeDeg() - run.cutDeg()) < 1e-9);
        QVERIFY(std::abs(figure(run, QStringLiteral("Knife speed / film speed")) - 100) < 0.05);
        run.turn(-run.cutMasterDeg());
        QVERIFY(!run.synchronous());
        const auto& curves = *rig.editor.solution().curves;
        QCOMPARE(figure(run, QStringLiteral("Knife speed")),
                 std::round(curves.velocityMmPerS.front() * 10) / 10);
    }

    void aFingerTurnsItRoundTheCenter()
    {
        PanelRig rig;
        DryRun& run = *rig.maintenance.dryRun();
        run.setPlaying(true);
        run.grab(0, -50); // at the top
        QVERIFY(!run.playing());
        run.drag(50, 0);
        QVERIFY(std::abs(run.masterDeg() - 90) < 1e-9);
        run.drag(0, 50);
        run.drag(-50, 0);
        run.drag(0, -20);
        run.drag(20, 0);
        QVERIFY(std::abs(run.masterDeg() - 90) < 1e-6); // in the next cycle
        run.drag(0, -20);
        run.drag(-20, 0); // backward through the start
        QVERIFY(std::abs(run.masterDeg() - 270) < 1e-6);
        QVERIFY(rig.link.requests.isEmpty() && rig.link.jogs.isEmpty() && rig.link.parameters.isEmpty());
    }

    void itPlaysUntilTheRecipeCannotMove()
    {
        PanelRig rig;
        DryRun& run = *rig.maintenance.dryRun();
        run.setPlaying(true);
        QTRY_VERIFY(run.masterDeg() > 2);
        rig.editor.newProgram(static_cast<int>(profile::ProgramKind::PointCam));
        QVERIFY(!run.cutter() && run.available());
        QVERIFY(run.cuts().isEmpty());
        QVERIFY(!std::isnan(figure(run, QStringLiteral("Position"))));
        run.toStart();
        QVERIFY(!run.playing());
        QCOMPARE(run.masterDeg(), 0.0);
    }
};

CAMPANEL_TEST(TestManual)

} // namespace test_manual

#include "test_manual.moc"
