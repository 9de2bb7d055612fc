// SPDX-License-Identifier: Apache-2.0
// Programs that follow the encoder of a line, and a master without a machine, whose counts a test sets.
#pragma once

#include "rig.h"

#include "master/ctl_master.h"
#include "support/cam_image.h"

#include <QTest>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace campanel::test::master {

inline constexpr std::uint32_t cycleTicks = 1'600'000; // 0.2 s: 300 a minute
inline constexpr std::uint64_t cycleUs = 200'000;
inline constexpr double fullMmPerS = 1250.0;
inline constexpr std::int64_t knifePulses = 10'000; // a cycle

inline BankImage cutter()
{
    BankImage bank = camBank(static_cast<std::uint32_t>(knifePulses), 1, cycleTicks);
    bank.bagLengthUm = 250'000;
    return bank;
}

// A cam of 0.2 revolutions of its master: 2000 counts, 0.2 s at 60 r/min.
inline constexpr double camNet = 5000.0; // pulses a cycle
inline constexpr double camSwing = 300.0;
inline constexpr double camMmPerS = 250.0;

inline CamImage cam()
{
    CamImage image = sineCam(camNet, camSwing, 400, cycleTicks);
    image.masterRampMs = 0;
    return image;
}

inline controller::MachineOptions onLine(double mmPerS, std::uint32_t counts = 10'000)
{
    controller::MachineOptions options;
    options.film.slipMm = 0.0;
    options.film.stretch = 0.0;
    options.film.markNoiseMm = 0.0;
    options.shaft.counts = counts;
    options.shaft.speedMmPerS = mmPerS;
    return options;
}

inline void followEncoder(Rig& rig)
{
    rig.install(cutter());
    QCOMPARE(rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER}), 0);
    rig.run(500'000); // it measures the speed
}

inline std::uint16_t state(Rig& rig)
{
    return rig.status(CTL_REG_MASTER_STATUS_STATE);
}

inline bool runUntilEngaged(Rig& rig)
{
    for (int i = 0; i < 2000 && state(rig) != CTL_MASTER_STATE_ENGAGED; ++i)
        rig.run(10'000);
    return state(rig) == CTL_MASTER_STATE_ENGAGED;
}

// An encoder whose counts a test sets, and a master that reads them, without a machine.
struct Bench {
    std::int64_t counts = 0;
    std::uint16_t settings[CTL_GROUP_MASTER]{};
    ctl_board board{};
    ctl_master master{};
    ctl_ramp ramp{};
    Registers image;
    ctl_bank bank{};

    explicit Bench(std::uint32_t countsPerTurn, Registers registers = cutter().registers())
        : image(std::move(registers))
    {
        board.config = benchConfig();
        board.port.context = this;
        board.port.master = [](void* context, std::uint16_t, ctl_master_input* input) {
            *input = {static_cast<Bench*>(context)->counts, 0, 0, 0};
        };
        board.master = settings;
        settings[0] = CTL_MASTER_SOURCE_ENCODER;
        ctl_put32(&settings[CTL_REG_MASTER_COUNTS - CTL_REG_MASTER_SOURCE], countsPerTurn);
        ctl_put32(&settings[CTL_REG_MASTER_REVOLUTION - CTL_REG_MASTER_SOURCE], 250'000);
        settings[CTL_REG_MASTER_ENGAGE - CTL_REG_MASTER_SOURCE] = 50;
        settings[CTL_REG_MASTER_SPEED_MAX - CTL_REG_MASTER_SOURCE] = 150;
        settings[CTL_REG_MASTER_BACKWARD - CTL_REG_MASTER_SOURCE] = 1;
    }

    void engage()
    {
        std::ranges::copy(image, bank.registers);
        ctl_master_init(&master, &board);
        ctl_master_slice(&master);
        ctl_ramp_reset(&ramp, 6'400'000);
        ctl_master_engage(&master, &bank, 0, &ramp);
    }

    std::int32_t pass(std::int64_t by, std::uint32_t us = 10'000)
    {
        counts += by;
        board.now_us += us;
        ctl_master_slice(&master);
        return ctl_master_travel(&master, &ramp, us * 8);
    }

    void standStill()
    {
        for (int i = 0; i < 200; ++i)
            (void)pass(0);
    }
};

} // namespace campanel::test::master
