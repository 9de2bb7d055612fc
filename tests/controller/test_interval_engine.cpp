// SPDX-License-Identifier: Apache-2.0
// The interval engine: the published pulse times of CamMov(10, 50, 800, 40000), the corrected total, the
// status bits of the double buffer, and equality with a simulation iteration by iteration.
#include "base/ctl_words.h"
#include "engine/ctl_interval.h"
#include "rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <memory>
#include <random>
#include <span>
#include <vector>

namespace test_interval_engine {

using namespace campanel::test;

namespace {

constexpr std::uint64_t iterationNs = 120; // 6 clocks of 50 MHz

const ctl_interval_row paperRow{10, 50, 800, 40000};
// Speeds times k = 2^23 / (50e6 / 6) = 1.00663296, the acceleration times k squared, 8 bits of fraction.
const ctl_interval_row correctedRow{10, 12885, 206158, 10376294};

// The flow chart of the paper, iteration by iteration.
struct PlainModel {
    unsigned fraction = 0;
    std::uint64_t now = 0;
    std::uint64_t positionRest = 0;

    std::vector<std::uint64_t> run(const ctl_interval_row& row)
    {
        std::vector<std::uint64_t> pulses;
        std::uint64_t velocity = row.first_speed;
        std::uint64_t velocityRest = 0;
        while (pulses.size() < row.distance) {
            ++now;
            velocityRest += row.acceleration;
            for (; velocityRest >= 1u << 23u; velocityRest -= 1u << 23u) {
                if (velocity < row.last_speed)
                    ++velocity;
                else if (velocity > row.last_speed)
                    --velocity;
            }
            positionRest += velocity;
            if (positionRest >= std::uint64_t{1} << (23u + fraction)) {
                positionRest -= std::uint64_t{1} << (23u + fraction);
                pulses.push_back(now);
            }
        }
        return pulses;
    }
};

ctl_dda standing(std::uint32_t fraction)
{
    ctl_dda dda{};
    ctl_dda_reset(&dda, fraction);
    return dda;
}

// Returns the iteration of every pulse, with single-iteration calls of the generator.
std::vector<std::uint64_t> singleSteps(ctl_dda& dda)
{
    std::vector<std::uint64_t> pulses;
    for (std::uint64_t now = 1; (ctl_dda_status(&dda) & CTL_DDA_FINISHED) == 0; ++now) {
        std::uint32_t one = 1;
        if (ctl_dda_iterate(&dda, &one) == 1)
            pulses.push_back(now);
    }
    return pulses;
}

// Returns a row short enough for a simulation iteration by iteration; the ramp's whole pulses fit.
ctl_interval_row randomRow(std::mt19937_64& random, unsigned fraction)
{
    const auto pick = [&random](std::uint64_t low, std::uint64_t high) {
        return static_cast<std::uint32_t>(low + random() % (high - low + 1));
    };
    ctl_interval_row row{};
    const std::uint32_t scale = 1u << fraction;
    row.first_speed = pick(2000 * scale, 500'000 * scale);
    row.last_speed = pick(2000 * scale, 500'000 * scale);
    const std::uint64_t squares = row.first_speed > row.last_speed
                                      ? std::uint64_t{row.first_speed} * row.first_speed -
                                            std::uint64_t{row.last_speed} * row.last_speed
                                      : std::uint64_t{row.last_speed} * row.last_speed -
                                            std::uint64_t{row.first_speed} * row.first_speed;
    const std::uint32_t ramp = pick(1, 30);
    const std::uint64_t acceleration = squares / (2u * std::uint64_t{scale} * ramp) + 1;
    row.acceleration = static_cast<std::uint32_t>(std::min<std::uint64_t>(acceleration, UINT32_MAX));
    const std::uint64_t travel = squares / (2u * std::uint64_t{scale} * row.acceleration) + 1;
    row.distance = static_cast<std::uint32_t>(travel) + pick(0, 10);
    return row;
}

std::unique_ptr<ctl_bank> bankOf(std::span<const ctl_interval_row> rows, std::uint16_t fraction,
                                 bool backwards = false)
{
    auto bank = std::make_unique<ctl_bank>();
    std::uint16_t* header = bank->registers;
    header[CTL_OFFSET_BANK_LAYOUT] = CTL_TABLE_LAYOUT_INTERVALS;
    header[CTL_OFFSET_BANK_KIND] = CTL_PROGRAM_KIND_POSITION_MOVE;
    header[CTL_OFFSET_BANK_ROW_COUNT] = static_cast<std::uint16_t>(rows.size());
    header[CTL_OFFSET_BANK_END_BEHAVIOR] = CTL_END_BEHAVIOR_STOP;
    header[CTL_OFFSET_INTERVAL_FRACTION_BITS] = fraction;
    ctl_put32(&header[CTL_OFFSET_BANK_CYCLE_TICKS], 1'000'000);
    ctl_put32(&header[CTL_OFFSET_BANK_DIVISOR], 1);
    std::uint32_t pulses = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::uint16_t* registers = &header[CTL_OFFSET_BANK_ROWS + CTL_INTERVAL_REGISTERS * i];
        ctl_put32(&registers[0], rows[i].distance);
        ctl_put32(&registers[2], rows[i].first_speed);
        ctl_put32(&registers[4], rows[i].last_speed);
        ctl_put32(&registers[6], rows[i].acceleration);
        pulses += rows[i].distance;
    }
    ctl_put32(&header[CTL_OFFSET_BANK_ADVANCE], backwards ? 0u - pulses : pulses);
    return bank;
}

ctl_config config()
{
    ctl_config result = benchConfig();
    result.max_pulse_hz = 500'000;
    return result;
}

} // namespace

class TestIntervalEngine : public QObject {
    Q_OBJECT

private slots:
    void publishedPulseTimes();
    void correctedTotal();
    void doubleBuffer();
    void equalsTheAccumulators();
    void countsAreExact();
    void clocksAreKeptExactly();
    void fractionOwed_data();
    void fractionOwed();
    void holdsTheLastSpeed();
    void check_data();
    void check();
};

// The times come from an independent model in another language; the tenth is the published 21.442 ms.
void TestIntervalEngine::publishedPulseTimes()
{
    const std::vector<std::uint64_t> expectedNs{5'980'440,  8'897'400,  11'145'720, 13'044'600, 14'719'200,
                                                16'234'080, 17'627'880, 18'925'440, 20'183'760, 21'442'080};
    ctl_dda dda = standing(0);
    QVERIFY(ctl_dda_write(&dda, paperRow));
    std::vector<std::uint64_t> timesNs;
    std::vector<std::uint64_t> reachedNs;
    for (std::uint64_t now = 1; timesNs.size() < 10; ++now) {
        std::uint32_t one = 1;
        if (ctl_dda_iterate(&dda, &one) == 1)
            timesNs.push_back(now * iterationNs);
        if (reachedNs.empty() && (ctl_dda_status(&dda) & CTL_DDA_V1_REACHED) != 0)
            reachedNs.push_back(now * iterationNs);
        QVERIFY(timesNs.size() < 11 && now < 1'000'000);
    }
    QCOMPARE(timesNs, expectedNs);
    // V1 is reached before the eighth pulse, so that eight intervals between pulses become shorter.
    QCOMPARE(reachedNs, std::vector<std::uint64_t>{18'874'440});
    QVERIFY(reachedNs[0] > timesNs[6] && reachedNs[0] <= timesNs[7]);
    for (std::size_t i = 1; i < 8; ++i)
        QVERIFY(timesNs[i] - timesNs[i - 1] < (i == 1 ? timesNs[0] : timesNs[i - 1] - timesNs[i - 2]));
    QCOMPARE(ctl_dda_status(&dda), std::uint32_t{CTL_DDA_FINISHED | CTL_DDA_WRITABLE | CTL_DDA_V1_REACHED});
}

// Theory: 7.96875 pulses in 18.75 ms, 2.03125 more at 800 pulses/s.
void TestIntervalEngine::correctedTotal()
{
    constexpr double theoryNs = 21'289'062.5;
    ctl_dda dda = standing(8);
    QVERIFY(ctl_dda_write(&dda, correctedRow));
    const std::vector<std::uint64_t> pulses = singleSteps(dda);
    QCOMPARE(pulses.size(), std::size_t{10});
    const double errorNs = static_cast<double>(pulses.back() * iterationNs) - theoryNs;
    qInfo("corrected total: %+.1f ns of theory", errorNs);
    QVERIFY(std::abs(errorNs) < 1000);
}

void TestIntervalEngine::doubleBuffer()
{
    ctl_dda dda = standing(0);
    QCOMPARE(ctl_dda_status(&dda), std::uint32_t{CTL_DDA_FINISHED | CTL_DDA_WRITABLE});
    const ctl_interval_row even{3, 800, 800, 0};
    const ctl_interval_row slower{2, 800, 400, 200'000};
    QVERIFY(ctl_dda_write(&dda, even));
    QCOMPARE(ctl_dda_status(&dda), std::uint32_t{CTL_DDA_WRITABLE | CTL_DDA_V1_REACHED});
    QVERIFY(ctl_dda_write(&dda, slower));
    QCOMPARE(ctl_dda_status(&dda), std::uint32_t{CTL_DDA_V1_REACHED});
    QVERIFY(!ctl_dda_write(&dda, even));
    std::uint32_t iterations = 1'000'000;
    QCOMPARE(ctl_dda_iterate(&dda, &iterations), 3u);
    QCOMPARE(iterations, (3u << 23u) / 800u + 1u);
    // Accepted with the last pulse of the first: writable again, the last speed not reached.
    QCOMPARE(ctl_dda_status(&dda), std::uint32_t{CTL_DDA_WRITABLE});
    iterations = 1'000'000;
    QCOMPARE(ctl_dda_iterate(&dda, &iterations), 2u);
    QCOMPARE(ctl_dda_status(&dda), std::uint32_t{CTL_DDA_FINISHED | CTL_DDA_WRITABLE | CTL_DDA_V1_REACHED});
    iterations = 100;
    QCOMPARE(ctl_dda_iterate(&dda, &iterations), 0u);
    QCOMPARE(iterations, 0u);
}

void TestIntervalEngine::equalsTheAccumulators()
{
    constexpr std::uint64_t seed = 21;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (int chain = 0; chain < 400; ++chain) {
        const unsigned fraction = chain % 2 == 0 ? 0u : static_cast<unsigned>(random() % 9u);
        PlainModel plain{fraction};
        ctl_dda dda = standing(fraction);
        std::vector<std::uint64_t> expected;
        std::vector<ctl_interval_row> rows;
        for (int i = 0; i < 3; ++i) {
            rows.push_back(randomRow(random, fraction));
            const auto pulses = plain.run(rows.back());
            expected.insert(expected.end(), pulses.begin(), pulses.end());
        }
        std::size_t next = 0;
        std::uint64_t now = 0;
        std::size_t emitted = 0;
        const std::uint32_t longest = random() % 2 == 0 ? 50u : 20'000u;
        while (next < rows.size() || (ctl_dda_status(&dda) & CTL_DDA_FINISHED) == 0) {
            while (next < rows.size() && ctl_dda_write(&dda, rows[next]))
                ++next;
            std::uint32_t iterations = 1 + static_cast<std::uint32_t>(random() % longest);
            emitted += ctl_dda_iterate(&dda, &iterations);
            now += iterations;
            QVERIFY(iterations > 0 && emitted <= expected.size());
            QVERIFY(emitted == 0 || expected[emitted - 1] <= now);
            QVERIFY(emitted == expected.size() || expected[emitted] > now);
        }
        QCOMPARE(emitted, expected.size());
        QCOMPARE(now, expected.back());
        QCOMPARE(std::uint64_t{dda.position_rest}, plain.positionRest);
    }
}

void TestIntervalEngine::countsAreExact()
{
    constexpr std::uint64_t seed = 22;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    constexpr std::size_t rowsPerBank = 100;
    const ctl_config board = config();
    for (int bankIndex = 0; bankIndex < 1000; ++bankIndex) {
        const unsigned fraction = random() % 2 == 0 ? 0u : 8u;
        const bool backwards = random() % 2 == 0;
        std::vector<ctl_interval_row> rows;
        std::int64_t expected = 0;
        for (std::size_t i = 0; i < rowsPerBank; ++i) {
            rows.push_back(randomRow(random, fraction));
            rows.back().distance += static_cast<std::uint32_t>(random() % 1'000'000u);
            expected += rows.back().distance;
        }
        const auto bank = bankOf(rows, static_cast<std::uint16_t>(fraction), backwards);
        QCOMPARE(ctl_interval_check(bank.get(), &board).result, CTL_TRANSFER_RESULT_ACCEPTED);
        ctl_interval interval{};
        ctl_interval_reset(&interval, bank.get(), 8'000'000);
        ctl_interval_begin_cycle(&interval);
        std::int64_t emitted = 0;
        while (!ctl_interval_between_cycles(&interval)) {
            std::uint32_t ticks = 1 + static_cast<std::uint32_t>(random() % 100'000'000u);
            emitted += ctl_interval_advance(&interval, &ticks, nullptr);
        }
        QCOMPARE(emitted, backwards ? -expected : expected);
    }
}

// 25 iterations are 24 ticks of 8 MHz: over many cycles the ticks used follow the iterations to one tick.
void TestIntervalEngine::clocksAreKeptExactly()
{
    constexpr std::uint64_t seed = 23;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    const std::vector rows{paperRow, ctl_interval_row{7, 800, 300, 60000}};
    PlainModel plain;
    std::vector<std::uint64_t> once = plain.run(rows[0]);
    const auto more = plain.run(rows[1]);
    once.insert(once.end(), more.begin(), more.end());
    const auto bank = bankOf(rows, 0);
    ctl_interval interval{};
    ctl_interval_reset(&interval, bank.get(), 8'000'000);
    std::uint64_t ticksPassed = 0;
    std::uint64_t emitted = 0;
    for (std::uint64_t cycle = 0; cycle < 1000; ++cycle) {
        ctl_interval_begin_cycle(&interval);
        while (!ctl_interval_between_cycles(&interval)) {
            std::uint32_t ticks = 1 + static_cast<std::uint32_t>(random() % 50'000u);
            emitted += static_cast<std::uint64_t>(ctl_interval_advance(&interval, &ticks, nullptr));
            ticksPassed += ticks;
            if (ctl_interval_between_cycles(&interval))
                break;
            const std::uint64_t iterations = ticksPassed * 25 / 24 - cycle * once.back();
            const auto due = std::ranges::upper_bound(once, iterations) - once.begin();
            QCOMPARE(emitted, cycle * once.size() + static_cast<std::uint64_t>(due));
        }
        // The tick of the last pulse.
        QCOMPARE(ticksPassed, ((cycle + 1) * once.back() * 24 + 24) / 25);
    }
}

void TestIntervalEngine::fractionOwed_data()
{
    QTest::addColumn<bool>("backwards");
    QTest::newRow("forward") << false;
    QTest::newRow("backward") << true;
}

// advance + 2/3 per cycle, in either direction.
void TestIntervalEngine::fractionOwed()
{
    QFETCH(bool, backwards);
    const std::vector rows{paperRow, ctl_interval_row{7, 800, 300, 60000}};
    const auto bank = bankOf(rows, 0, backwards);
    ctl_put32(&bank->registers[CTL_OFFSET_BANK_REMAINDER], 2);
    ctl_put32(&bank->registers[CTL_OFFSET_BANK_DIVISOR], 3);
    const ctl_config board = config();
    QCOMPARE(ctl_interval_check(bank.get(), &board).result, CTL_TRANSFER_RESULT_ACCEPTED);
    ctl_interval interval{};
    ctl_interval_reset(&interval, bank.get(), 8'000'000);
    std::int64_t emitted = 0;
    for (std::int64_t cycle = 1; cycle <= 3000; ++cycle) {
        ctl_interval_begin_cycle(&interval);
        std::uint32_t ticks = 100'000'000;
        emitted += ctl_interval_advance(&interval, &ticks, nullptr);
        QVERIFY(ctl_interval_between_cycles(&interval));
        QCOMPARE(emitted, cycle * (backwards ? -17 : 17) + cycle * 2 / 3);
    }
}

// After the ten pulses the accumulators continue at the last speed, without a gap.
void TestIntervalEngine::holdsTheLastSpeed()
{
    const auto bank = bankOf(std::vector{correctedRow}, 8, true);
    bank->registers[CTL_OFFSET_BANK_END_BEHAVIOR] = CTL_END_BEHAVIOR_HOLD_SPEED;
    ctl_interval interval{};
    ctl_interval_reset(&interval, bank.get(), 8'000'000);
    QCOMPARE(ctl_interval_hz(&interval), std::int64_t{0});
    ctl_interval_begin_cycle(&interval);
    QVERIFY(!ctl_interval_holding(&interval));
    std::int64_t emitted = 0;
    constexpr int seconds = 10'000;
    for (int second = 0; second < seconds; ++second) {
        std::uint32_t ticks = 8'000'000;
        emitted += ctl_interval_advance(&interval, &ticks, nullptr);
        QCOMPARE(ticks, 8'000'000u);
        QVERIFY(ctl_interval_holding(&interval));
    }
    QVERIFY(!ctl_interval_between_cycles(&interval));
    QCOMPARE(ctl_interval_hz(&interval), std::int64_t{-799}); // 799.9995, truncated
    PlainModel plain{8};
    (void)plain.run(correctedRow);
    const std::uint64_t rest = std::uint64_t{25'000'000} * seconds / 3 - plain.now;
    const std::uint64_t held = (plain.positionRest + rest * correctedRow.last_speed) >> 31u;
    QCOMPARE(emitted, -10 - static_cast<std::int64_t>(held));
}

void TestIntervalEngine::check_data()
{
    QTest::addColumn<unsigned>("offset"); // of the corrupted register, from the header or the row
    QTest::addColumn<bool>("inRow");
    QTest::addColumn<unsigned>("value");
    QTest::addColumn<unsigned>("result");
    const auto bad = [](const char* tag, unsigned offset, bool inRow, unsigned value, unsigned result) {
        QTest::newRow(tag) << offset << inRow << value << result;
    };
    bad("accepted", CTL_OFFSET_BANK_DIVISOR, false, 1, CTL_TRANSFER_RESULT_ACCEPTED);
    bad("no advance", CTL_OFFSET_BANK_ADVANCE, false, 0, CTL_TRANSFER_RESULT_BAD_HEADER);
    bad("no divisor", CTL_OFFSET_BANK_DIVISOR, false, 0, CTL_TRANSFER_RESULT_BAD_HEADER);
    bad("remainder", CTL_OFFSET_BANK_REMAINDER, false, 1, CTL_TRANSFER_RESULT_BAD_HEADER);
    bad("cycle too short", CTL_OFFSET_BANK_CYCLE_TICKS, false, 15'999, CTL_TRANSFER_RESULT_BAD_HEADER);
    bad("fraction bits", CTL_OFFSET_INTERVAL_FRACTION_BITS - 1, false, 9, CTL_TRANSFER_RESULT_BAD_HEADER);
    bad("sum", CTL_OFFSET_BANK_ADVANCE, false, 16, CTL_TRANSFER_RESULT_BAD_SUM);
    bad("wrong way", CTL_OFFSET_BANK_ADVANCE, false, 0u - 16u, CTL_TRANSFER_RESULT_BAD_SUM);
    bad("no distance", 0, true, 0, CTL_TRANSFER_RESULT_BAD_ROW);
    bad("distance too short", 0, true, 6, CTL_TRANSFER_RESULT_BAD_ROW);
    bad("no first speed", 2, true, 0, CTL_TRANSFER_RESULT_BAD_ROW);
    bad("no last speed", 4, true, 0, CTL_TRANSFER_RESULT_BAD_ROW);
    bad("too fast", 4, true, 503'318, CTL_TRANSFER_RESULT_BAD_ROW);
    bad("no acceleration", 6, true, 0, CTL_TRANSFER_RESULT_BAD_ROW);
    bad("acceleration too small", 6, true, 28'000, CTL_TRANSFER_RESULT_BAD_ROW);
}

void TestIntervalEngine::check()
{
    QFETCH(unsigned, offset);
    QFETCH(bool, inRow);
    QFETCH(unsigned, value);
    QFETCH(unsigned, result);
    const auto bank = bankOf(std::vector{ctl_interval_row{7, 800, 300, 60000}, paperRow}, 0);
    const ctl_config board = config();
    const unsigned base = inRow ? CTL_OFFSET_BANK_ROWS + CTL_INTERVAL_REGISTERS : 0;
    ctl_put32(&bank->registers[base + offset], value);
    const ctl_verdict verdict = ctl_interval_check(bank.get(), &board);
    QCOMPARE(unsigned{verdict.result}, result);
    if (result == CTL_TRANSFER_RESULT_BAD_ROW)
        QCOMPARE(unsigned{verdict.detail}, 1u);
}

CAMPANEL_TEST(TestIntervalEngine)

} // namespace test_interval_engine

#include "test_interval_engine.moc"
