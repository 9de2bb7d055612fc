// SPDX-License-Identifier: Apache-2.0
// Light tower and horn on the pins: each condition by the table, blinking, acknowledgement.
#include "rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace test_tower {

using namespace campanel::test;

namespace {

constexpr std::uint64_t second = 1'000'000;
constexpr unsigned red = 1u << CTL_OUTPUT_BIT_TOWER_RED;
constexpr unsigned yellow = 1u << CTL_OUTPUT_BIT_TOWER_YELLOW;
constexpr unsigned green = 1u << CTL_OUTPUT_BIT_TOWER_GREEN;
constexpr unsigned horn = 1u << CTL_OUTPUT_BIT_HORN;
constexpr unsigned running = 1u << CTL_OUTPUT_BIT_RUNNING;
constexpr unsigned tower = red | yellow | green | horn;

unsigned levels(Rig& rig)
{
    return rig.core().io.outputs; // io.outputs takes the time of a request
}

// "on", "off" or "blinks 500 ms": what an output does in the next four seconds.
std::string conduct(Rig& rig, unsigned output)
{
    constexpr std::uint64_t stepUs = 10'000;
    constexpr int steps = 400;
    int on = 0;
    int edges = 0;
    bool before = (levels(rig) & output) != 0;
    for (int i = 0; i < steps; ++i) {
        rig.run(stepUs);
        const bool now = (levels(rig) & output) != 0;
        on += now ? 1 : 0;
        edges += now != before ? 1 : 0;
        before = now;
    }
    if (edges == 0)
        return on == 0 ? "off" : "on";
    return edges == 8 && std::abs(on - steps / 2) <= 4 ? "blinks" : "flickers";
}

// The whole table, one light after the other: fault red is CTL_REG_SIGNAL_FAULT_RED.
void setMode(Rig& rig, unsigned condition, unsigned light, std::uint16_t mode)
{
    rig.setParameter(static_cast<std::uint16_t>(CTL_REG_SIGNAL_FAULT_RED + 4 * condition + light), mode);
}

void darken(Rig& rig)
{
    rig.write(CTL_REG_SIGNAL_FAULT_RED, Registers(4 * (CTL_SIGNAL_BIT_LAST + 1)));
}

void ready(Rig& rig)
{
    rig.install(camBank(10'000, 1, 1'600'000));
    rig.heartbeat();
}

} // namespace

class TestTower : public QObject {
    Q_OBJECT

private slots:
    void asShipped()
    {
        Rig rig;
        rig.run(100'000);
        QCOMPARE(levels(rig) & (tower | running), 0u);
        ready(rig);
        rig.setParameter(CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, CTL_MAX_PARAMETER_HEARTBEAT_TIMEOUT);
        rig.heartbeat();
        QCOMPARE(conduct(rig, green), std::string("off"));
        rig.start();
        rig.heartbeat();
        rig.run(50'000);
        QCOMPARE(conduct(rig, green), std::string("on"));
        QCOMPARE(levels(rig) & (tower | running), green | running);
        rig.controller().machine().setInput(CTL_INPUT_BIT_CODER, true);
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
        rig.run(100'000);
        QCOMPARE(levels(rig) & (tower | running), yellow);
        rig.controller().machine().setInput(CTL_INPUT_BIT_CODER, false);
        rig.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
        rig.run(200'000);
        QCOMPARE(conduct(rig, red), std::string("blinks"));
        QCOMPARE(rig.command(CTL_COMMAND_ACKNOWLEDGE), CTL_REFUSAL_NONE);
        QCOMPARE(conduct(rig, red), std::string("on"));
    }

    void modes_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<std::string>("before");
        QTest::addColumn<std::string>("acknowledged");
        const auto row = [](const char* name, int mode, const char* before, const char* acknowledged) {
            QTest::newRow(name) << mode << std::string(before) << std::string(acknowledged);
        };
        row("off", CTL_SIGNAL_MODE_OFF, "off", "off");
        row("on", CTL_SIGNAL_MODE_ON, "on", "on");
        row("blink", CTL_SIGNAL_MODE_BLINK, "blinks", "blinks");
        row("blink, then on", CTL_SIGNAL_MODE_BLINK_THEN_ON, "blinks", "on");
        row("on, then off", CTL_SIGNAL_MODE_ON_THEN_OFF, "on", "off");
    }

    // The same on each light, and anew with each occurrence.
    void modes()
    {
        QFETCH(int, mode);
        QFETCH(std::string, before);
        QFETCH(std::string, acknowledged);
        for (unsigned light = 0; light < 4; ++light) {
            Rig rig;
            ready(rig);
            darken(rig);
            setMode(rig, CTL_SIGNAL_BIT_FAULT, light, static_cast<std::uint16_t>(mode));
            const unsigned output = red << light;
            for (int occurrence = 0; occurrence < 2; ++occurrence) {
                rig.controller().machine().setInput(CTL_INPUT_BIT_DRIVE_ALARM, true);
                rig.run(50'000);
                QCOMPARE(conduct(rig, output), before);
                QCOMPARE(rig.command(CTL_COMMAND_ACKNOWLEDGE), CTL_REFUSAL_NONE);
                rig.run(50'000);
                QCOMPARE(conduct(rig, output), acknowledged);
                QCOMPARE(levels(rig) & tower & ~output, 0u);
                rig.controller().machine().setInput(CTL_INPUT_BIT_DRIVE_ALARM, false);
                rig.run(50'000);
                QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
                rig.run(50'000);
                QCOMPARE(levels(rig) & output, 0u);
            }
        }
    }

    void whatBlinksGoesFirst()
    {
        Rig rig;
        ready(rig);
        darken(rig);
        setMode(rig, CTL_SIGNAL_BIT_FAULT, 0, CTL_SIGNAL_MODE_ON);
        setMode(rig, CTL_SIGNAL_BIT_WARNING, 0, CTL_SIGNAL_MODE_BLINK);
        rig.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true); // both
        rig.run(50'000);
        QCOMPARE(conduct(rig, red), std::string("blinks"));
    }

    void everyConditionHasItsRow()
    {
        const std::array<std::function<void(Rig&)>, CTL_SIGNAL_BIT_ORDER> reach{
            [](Rig& rig) { rig.controller().machine().setInput(CTL_INPUT_BIT_DRIVE_ALARM, true); },
            [](Rig& rig) { rig.controller().machine().setInput(CTL_INPUT_BIT_DOOR, true); },
            nullptr, // in test_packing_line, filmWaitsForAProduct
            [](Rig& rig) { rig.start(); },
            [](Rig&) {},
        };
        for (unsigned condition = 0; condition < reach.size(); ++condition) {
            if (!reach[condition])
                continue;
            Rig rig;
            ready(rig);
            rig.setParameter(CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT, CTL_MAX_PARAMETER_HEARTBEAT_TIMEOUT);
            darken(rig);
            setMode(rig, condition, 3, CTL_SIGNAL_MODE_ON);
            reach[condition](rig);
            rig.heartbeat();
            rig.run(50'000);
            QVERIFY2((levels(rig) & horn) != 0, qPrintable(QString::number(condition)));
            for (unsigned other = 0; other < reach.size(); ++other)
                setMode(rig, other, 0, other == condition ? CTL_SIGNAL_MODE_OFF : CTL_SIGNAL_MODE_ON);
            rig.run(50'000);
            QVERIFY2((levels(rig) & red) == 0, qPrintable(QString::number(condition)));
        }
    }

    void tryingALightNeedsNoCondition()
    {
        Rig rig;
        ready(rig);
        darken(rig);
        QCOMPARE(rig.command(CTL_COMMAND_TRY_OUTPUT, CTL_OUTPUT_BIT_HORN, 1), CTL_REFUSAL_NONE);
        rig.run(1000);
        QCOMPARE(levels(rig) & tower, horn);
    }
};

CAMPANEL_TEST(TestTower)

} // namespace test_tower

#include "test_tower.moc"
