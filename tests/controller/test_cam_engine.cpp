// SPDX-License-Identifier: Apache-2.0
// The cam-point engine driven directly: the cubic, its smoothness, exact wraps in both directions, pulses on
// a straight line between updates, and refused banks.
#include "bank/ctl_check.h"
#include "engine/ctl_table.h"
#include "rig.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace test_cam_engine {

using namespace campanel::test;

namespace {

constexpr std::uint32_t updateTicks = 16'000; // 2 ms at 8 MHz
__extension__ typedef __int128 Wide;          // sums that must not be rounded
constexpr double turn = 2.0 * std::numbers::pi;

std::unique_ptr<ctl_bank> bankOf(const CamImage& image)
{
    auto bank = std::make_unique<ctl_bank>();
    std::ranges::copy(image.registers(), bank->registers);
    return bank;
}

// A master over a bank, at full speed, with regular updates.
struct Follower {
    explicit Follower(const ctl_bank& bank)
    {
        ctl_table_init(&table, &config);
        ctl_table_reset(&table, &bank);
    }
    // Passes this many ticks of the master and of time; returns the pulses.
    std::int64_t pass(std::uint32_t ticks, std::int32_t direction = 1)
    {
        std::int64_t pulses = 0;
        while (ticks != 0) {
            std::uint32_t part = std::min(ticks, ctl_table_longest_pass(&table));
            ticks -= part;
            for (std::uint32_t left = part; left != 0;) {
                if (ctl_table_between_cycles(&table))
                    ctl_table_begin_cycle(&table, direction);
                std::uint32_t used = left;
                pulses += ctl_table_advance(&table, direction, &used, nullptr);
                left -= used;
                if (ctl_table_between_cycles(&table))
                    cycles += direction;
            }
            pulses += ctl_table_pass(&table, part, nullptr);
        }
        return pulses;
    }
    ctl_config config = benchConfig();
    ctl_table table{};
    std::int64_t cycles = 0;
};

} // namespace

class TestCamEngine : public QObject {
    Q_OBJECT

private slots:
    void targetIsTheCubic();
    void velocityHasNoSawTooth_data();
    void velocityHasNoSawTooth();
    void noDriftInAMillionWraps_data();
    void noDriftInAMillionWraps();
    void reversalsComeBack();
    void pulsesLieOnTheLine();
    void holdIsExact();
    void checkRefuses_data();
    void checkRefuses();
};

// Against Hermite's basis in floating point.
void TestCamEngine::targetIsTheCubic()
{
    constexpr std::uint64_t seed = 21;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    double worst = 0.0;
    for (int table = 0; table < 100; ++table) {
        CamImage image;
        image.cycleTicks = 100'000 + static_cast<std::uint32_t>(random() % 4'000'000'000u);
        const unsigned intervals = 1 + static_cast<unsigned>(random() % 2000);
        // Half of the slope that 200 kHz allows, as position and as slope.
        const double most = std::min(0.5 * 256.0 * 200'000.0 * image.cycleTicks / 8e6 / intervals, 1e6);
        std::uniform_real_distribution<double> any(-most, most);
        std::int32_t position = 0;
        for (unsigned i = 0; i <= intervals; ++i) {
            image.rows.push_back({position, static_cast<std::int32_t>(any(random))});
            position += static_cast<std::int32_t>(any(random));
            position = std::clamp(position, -2'000'000'000, 2'000'000'000);
        }
        const auto bank = bankOf(image);
        ctl_cam cam{};
        const ctl_config config = benchConfig();
        ctl_cam_reset(&cam, bank.get(), &config);
        ctl_cam_begin_cycle(&cam, 1);
        for (int i = 0; i < 200; ++i) {
            cam.position = random() % (image.cycleTicks + 1ull);
            const double x = static_cast<double>(cam.position) * intervals / image.cycleTicks;
            const auto k = std::min(static_cast<std::size_t>(x), image.rows.size() - 2);
            const double u = x - static_cast<double>(k);
            const CamRow from = image.rows[k];
            const CamRow to = image.rows[k + 1];
            const double expected = from.position * (1 + 2 * u) * (1 - u) * (1 - u) +
                                    from.slope * u * (1 - u) * (1 - u) + to.position * u * u * (3 - 2 * u) +
                                    to.slope * u * u * (u - 1);
            worst = std::max(worst, std::abs(expected - static_cast<double>(ctl_cam_target(&cam))));
        }
    }
    qInfo("largest difference %.3f of 1/256 pulse", worst);
    QVERIFY(worst < 1.0);
}

void TestCamEngine::velocityHasNoSawTooth_data()
{
    QTest::addColumn<unsigned>("intervals");
    QTest::newRow("100 intervals") << 100u;
    QTest::newRow("1000 intervals") << 1000u;
}

// Compares the velocity between updates with that of the source curve. A step is a second difference of
// positions with an error of one unit each, so four units at most. Without shared slopes, or with a wrong
// advance at the wrap, larger steps would appear at the table's points.
void TestCamEngine::velocityHasNoSawTooth()
{
    QFETCH(unsigned, intervals);
    constexpr double maxHz = 4.0 / 256.0 * 500.0;
    constexpr double net = 10'000.0;
    constexpr double swing = 5'000.0;
    const std::uint32_t cycle = 8'000'123;
    const auto bank = bankOf(sineCam(net, swing, intervals, cycle));
    Follower follower(*bank);
    const auto curve = [&](double ticks) {
        return net * ticks / cycle + swing * std::sin(turn * ticks / cycle);
    };
    follower.pass(2 * updateTicks);
    double time = 2.0 * updateTicks;
    double worst = 0.0;
    double worstStep = 0.0;
    double lastError = 0.0;
    double worstFrom = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const double hz =
            static_cast<double>(follower.table.cam.line_to - follower.table.cam.line_from) / 256.0 * 500.0;
        const double smoothHz = (curve(time) - curve(time - updateTicks)) * 500.0;
        const double error = hz - smoothHz;
        if (std::abs(error) > worst) {
            worst = std::abs(error);
            worstFrom = smoothHz;
        }
        if (i > 0)
            worstStep = std::max(worstStep, std::abs(error - lastError));
        lastError = error;
        follower.pass(updateTicks);
        time += updateTicks;
    }
    qInfo("%u intervals: velocity at most %.2f Hz off (at %.0f Hz), largest step against the smooth curve "
          "%.2f Hz "
          "of %.0f Hz peak",
          intervals, worst, worstFrom, worstStep, net + swing * turn);
    QVERIFY(worst <= maxHz);
    QVERIFY(worstStep <= maxHz);
}

void TestCamEngine::noDriftInAMillionWraps_data()
{
    QTest::addColumn<double>("net");
    QTest::addColumn<unsigned>("remainder");
    QTest::addColumn<unsigned>("divisor");
    QTest::addColumn<int>("direction");
    QTest::newRow("closed") << 0.0 << 0u << 1u << 1;
    QTest::newRow("progressive") << 100.0 << 0u << 1u << 1;
    QTest::newRow("thirds") << 100.0 + 2.0 / 3.0 << 2u << 3u << 1;
    QTest::newRow("thirds, master backward") << 100.0 + 2.0 / 3.0 << 2u << 3u << -1;
    QTest::newRow("sevenths, axis backward") << -100.0 - 2.0 / 7.0 << 5u << 7u << 1;
    QTest::newRow("sevenths, both backward") << -100.0 - 2.0 / 7.0 << 5u << 7u << -1;
    QTest::newRow("large divisor") << 99.0 + 1e6 / 4294967291.0 << 1'000'000u << 4'294'967'291u << 1;
}

void TestCamEngine::noDriftInAMillionWraps()
{
    QFETCH(double, net);
    QFETCH(unsigned, remainder);
    QFETCH(unsigned, divisor);
    QFETCH(int, direction);
    constexpr std::int64_t wraps = 1'000'000;
    CamImage image = sineCam(net, 20.0, 10, 32'003); // 4 ms
    image.masterRate = 10'000;                       // its ratio gives the cycle to half a tick
    image.remainder = remainder;
    image.divisor = divisor;
    const auto bank = bankOf(image);
    const ctl_config config = benchConfig();
    QCOMPARE(ctl_bank_check(bank.get(), &config, ctl_bank_length(bank.get())).result,
             CTL_TRANSFER_RESULT_ACCEPTED);
    Follower follower(*bank);
    std::int64_t sent = 0;
    // No update moves farther than the steepest part of the curve allows.
    const double most = (std::abs(net) + 20.0 * turn) * updateTicks / image.cycleTicks + 2.0;
    std::int64_t largest = 0;
    while (follower.cycles * direction < wraps) {
        const std::int64_t pulses = follower.pass(updateTicks, direction);
        largest = std::max(largest, std::abs(pulses));
        sent += pulses;
    }
    QVERIFY2(static_cast<double>(largest) <= most, qPrintable(QString::number(largest)));
    // To the end of the cycle, in whole numbers of 1/256 pulse: floor(cycles * net * 256).
    while (!ctl_table_between_cycles(&follower.table)) {
        std::uint32_t rest = 1'000'000;
        ctl_table_advance(&follower.table, direction, &rest, nullptr);
        if (ctl_table_between_cycles(&follower.table))
            follower.cycles += direction;
    }
    const Wide numerator =
        static_cast<Wide>(follower.cycles) * 256 * (static_cast<Wide>(image.advance) * divisor + remainder);
    Wide exact = numerator / divisor;
    exact -= numerator % divisor < 0 ? 1 : 0;
    QCOMPARE(ctl_cam_target(&follower.table.cam), static_cast<std::int64_t>(exact));
    while (!ctl_table_settled(&follower.table))
        sent += ctl_table_pass(&follower.table, ctl_table_longest_pass(&follower.table), nullptr);
    QCOMPARE(sent, static_cast<std::int64_t>(std::floor((static_cast<double>(exact) + 128.0) / 256.0)));
}

// A master that reverses anywhere, also on the boundary, reaches every position again.
void TestCamEngine::reversalsComeBack()
{
    constexpr std::uint64_t seed = 22;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    CamImage image = sineCam(1000.0 + 1.0 / 3.0, 300.0, 50, 400'000);
    image.remainder = 1;
    image.divisor = 3;
    const auto bank = bankOf(image);
    Follower follower(*bank);
    std::int64_t time = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::int32_t direction = random() % 2 == 0 ? 1 : -1;
        std::uint32_t ticks = 1 + static_cast<std::uint32_t>(random() % 300'000);
        if (i % 5 == 0) // up to the next boundary exactly
            ticks =
                static_cast<std::uint32_t>(direction > 0 ? 400'000 - (time % 400'000 + 400'000) % 400'000
                                                         : ((time % 400'000 + 400'000 - 1) % 400'000) + 1);
        follower.pass(ticks, direction);
        time += direction * static_cast<std::int64_t>(ticks);
        const double x = static_cast<double>(time) / 400'000.0;
        const double exact = 256.0 * ((1000.0 + 1.0 / 3.0) * x + 300.0 * std::sin(turn * x));
        const double error = std::abs(static_cast<double>(ctl_cam_target(&follower.table.cam)) - exact);
        // The cubic through 50 points, and rounding.
        QVERIFY2(error < 3.0, qPrintable(QStringLiteral("%1 units off at %2").arg(error).arg(x)));
    }
}

// The pulses are those of the line between two updates, for any division of time.
void TestCamEngine::pulsesLieOnTheLine()
{
    constexpr std::uint64_t seed = 23;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    const auto bank = bankOf(sineCam(-3000.0, 2500.0, 100, 4'000'000));
    Follower whole(*bank);
    Follower cut(*bank);
    std::int64_t sent = 0;
    for (int update = 0; update < 3000; ++update) {
        const std::int64_t from = cut.table.cam.line_from;
        const std::int64_t to = cut.table.cam.line_to;
        for (std::uint32_t passed = 0; passed < updateTicks;) {
            const std::uint32_t part =
                std::min(updateTicks - passed, 1 + static_cast<std::uint32_t>(random() % 5000));
            passed += part;
            sent += cut.pass(part);
            const double line = static_cast<double>(from) +
                                static_cast<double>(to - from) * passed / static_cast<double>(updateTicks);
            QVERIFY(std::abs(static_cast<double>(sent) - line / 256.0) <= 0.5 + 1.0 / 256.0);
        }
        whole.pass(updateTicks);
        QCOMPARE(sent, whole.table.cam.sent);
        QCOMPARE(cut.table.cam.line_to, whole.table.cam.line_to);
    }
}

// The last slope continues without losing a fraction, for any division of time.
void TestCamEngine::holdIsExact()
{
    constexpr std::uint64_t seed = 24;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (const double hz : {12'345.0, -12'345.0}) {
        const CamImage image = speedMove(hz, 100, 4'000'000);
        const auto bank = bankOf(image);
        Follower follower(*bank);
        follower.pass(4'000'000);
        QVERIFY(ctl_table_holding(&follower.table));
        QVERIFY(!ctl_table_between_cycles(&follower.table));
        const std::int64_t begun = ctl_cam_target(&follower.table.cam);
        std::int64_t ticks = 0;
        for (int i = 0; i < 10'000; ++i) {
            const auto part =
                1 + static_cast<std::uint32_t>(random() % (i % 100 == 0 ? 100'000'000u : 5000u));
            std::uint32_t used = part;
            ctl_table_advance(&follower.table, 1, &used, nullptr);
            QCOMPARE(used, part);
            ticks += part;
            const Wide sum = static_cast<Wide>(image.rows.back().slope) * 100 * ticks;
            const auto exact = static_cast<std::int64_t>(sum / 4'000'000 - (sum % 4'000'000 < 0 ? 1 : 0));
            QCOMPARE(ctl_cam_target(&follower.table.cam) - begun, exact);
        }
    }
}

void TestCamEngine::checkRefuses_data()
{
    QTest::addColumn<int>("at");
    QTest::addColumn<unsigned>("value");
    QTest::addColumn<unsigned>("result");
    QTest::addColumn<unsigned>("detail");
    const unsigned header = CTL_TRANSFER_RESULT_BAD_HEADER;
    const unsigned row = CTL_TRANSFER_RESULT_BAD_ROW;
    const auto rowAt = [](int index, int word) {
        return static_cast<int>(CTL_OFFSET_BANK_ROWS) + 4 * index + word;
    };
    QTest::newRow("good") << int{CTL_OFFSET_CAM_MASTER_RAMP} << 65535u
                          << unsigned{CTL_TRANSFER_RESULT_ACCEPTED} << 0u;
    QTest::newRow("no such layout") << int{CTL_OFFSET_BANK_LAYOUT} << 99u << header << CTL_OFFSET_BANK_LAYOUT;
    QTest::newRow("another kind's layout")
        << int{CTL_OFFSET_BANK_KIND} << 1u << header << CTL_OFFSET_BANK_KIND;
    QTest::newRow("press as cam") << int{CTL_OFFSET_BANK_KIND} << 5u << header << CTL_OFFSET_BANK_KIND;
    QTest::newRow("no such kind") << int{CTL_OFFSET_BANK_KIND} << 77u << header << CTL_OFFSET_BANK_KIND;
    QTest::newRow("one row") << int{CTL_OFFSET_BANK_ROW_COUNT} << 1u << header << CTL_OFFSET_BANK_ROW_COUNT;
    QTest::newRow("too many rows") << int{CTL_OFFSET_BANK_ROW_COUNT} << 2002u << header
                                   << CTL_OFFSET_BANK_ROW_COUNT;
    QTest::newRow("knots missing") << int{CTL_OFFSET_CAM_KNOT_COUNT} << 4u << header
                                   << CTL_OFFSET_BANK_ROW_COUNT;
    QTest::newRow("shorter than an update")
        << int{CTL_OFFSET_BANK_CYCLE_TICKS} << 0u << header << CTL_OFFSET_BANK_CYCLE_TICKS;
    QTest::newRow("no divisor") << int{CTL_OFFSET_BANK_DIVISOR} + 1 << 0u << header
                                << CTL_OFFSET_BANK_DIVISOR;
    QTest::newRow("whole remainder") << int{CTL_OFFSET_BANK_REMAINDER} + 1 << 1u << header
                                     << CTL_OFFSET_BANK_REMAINDER;
    QTest::newRow("end behavior") << int{CTL_OFFSET_BANK_END_BEHAVIOR} << 3u << header
                                  << CTL_OFFSET_BANK_END_BEHAVIOR;
    QTest::newRow("ramp shape") << int{CTL_OFFSET_CAM_RAMP_SHAPE} << 2u << header
                                << CTL_OFFSET_CAM_RAMP_SHAPE;
    QTest::newRow("no pulses per revolution") << int{CTL_OFFSET_CAM_PULSES_PER_MOTOR_REV} + 1 << 0u << header
                                              << CTL_OFFSET_CAM_PULSES_PER_MOTOR_REV;
    QTest::newRow("first row not zero") << rowAt(0, 1) << 1u << row << 0u;
    QTest::newRow("steep row") << rowAt(7, 2) << 0x4000u << row << 7u;
    QTest::newRow("steep row downwards") << rowAt(7, 2) << 0xC000u << row << 7u;
    QTest::newRow("far row") << rowAt(7, 0) << 0x4000u << row << 7u;
    QTest::newRow("far row downwards") << rowAt(7, 0) << 0x8000u << row << 7u;
    QTest::newRow("other advance") << int{CTL_OFFSET_BANK_ADVANCE} + 1 << 999u
                                   << unsigned{CTL_TRANSFER_RESULT_BAD_SUM} << CTL_OFFSET_BANK_ADVANCE;
}

void TestCamEngine::checkRefuses()
{
    QFETCH(int, at);
    QFETCH(unsigned, value);
    QFETCH(unsigned, result);
    QFETCH(unsigned, detail);
    CamImage image = sineCam(1000.0, 100.0, 20, 80'000);
    image.knots = 5;
    Registers registers = image.registers();
    registers.at(static_cast<std::size_t>(at)) = static_cast<std::uint16_t>(value);
    auto bank = std::make_unique<ctl_bank>();
    std::ranges::copy(registers, bank->registers);
    const ctl_config config = benchConfig();
    const ctl_verdict verdict =
        ctl_bank_check(bank.get(), &config, static_cast<std::uint32_t>(registers.size()));
    QCOMPARE(verdict.result, result);
    QCOMPARE(verdict.detail, detail);
}

CAMPANEL_TEST(TestCamEngine)

} // namespace test_cam_engine

#include "test_cam_engine.moc"
