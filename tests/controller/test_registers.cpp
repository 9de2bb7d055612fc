// SPDX-License-Identifier: Apache-2.0
// The registers against the register table: everything documented can be read, only writable registers can be
// written, limits hold, read-back is true.
#include "modbus/map/register_map.h"
#include "rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace test_registers {

using namespace campanel;
using namespace campanel::test;

class TestRegisters : public QObject {
    Q_OBJECT

private slots:
    void identity();
    void everyRegisterCanBeRead();
    void onlyWritableOnesCanBeWritten();
    void defaultsAndLimits();
    void halfOfAWideValueIsChecked();
    void readback();
    void unknownBankIsZero();
    void clock();
    void uptimeAndSampleTime();
};

void TestRegisters::identity()
{
    Rig rig;
    const Registers expected{0xCA3D,
                             modbus::mapMajor,
                             modbus::mapMinor,
                             9,
                             8,
                             7,
                             0x0123,
                             0x4567,
                             0x89AB,
                             0xCDEF,
                             CTL_PROGRAM_KINDS,
                             modbus::rowCapacity,
                             modbus::bankRegisters,
                             modbus::blockRegisters,
                             0x007A,
                             0x1200,
                             16,
                             0x0003,
                             0x0D40};
    QCOMPARE(rig.read(0, 19), expected);
}

void TestRegisters::everyRegisterCanBeRead()
{
    Rig rig;
    for (const modbus::RegisterInfo& info : modbus::registers()) {
        const auto count = std::min<std::uint16_t>(info.count, 125);
        QVERIFY2(rig.read(info.address, count).size() == count, info.name.data());
        const auto last = static_cast<std::uint16_t>(info.address + info.count - 1);
        QVERIFY2(rig.read(last, 1).size() == 1, info.name.data());
    }
}

void TestRegisters::onlyWritableOnesCanBeWritten()
{
    Rig rig;
    for (const modbus::RegisterInfo& info : modbus::registers()) {
        const std::uint16_t count = std::min<std::uint16_t>(info.count, 2);
        const Registers now = rig.read(info.address, count);
        const int refused = rig.write(info.address, now);
        const bool writable = info.access == modbus::Access::ReadWrite;
        QVERIFY2(writable ? refused == 0 : refused == 2, info.name.data());
    }
}

void TestRegisters::defaultsAndLimits()
{
    Rig rig;
    int checked = 0;
    for (const modbus::RegisterInfo& info : modbus::registers()) {
        if (!modbus::isMachineData(info))
            continue;
        // Exceeds a physical value by this many steps.
        const auto words = [&info](double value, int steps = 0) {
            const auto raw = static_cast<std::uint32_t>(std::llround(value / info.scale) + steps);
            return info.count == 2 ? Registers{static_cast<std::uint16_t>(raw >> 16),
                                               static_cast<std::uint16_t>(raw & 0xFFFFu)}
                                   : Registers{static_cast<std::uint16_t>(raw)};
        };
        QCOMPARE(rig.read(info.address, info.count), words(info.defaultValue));
        QCOMPARE(rig.write(info.address, words(info.maximum)), 0);
        QCOMPARE(rig.write(info.address, words(info.minimum)), 0);
        QCOMPARE(rig.write(info.address, words(info.maximum, 1)), 3);
        if (info.minimum > 0 || info.type == modbus::RegisterType::I16)
            QCOMPARE(rig.write(info.address, words(info.minimum, -1)), 3);
        QCOMPARE(rig.read(info.address, info.count), words(info.minimum));
        ++checked;
    }
    QVERIFY(checked > 20);
}

void TestRegisters::halfOfAWideValueIsChecked()
{
    Rig rig;
    QCOMPARE(rig.write(CTL_REG_PARAMETER_JOG_FREQUENCY, {1}), 3); // 65536 + 1000 Hz
    QCOMPARE(rig.write(CTL_REG_PARAMETER_JOG_FREQUENCY + 1, {2000}), 0);
    QCOMPARE(rig.read(CTL_REG_PARAMETER_JOG_FREQUENCY, 2), (Registers{0, 2000}));
}

void TestRegisters::readback()
{
    Rig rig;
    const Registers answer =
        rig.readWrite(CTL_REG_READBACK_RESULT_TAG, 3 + 19, CTL_REG_READBACK_TAG, {77, 0, 19});
    QCOMPARE(answer.size(), std::size_t{22});
    QCOMPARE(answer[0], 77);
    QCOMPARE(answer[1], 0);
    QCOMPARE(answer[2], 19);
    QCOMPARE(Registers(answer.begin() + 3, answer.end()), rig.read(0, 19));
    const Registers hole =
        rig.readWrite(CTL_REG_READBACK_RESULT_TAG, 5, CTL_REG_READBACK_TAG, {78, 0x50, 19});
    QCOMPARE(hole, (Registers{78, 0x50, 0, 0, 0}));
}

void TestRegisters::unknownBankIsZero()
{
    Rig rig;
    rig.download(camBank(10000, 1, 8'000'000).registers());
    QCOMPARE(rig.read(CTL_STAGED_BANK_BASE, 2), (Registers{1, 1}));
    QCOMPARE(rig.command(CTL_COMMAND_DISCARD_STAGED), CTL_REFUSAL_NONE);
    QCOMPARE(rig.read(CTL_STAGED_BANK_BASE, 2), (Registers{0, 0}));
    QCOMPARE(rig.read(CTL_ACTIVE_BANK_BASE, 2), (Registers{0, 0}));
}

void TestRegisters::clock()
{
    Rig rig;
    const auto notSet = static_cast<std::uint16_t>(1u << CTL_WARNING_BIT_CLOCK_NOT_SET);
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & notSet) != 0);
    QCOMPARE(rig.statusWide(CTL_REG_CLOCK_UNIX_TIME), 0u);
    QCOMPARE(rig.command(CTL_COMMAND_SET_CLOCK, 0, 0, 0), CTL_REFUSAL_BAD_ARGUMENT);
    QCOMPARE(rig.command(CTL_COMMAND_SET_CLOCK, 0, 0, 1'750'000'000), CTL_REFUSAL_NONE);
    rig.run(9'999'000);
    QCOMPARE(rig.statusWide(CTL_REG_CLOCK_UNIX_TIME), 1'750'000'010u);
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & notSet) == 0);
}

void TestRegisters::uptimeAndSampleTime()
{
    Rig rig;
    rig.run(70'000'000 - rig.controller().nowUs());
    const Registers block = rig.read(CTL_REG_STATUS_UPTIME, 8);
    QCOMPARE(block[1], 70);
    QCOMPARE(block[7],
             static_cast<std::uint16_t>(70'001)); // 1.75 ms of silence before it was accepted, wraps at 65536
}

CAMPANEL_TEST(TestRegisters)

} // namespace test_registers

#include "test_registers.moc"
