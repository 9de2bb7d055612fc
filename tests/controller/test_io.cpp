// SPDX-License-Identifier: Apache-2.0
// The pins beside the axes: drive alarm, drive enable, inputs that are reported only, their registers, torque
// and infeed.
#include "rig.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_io {

using namespace campanel::test;
namespace controller = campanel::controller;

namespace {

constexpr std::uint64_t second = 1'000'000;
constexpr unsigned enablePin = 1u << CTL_OUTPUT_BIT_DRIVE_ENABLE;
constexpr unsigned stopWarning = 1u << CTL_WARNING_BIT_EMERGENCY_STOP;

controller::Machine& machineOf(Rig& rig)
{
    return rig.controller().machine();
}

std::uint16_t pins(Rig& rig, unsigned address)
{
    return rig.status(static_cast<std::uint16_t>(address));
}

} // namespace

class TestIo : public QObject {
    Q_OBJECT

private slots:
    void driveAlarmIsAFaultAtOnce_data();
    void driveAlarmIsAFaultAtOnce();
    void limitSwitchesStopNothing();
    void bouncingEmergencyStopIsOneWarning();
    void contactsMayBeNormallyClosed();
    void shortChangesAreFiltered();
    void whatIsOnAtPowerUpCountsAtOnce();
    void drivesAreEnabledAsSet();
    void noPulseIsLostToTheEnable();
    void pinsFollowTheMachine();
    void missingPinsAreNotAvailable();
    void infeed();
    void torque();
};

void TestIo::driveAlarmIsAFaultAtOnce_data()
{
    QTest::addColumn<unsigned>("state");
    QTest::addColumn<bool>("changes");
    QTest::newRow("running") << CTL_STATE_RUNNING << false;
    QTest::newRow("change of program") << CTL_STATE_RUNNING << true;
    QTest::newRow("stopping") << CTL_STATE_STOPPING << false;
    QTest::newRow("homing") << CTL_STATE_HOMING << false;
    QTest::newRow("jogging") << CTL_STATE_JOGGING << false;
    QTest::newRow("standstill") << CTL_STATE_READY << false;
}

void TestIo::driveAlarmIsAFaultAtOnce()
{
    QFETCH(unsigned, state);
    QFETCH(bool, changes);
    const Registers first = camBank(10000, 1, 1'600'000).registers();
    const Registers next = camBank(10000, 1, 3'200'000).registers();
    Rig rig;
    rig.install(first);
    rig.write(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT, {0, 600}); // a following error would be close behind
    if (state == CTL_STATE_JOGGING) {
        rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
        rig.run(100'000);
    } else if (state != CTL_STATE_READY) {
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        rig.run(100'000);
        if (state != CTL_STATE_HOMING)
            QVERIFY(rig.runUntilState(CTL_STATE_RUNNING));
        if (state != CTL_STATE_HOMING)
            rig.run(second);
        if (state == CTL_STATE_STOPPING)
            QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    }
    if (changes) { // while it slows down for the boundary
        QCOMPARE(rig.download(next, 2), CTL_TRANSFER_RESULT_ACCEPTED);
        QCOMPARE(rig.apply(next, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);
        while (rig.core().motion.ramp.speed == rig.core().motion.ramp.full)
            rig.controller().step();
        rig.run(20'000);
    }
    QCOMPARE(rig.core().motion.state, state);
    machineOf(rig).setInput(CTL_INPUT_BIT_DRIVE_ALARM, true);
    const std::int64_t stopped = rig.core().motion.commanded;
    rig.controller().step();
    QCOMPARE(rig.core().motion.state, CTL_STATE_FAULT);
    rig.run(second);
    QCOMPARE(rig.core().motion.commanded, stopped);
    QCOMPARE(rig.status(CTL_REG_STATUS_FAULT), 1u << CTL_FAULT_BIT_DRIVE_ALARM);
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_FAULT_PERSISTS);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_DRIVE_ALARM);
    machineOf(rig).setInput(CTL_INPUT_BIT_DRIVE_ALARM, false);
    rig.run(1000);
    QCOMPARE(rig.core().motion.state, CTL_STATE_FAULT);
    rig.heartbeat();
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NO_FAULT);
    rig.write(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT, {0, 3000});
    // The armed program takes over at standstill, as after a Stop.
    QCOMPARE(rig.core().banks.active_crc, crc32(changes ? next : first));
    rig.start();
    rig.run(second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
}

// They are on from power-up.
void TestIo::limitSwitchesStopNothing()
{
    controller::MachineOptions options;
    options.inputs = 1u << CTL_INPUT_BIT_LIMIT_FORWARD | 1u << CTL_INPUT_BIT_LIMIT_REVERSE;
    Rig without;
    Rig with(options);
    for (Rig* rig : {&without, &with}) {
        rig->install(camBank(10000, 1, 1'600'000));
        rig->start();
        rig->run(10 * second);
    }
    QCOMPARE(with.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(with.core().motion.commanded, without.core().motion.commanded);
    QCOMPARE(with.core().motion.fault, 0);
    QCOMPARE(pins(with, CTL_REG_IO_INPUTS) & options.inputs, options.inputs);
    QCOMPARE(pins(without, CTL_REG_IO_INPUTS) & options.inputs, 0);
}

void TestIo::bouncingEmergencyStopIsOneWarning()
{
    Rig rig;
    rig.install(camBank(10000, 1, 1'600'000));
    rig.start();
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & stopWarning) == 0);
    int changes = 0;
    unsigned before = 0;
    std::uint32_t ended = 0;        // cycles when the run had ended
    for (int i = 0; i < 400; ++i) { // 20 s, and 10 s of quiet
        machineOf(rig).setInput(CTL_INPUT_BIT_EMERGENCY_STOP, i < 280 && (i * 7) % 5 < 2);
        rig.run(50'000);
        rig.heartbeat();
        const unsigned now = rig.status(CTL_REG_STATUS_WARNING) & stopWarning;
        changes += std::exchange(before, now) != now ? 1 : 0;
        if (i == 100)
            ended = rig.core().motion.cycle_count;
    }
    QCOMPARE(changes, 2); // it came and went
    QCOMPARE(before, 0u);
    QCOMPARE(rig.core().motion.state, CTL_STATE_READY); // the first touch has ended the run
    QCOMPARE(rig.core().motion.cycle_count, ended);
    rig.start();
}

// One contact does not change another one's kind; of a sensor there is none.
void TestIo::contactsMayBeNormallyClosed()
{
    MemoryFlash flash;
    controller::MachineOptions options;
    options.inputs = 1u << CTL_INPUT_BIT_EMERGENCY_STOP | 1u << CTL_INPUT_BIT_LIMIT_REVERSE;
    constexpr unsigned contacts = 0x000F;
    const BankImage bank = camBank(10000, 1, 1'600'000);
    {
        Rig rig(options, &flash);
        rig.install(bank);
        QCOMPARE(pins(rig, CTL_REG_IO_INPUTS) & contacts, options.inputs);
        rig.setParameter(CTL_REG_PARAMETER_EMERGENCY_STOP_CONTACT, CTL_CONTACT_NORMALLY_CLOSED);
        rig.run(1000);
        QCOMPARE(pins(rig, CTL_REG_IO_INPUTS) & contacts, 1u << CTL_INPUT_BIT_LIMIT_REVERSE);
        rig.setParameter(CTL_REG_PARAMETER_LIMIT_REVERSE_CONTACT, CTL_CONTACT_NORMALLY_CLOSED);
        rig.run(3 * second);
        QCOMPARE(pins(rig, CTL_REG_IO_INPUTS) & contacts, 0u);
        rig.heartbeat();
        rig.start();
        QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(bank.registers())), CTL_REFUSAL_NONE);
        machineOf(rig).setInput(CTL_INPUT_BIT_EMERGENCY_STOP, false); // or its wire breaks
        QVERIFY(rig.runUntilState(CTL_STATE_READY, 2 * second));
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_EMERGENCY_STOP);
    }
    Rig again(options, &flash);
    again.run(1000);
    QCOMPARE(pins(again, CTL_REG_IO_INPUTS) & contacts, 0u);
}

void TestIo::shortChangesAreFiltered()
{
    Rig rig;
    rig.install(camBank(10000, 1, 1'600'000));
    rig.setParameter(CTL_REG_PARAMETER_DRIVE_ALARM_FILTER, 5);
    rig.setParameter(CTL_REG_PARAMETER_EMERGENCY_STOP_FILTER, 20);
    const auto pulse = [&rig](unsigned input, std::uint64_t timeUs) {
        machineOf(rig).setInput(input, true);
        rig.run(timeUs);
        const unsigned seen = rig.core().io.inputs & 1u << input;
        machineOf(rig).setInput(input, false);
        rig.run(timeUs);
        return seen != 0;
    };
    // Contacts that bounce never add up. The drive itself stops with its alarm.
    for (int i = 0; i < 20; ++i)
        QVERIFY(!pulse(CTL_INPUT_BIT_DRIVE_ALARM, 4500));
    rig.start();
    for (int i = 0; i < 20; ++i) {
        QVERIFY(!pulse(CTL_INPUT_BIT_EMERGENCY_STOP, 19'500));
        rig.heartbeat();
    }
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QVERIFY(pulse(CTL_INPUT_BIT_LIMIT_FORWARD, 500)); // not filtered
    QVERIFY(pulse(CTL_INPUT_BIT_EMERGENCY_STOP, 21'000));
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 2 * second));
    QVERIFY(pulse(CTL_INPUT_BIT_DRIVE_ALARM, 5500));
    QCOMPARE(rig.core().motion.state, CTL_STATE_FAULT);
}

void TestIo::whatIsOnAtPowerUpCountsAtOnce()
{
    MemoryFlash flash;
    const BankImage bank = camBank(10000, 1, 1'600'000);
    {
        Rig rig({}, &flash);
        rig.install(bank);
        rig.setParameter(CTL_REG_PARAMETER_EMERGENCY_STOP_FILTER, 100);
        QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(bank.registers())), CTL_REFUSAL_NONE);
    }
    controller::MachineOptions options;
    options.inputs = 1u << CTL_INPUT_BIT_EMERGENCY_STOP;
    Rig rig(options, &flash);
    rig.controller().step();
    rig.heartbeat();
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_EMERGENCY_STOP);
}

void TestIo::drivesAreEnabledAsSet()
{
    Rig rig;
    rig.install(camBank(10000, 1, 1'600'000));
    QVERIFY((pins(rig, CTL_REG_IO_OUTPUTS) & enablePin) != 0); // always, unless set otherwise
    rig.setParameter(CTL_REG_PARAMETER_DRIVE_ENABLE, CTL_DRIVE_ENABLE_WHILE_RUNNING);
    rig.run(1000);
    QVERIFY((pins(rig, CTL_REG_IO_OUTPUTS) & enablePin) == 0);
    rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
    QVERIFY((pins(rig, CTL_REG_IO_OUTPUTS) & enablePin) != 0);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, second)); // the heartbeat is over
    rig.run(400'000);
    QVERIFY((pins(rig, CTL_REG_IO_OUTPUTS) & enablePin) != 0);
    rig.run(110'000);
    QVERIFY((pins(rig, CTL_REG_IO_OUTPUTS) & enablePin) == 0);
    rig.heartbeat();
    rig.start();
    rig.run(10 * second);
    QVERIFY((pins(rig, CTL_REG_IO_OUTPUTS) & enablePin) != 0);
    // Never: nothing follows.
    rig.setParameter(CTL_REG_PARAMETER_DRIVE_ENABLE, CTL_DRIVE_ENABLE_OFF);
    QVERIFY(rig.runUntilState(CTL_STATE_FAULT, 2 * second));
    QCOMPARE(rig.core().motion.fault, 1u << CTL_FAULT_BIT_FOLLOWING_ERROR);
    QVERIFY((pins(rig, CTL_REG_IO_OUTPUTS) & enablePin) == 0);
}

// A drive that is enabled only while it moves is where one is that always was.
void TestIo::noPulseIsLostToTheEnable()
{
    Rig always;
    Rig sometimes;
    for (Rig* rig : {&always, &sometimes}) {
        rig->install(camBank(10000, 1, 1'600'000));
        rig->setParameter(CTL_REG_PARAMETER_DRIVE_ENABLE,
                          rig == &always ? CTL_DRIVE_ENABLE_ON : CTL_DRIVE_ENABLE_WHILE_RUNNING);
        for (int i = 0; i < 3; ++i) {
            rig->start();
            rig->run(3 * second);
            rig->command(i == 0 ? CTL_COMMAND_STOP_NOW : CTL_COMMAND_STOP_AT_CYCLE_END);
            QVERIFY(rig->runUntilState(CTL_STATE_READY));
            rig->run(2 * second);
        }
    }
    QVERIFY((sometimes.core().io.outputs & enablePin) == 0);
    QCOMPARE(sometimes.core().motion.commanded, always.core().motion.commanded);
    QCOMPARE(sometimes.core().motion.actual, always.core().motion.actual);
}

// The pins of index mark, mark sensor and product eye change once a cycle.
void TestIo::pinsFollowTheMachine()
{
    controller::MachineOptions options;
    options.products.scatterMm = 0.0;
    Rig rig(options);
    rig.install(camBank(10000, 1, 1'600'000));
    rig.start();
    rig.run(5 * second);
    const std::uint32_t cycles = rig.core().motion.cycle_count;
    std::array<int, 3> edges{};
    unsigned before = rig.core().io.inputs;
    for (const std::uint64_t endUs = rig.controller().nowUs() + 10 * second;
         rig.controller().nowUs() < endUs;) {
        rig.controller().step();
        const unsigned rising = rig.core().io.inputs & ~std::exchange(before, rig.core().io.inputs);
        for (unsigned i = 0; i < 3; ++i)
            edges[i] += (rising & 1u << (CTL_INPUT_BIT_INDEX_MARK + i)) != 0 ? 1 : 0;
    }
    const int passed = static_cast<int>(rig.core().motion.cycle_count - cycles);
    QVERIFY(passed >= 49);
    for (const int each : edges)
        QVERIFY2(std::abs(each - passed) <= 1, qPrintable(QString::number(each)));
    constexpr unsigned kept =
        1u << CTL_IO_BIT_AXIS_KEPT | 1u << CTL_IO_BIT_FILM_KEPT | 1u << CTL_IO_BIT_INFEED_KEPT;
    QCOMPARE(pins(rig, CTL_REG_IO_AVAILABLE), ((2u << CTL_IO_BIT_LAST) - 1u) & ~kept);
    rig.core().board.config.kept_positions = kept;
    QCOMPARE(pins(rig, CTL_REG_IO_AVAILABLE), (2u << CTL_IO_BIT_LAST) - 1u);
}

void TestIo::missingPinsAreNotAvailable()
{
    Rig rig;
    ctl_port& port = rig.core().board.port;
    port.inputs = nullptr;
    port.torque = nullptr;
    port.reverse = nullptr;
    rig.install(sineCam(0.0, 1000.0, 200, 1'600'000).registers());
    rig.start();
    rig.run(second);
    QCOMPARE(pins(rig, CTL_REG_IO_AVAILABLE), 1u << CTL_IO_BIT_OUTPUTS);
    QCOMPARE(rig.read(CTL_REG_IO_TORQUE, 4), (Registers{0, 0, 0, 0}));
    port.outputs = nullptr;
    rig.run(second);
    QCOMPARE(pins(rig, CTL_REG_IO_AVAILABLE), 0);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
}

void TestIo::infeed()
{
    Rig rig;
    rig.install(camBank(10000, 1, 1'600'000));
    rig.start();
    rig.run(10 * second);
    // 500 mm and 20 000 pulses a product, 2.5 m/s; the motor lags by 1 / (60 Hz pi).
    const auto error = static_cast<std::int16_t>(pins(rig, CTL_REG_IO_INFEED_FOLLOWING_ERROR));
    QVERIFY2(std::abs(error - 2500.0 * 1000.0 / (60.0 * std::numbers::pi)) < 700.0,
             qPrintable(QString::number(error)));
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.run(second);
    QVERIFY(std::abs(static_cast<std::int16_t>(pins(rig, CTL_REG_IO_INFEED_FOLLOWING_ERROR))) <= 25);
    const double expected =
        static_cast<double>(machineOf(rig).infeedEncoder()) / 256.0 / 20'000.0 * 500'000.0;
    QVERIFY(expected > 20e6);
    QVERIFY(std::abs(rig.signedWide(CTL_REG_IO_INFEED_POSITION) - expected) < 2.0);
}

// Friction at constant speed; inertia x acceleration of a sine, without friction where it turns.
void TestIo::torque()
{
    controller::MachineOptions options;
    options.drive = {0.002, 0.24, 2.4};
    Rig even(options);
    even.install(sineCam(40'000.0, 0.0, 200, 8'000'000).registers());
    QCOMPARE(static_cast<std::int16_t>(pins(even, CTL_REG_IO_TORQUE)), 0);
    even.start();
    even.run(3 * second);
    const int angle = pins(even, CTL_REG_IO_TORQUE_ANGLE);
    QVERIFY(angle > 0 && std::abs(angle - ctl_motion_master_angle(&even.core().motion)) < 500); // 14 ms
    double sum = 0.0;
    for (int i = 0; i < 4000; ++i) {
        even.controller().step();
        sum += machineOf(even).torqueTenthPercent();
    }
    QVERIFY2(std::abs(sum / 4000.0 - 100.0) < 5.0, qPrintable(QString::number(sum / 4000.0)));

    options.drive.frictionNm = 0.0;
    Rig sine(options);
    constexpr double swing = 2000.0; // pulses; 5 Hz
    sine.install(sineCam(0.0, swing, 400, 1'600'000).registers());
    sine.start();
    sine.run(3 * second);
    double square = 0.0;
    for (int i = 0; i < 8000; ++i) {
        sine.controller().step();
        square += std::pow(machineOf(sine).torqueTenthPercent(), 2.0);
    }
    const double turn = 2.0 * std::numbers::pi;
    const double acceleration = swing * std::pow(turn * 5.0, 2.0) * turn / 10'000.0; // rad/s^2
    const double expected = 1000.0 * 0.002 * acceleration / 2.4 / std::numbers::sqrt2;
    const double measured = std::sqrt(square / 8000.0);
    QVERIFY2(std::abs(measured / expected - 1.0) < 0.03, qPrintable(QString::number(measured / expected)));
}

CAMPANEL_TEST(TestIo)

} // namespace test_io

#include "test_io.moc"
