// SPDX-License-Identifier: Apache-2.0
// The step-table engine: the same motion pulse by pulse and in bulk; no drift, cycle time exact to the tick.
#include "bank/ctl_check.h"
#include "engine/ctl_ramp.h"
#include "engine/ctl_step.h"
#include "rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <memory>
#include <random>

namespace test_step_engine {

using namespace campanel::test;

namespace {

std::unique_ptr<ctl_bank> bankOf(const BankImage& image)
{
    auto bank = std::make_unique<ctl_bank>();
    const Registers registers = image.registers();
    std::ranges::copy(registers, bank->registers);
    return bank;
}

void beginIfNeeded(ctl_step& step)
{
    if (ctl_step_between_cycles(&step))
        ctl_step_begin_cycle(&step);
}

} // namespace

class TestStepEngine : public QObject {
    Q_OBJECT

private slots:
    void pulsesComeWhereTheDefinitionSays();
    void bulkEqualsPulseByPulse();
    void bothWaysMayAlternate();
    void noDriftInAMillionCycles_data();
    void noDriftInAMillionCycles();
    void cycleTimeIsExact();
    void changeOfBankKeepsWhatIsOwed();
    void rampIsExactHoweverItIsCut();
    void landingIsExact();
    void sCurveIsExactHoweverItIsCut();
    void sCurveLandsExactly();
};

// Pulse j of a row at floor(j * ticks / pulses), computed here in plain arithmetic.
void TestStepEngine::pulsesComeWhereTheDefinitionSays()
{
    constexpr std::uint64_t seed = 5;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (int table = 0; table < 200; ++table) {
        const BankImage image = randomBank(random);
        const auto bank = bankOf(image);
        const ctl_config config = benchConfig();
        QCOMPARE(ctl_bank_check(bank.get(), &config, ctl_bank_length(bank.get())).result,
                 CTL_TRANSFER_RESULT_ACCEPTED);
        ctl_step step{};
        ctl_step_reset(&step, bank.get());
        std::uint64_t owed = 0;
        for (int cycle = 0; cycle < 3; ++cycle) {
            owed += image.remainder;
            const bool carries = owed >= image.divisor;
            owed -= carries ? image.divisor : 0;
            std::vector<std::uint64_t> expected;
            std::uint64_t start = 0;
            for (std::size_t i = 0; i < image.rows.size(); ++i) {
                const std::uint64_t pulses =
                    image.rows[i].pulses + (carries && i == image.carryRow ? 1u : 0u);
                for (std::uint64_t j = 1; j <= pulses; ++j)
                    expected.push_back(start + j * image.rows[i].ticks / pulses);
                start += image.rows[i].ticks;
            }
            std::vector<std::uint64_t> actual;
            std::uint64_t now = 0;
            beginIfNeeded(step);
            while (!ctl_step_between_cycles(&step)) {
                const ctl_event event = ctl_step_next(&step);
                QVERIFY(event.ticks > 0);
                QVERIFY(!event.pulse || event.ticks >= 40);
                now += event.ticks;
                if (event.pulse)
                    actual.push_back(now);
            }
            QCOMPARE(now, std::uint64_t{image.cycleTicks()});
            QCOMPARE(actual, expected);
        }
    }
}

void TestStepEngine::bulkEqualsPulseByPulse()
{
    constexpr std::uint64_t seed = 6;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (int table = 0; table < 200; ++table) {
        const BankImage image = randomBank(random);
        const auto bank = bankOf(image);
        constexpr int cycles = 4;
        std::vector<std::uint64_t> pulseTimes;
        ctl_step single{};
        ctl_step_reset(&single, bank.get());
        std::uint64_t now = 0;
        for (int cycle = 0; cycle < cycles; ++cycle) {
            ctl_step_begin_cycle(&single);
            while (!ctl_step_between_cycles(&single)) {
                const ctl_event event = ctl_step_next(&single);
                now += event.ticks;
                if (event.pulse)
                    pulseTimes.push_back(now);
            }
        }
        ctl_step bulk{};
        ctl_step_reset(&bulk, bank.get());
        std::uint64_t passed = 0;
        std::uint64_t emitted = 0;
        while (passed < cycles * std::uint64_t{image.cycleTicks()}) {
            beginIfNeeded(bulk);
            std::uint32_t ticks =
                1 + static_cast<std::uint32_t>(random() % (random() % 2 == 0 ? 60u : 100'000u));
            emitted += ctl_step_advance(&bulk, &ticks, nullptr);
            passed += ticks;
            const auto due = std::ranges::upper_bound(pulseTimes, passed) - pulseTimes.begin();
            QCOMPARE(emitted, static_cast<std::uint64_t>(due));
        }
        QCOMPARE(emitted, pulseTimes.size());
    }
}

void TestStepEngine::bothWaysMayAlternate()
{
    constexpr std::uint64_t seed = 8;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (int table = 0; table < 100; ++table) {
        const BankImage image = randomBank(random);
        const auto bank = bankOf(image);
        ctl_step mixed{};
        ctl_step bulk{};
        ctl_step_reset(&mixed, bank.get());
        ctl_step_reset(&bulk, bank.get());
        std::uint64_t mixedPulses = 0;
        std::uint64_t bulkPulses = 0;
        beginIfNeeded(mixed);
        beginIfNeeded(bulk);
        while (!ctl_step_between_cycles(&mixed)) {
            std::uint32_t ticks = 1 + static_cast<std::uint32_t>(random() % 500u);
            if (random() % 2 == 0) {
                const ctl_event event = ctl_step_next(&mixed);
                ticks = event.ticks;
                mixedPulses += event.pulse ? 1 : 0;
            } else {
                mixedPulses += ctl_step_advance(&mixed, &ticks, nullptr);
            }
            if (ticks > 0)
                bulkPulses += ctl_step_advance(&bulk, &ticks, nullptr);
            QCOMPARE(mixedPulses, bulkPulses);
        }
        QVERIFY(ctl_step_between_cycles(&bulk));
    }
}

void TestStepEngine::noDriftInAMillionCycles_data()
{
    QTest::addColumn<unsigned>("pulsesPerRev");
    QTest::addColumn<unsigned>("knives");
    QTest::newRow("K = 10000") << 10000u << 1u;
    QTest::newRow("K = 10007, N = 3") << 10007u << 3u;
}

// The emitted pulses are counted; the shaft must have turned exactly cycles / knives revolutions.
void TestStepEngine::noDriftInAMillionCycles()
{
    QFETCH(unsigned, pulsesPerRev);
    QFETCH(unsigned, knives);
    constexpr std::uint64_t seed = 9;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    const BankImage image = camBank(pulsesPerRev, static_cast<std::uint16_t>(knives), 1'600'001);
    const auto bank = bankOf(image);
    ctl_step step{};
    ctl_step_reset(&step, bank.get());
    std::uint64_t emitted = 0;
    std::uint64_t ticksPassed = 0;
    std::uint64_t cycles = 0;
    while (cycles < 1'000'000) {
        beginIfNeeded(step);
        std::uint32_t ticks = 1'000 + static_cast<std::uint32_t>(random() % 3'000'000u);
        emitted += ctl_step_advance(&step, &ticks, nullptr);
        ticksPassed += ticks;
        if (!ctl_step_between_cycles(&step))
            continue;
        ++cycles;
        if (cycles % knives == 0 && emitted != cycles / knives * pulsesPerRev)
            QFAIL(qPrintable(QStringLiteral("%1 pulses after %2 cycles").arg(emitted).arg(cycles)));
    }
    QCOMPARE(emitted, cycles * pulsesPerRev / knives);
    QCOMPARE(ticksPassed, cycles * 1'600'001);
}

void TestStepEngine::cycleTimeIsExact()
{
    Rig rig;
    rig.install(camBank(10000, 1, 1'600'001)); // 0.200000125 s
    rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, 50);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_RUNNING));
    rig.run(1'000'000); // at full speed
    const auto ticks = [&rig] {
        const ctl_step& step = rig.core().motion.table.step;
        return rig.core().motion.cycle_count * std::int64_t{1'600'001} +
               (ctl_step_between_cycles(&step) ? 0 : static_cast<std::int64_t>(step.cycle_ticks));
    };
    const std::int64_t before = ticks();
    rig.run(100'000'000);
    QCOMPARE(ticks() - before, std::int64_t{800'000'000});
}

void TestStepEngine::changeOfBankKeepsWhatIsOwed()
{
    const BankImage thirds = camBank(10007, 3, 1'600'000); // 3335 and 2/3
    BankImage slower = camBank(10007, 3, 2'400'000);
    const auto one = bankOf(thirds);
    const auto other = bankOf(slower);
    ctl_step step{};
    ctl_step_reset(&step, one.get());
    std::uint64_t emitted = 0;
    for (std::uint64_t cycle = 1; cycle <= 3000; ++cycle) {
        ctl_step_change_bank(&step, cycle % 2 == 0 ? one.get() : other.get());
        ctl_step_begin_cycle(&step);
        std::uint32_t ticks = 10'000'000;
        emitted += ctl_step_advance(&step, &ticks, nullptr);
        QCOMPARE(emitted, cycle * 10007 / 3);
    }
}

void TestStepEngine::rampIsExactHoweverItIsCut()
{
    constexpr std::uint64_t seed = 10;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    constexpr std::uint32_t full = 6'400'000;
    ctl_ramp ramp{};
    ctl_ramp_reset(&ramp, full);
    std::uint64_t passed = 0;
    std::uint64_t travelled = 0;
    while (passed < 2u * full) {
        const auto ticks = static_cast<std::uint32_t>(1 + random() % 5000);
        travelled += ctl_ramp_up(&ramp, ticks);
        passed += ticks;
        // The area below the ramp: t^2 / 2R, then R/2 + (t - R).
        const std::uint64_t exact =
            passed <= full ? passed * passed / (2u * std::uint64_t{full}) : passed - full / 2u;
        QCOMPARE(travelled, exact);
    }
    QCOMPARE(ramp.speed, full);
    const std::uint64_t top = travelled;
    for (std::uint32_t left = full; left > 0;) {
        const std::uint32_t ticks = std::min(left, static_cast<std::uint32_t>(1 + random() % 5000));
        travelled += ctl_ramp_down(&ramp, ticks);
        left -= ticks;
    }
    QCOMPARE(ramp.speed, 0u);
    QCOMPARE(travelled - top, std::uint64_t{full / 2});
}

void TestStepEngine::landingIsExact()
{
    constexpr std::uint64_t seed = 11;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (int i = 0; i < 500; ++i) {
        ctl_ramp ramp{};
        ctl_ramp_reset(&ramp, 400'000 + static_cast<std::uint32_t>(random() % 8'000'000));
        ramp.speed = static_cast<std::uint32_t>(random() % (ramp.full + 1u));
        std::uint64_t remaining = 1 + random() % 8'000'000;
        while (!ctl_ramp_can_land(&ramp, remaining))
            remaining += 1'000'000;
        const std::uint64_t most = std::max(ramp.speed, ramp.full / 4);
        std::uint64_t slices = 0;
        while (remaining > 0) {
            const std::uint32_t before = ramp.speed;
            remaining -= ctl_ramp_land(&ramp, 2000, remaining, ramp.full / 4);
            QVERIFY(ramp.speed <= most);
            // Never more than twice the ramp, until a tick of the master is longer than the remaining
            // distance.
            QVERIFY(before <= ramp.speed + 4000 || before < ramp.full / 100);
            QVERIFY(++slices < 100'000);
        }
        QCOMPARE(ramp.speed, 0u);
    }
}

// Against the integral of the S-curve's share in floating point, up and down again.
void TestStepEngine::sCurveIsExactHoweverItIsCut()
{
    constexpr std::uint64_t seed = 14;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (const std::uint32_t full : {6'400'000u, 6'400'001u, 400'000u, 4'000'000'000u}) {
        const auto travel = [full](double speed) {
            const double x = speed / full;
            const double rest = 1.0 - x;
            return full * (x <= 0.5 ? 2.0 / 3.0 * x * x * x : x - 0.5 + 2.0 / 3.0 * rest * rest * rest);
        };
        ctl_ramp ramp{};
        ctl_ramp_reset_s(&ramp, full);
        std::uint64_t travelled = 0;
        while (ramp.speed < full) {
            const std::uint32_t share = ctl_ramp_share(&ramp, 1'000'000);
            travelled += ctl_ramp_up(
                &ramp, std::min(full - ramp.speed, 1 + static_cast<std::uint32_t>(random() % (full / 100))));
            QVERIFY(std::abs(static_cast<double>(travelled) - travel(ramp.speed)) <= 3.0);
            QVERIFY(ctl_ramp_share(&ramp, 1'000'000) >= share);
        }
        QCOMPARE(ctl_ramp_share(&ramp, 1'000'000), 1'000'000u);
        QCOMPARE(travelled, std::uint64_t{full - full / 2});
        QCOMPARE(ctl_ramp_up(&ramp, 12'345), 12'345u);
        while (ramp.speed > 0)
            travelled -= ctl_ramp_down(&ramp, 1 + static_cast<std::uint32_t>(random() % (full / 100)));
        QCOMPARE(travelled, std::uint64_t{0});
    }
}

void TestStepEngine::sCurveLandsExactly()
{
    constexpr std::uint64_t seed = 15;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (int i = 0; i < 500; ++i) {
        ctl_ramp ramp{};
        ctl_ramp_reset_s(&ramp, 400'000 + static_cast<std::uint32_t>(random() % 8'000'000));
        ramp.speed = static_cast<std::uint32_t>(random() % (ramp.full + 1u));
        std::uint64_t remaining = 1 + random() % 8'000'000;
        while (!ctl_ramp_can_land(&ramp, remaining))
            remaining += 1'000'000;
        const std::uint32_t most = std::max(ramp.speed, ramp.full / 4);
        std::uint64_t slices = 0;
        while (remaining > 0) {
            const std::uint32_t before = ramp.speed;
            const std::uint32_t travelled = ctl_ramp_land(&ramp, 2000, remaining, ramp.full / 4);
            QVERIFY(travelled <= remaining);
            remaining -= travelled;
            QVERIFY(ramp.speed <= most);
            // No more than the ramp, until a tick of the master is longer than the remaining distance.
            QVERIFY(before <= ramp.speed + 2000 || (remaining == 0 && before < ramp.full / 10));
            QVERIFY(++slices < 100'000);
        }
        QCOMPARE(ramp.speed, 0u);
    }
}

CAMPANEL_TEST(TestStepEngine)

} // namespace test_step_engine

#include "test_step_engine.moc"
