// SPDX-License-Identifier: Apache-2.0
// The press: counted runs, the figures of the servo-press paper (100 strokes at each speed, two pulses
// there), and misplaced work pieces.
#include "bank/ctl_check.h"
#include "engine/ctl_count.h"
#include "press_bench.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace test_press_engine {

using namespace campanel::test;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t clockHz = 8'000'000;

// Returns the ticks of every pulse of a run, found tick by tick or in portions.
std::vector<std::uint64_t> pulseTicks(ctl_count run, std::uint32_t portion)
{
    std::vector<std::uint64_t> times;
    std::uint64_t now = 0;
    while (!ctl_count_done(&run)) {
        now += portion;
        times.insert(times.end(), ctl_count_advance(&run, portion, 1, nullptr), now);
    }
    return times;
}

} // namespace

class TestPressEngine : public QObject {
    Q_OBJECT

private slots:
    void countedRunIsExactHoweverItIsCut_data();
    void countedRunIsExactHoweverItIsCut();
    void brakeComesToStandOnTheRamp();
    void stopErrorOfThePaper_data();
    void stopErrorOfThePaper();
    void stopDoesNotDependOnTheController();
    void transmissionIsCompensated();
    void sameSeedSameStrokes();
    void wrongWorkPiece_data();
    void wrongWorkPiece();
    void windowDecides_data();
    void windowDecides();
    void badBanksAreRefused_data();
    void badBanksAreRefused();
};

void TestPressEngine::countedRunIsExactHoweverItIsCut_data()
{
    QTest::addColumn<std::uint32_t>("hz");
    QTest::addColumn<std::uint32_t>("rampMs");
    QTest::addColumn<std::uint32_t>("pulses");
    QTest::newRow("one pulse") << 1000u << 5u << 1u;
    QTest::newRow("three, never at speed") << 8000u << 50u << 3u;
    QTest::newRow("even, never at speed") << 8000u << 50u << 100u;
    QTest::newRow("ramp shorter than a pulse") << 200u << 1u << 40u;
    QTest::newRow("ramp of nearly a pulse") << 999u << 2u << 7u;
    QTest::newRow("press at 10 mm/s") << 1000u << 5u << 2400u;
    QTest::newRow("press at 100 mm/s") << 10'000u << 20u << 2400u;
    QTest::newRow("fastest") << 200'000u << 100u << 30'000u;
}

void TestPressEngine::countedRunIsExactHoweverItIsCut()
{
    QFETCH(std::uint32_t, hz);
    QFETCH(std::uint32_t, rampMs);
    QFETCH(std::uint32_t, pulses);
    ctl_count run{};
    ctl_count_start(&run, {clockHz, hz, rampMs}, pulses);
    const std::vector<std::uint64_t> times = pulseTicks(run, 1);
    QCOMPARE(times.size(), std::size_t{pulses});

    // Uniform acceleration, computed here in floating point: s = a t^2 / 2 up to f, then constant speed, then
    // mirrored.
    const double period = double{clockHz} / hz;
    const double square = 2.0 * rampMs / 1000.0 * clockHz * period;
    const auto rising = std::min<std::uint32_t>(
        static_cast<std::uint32_t>(std::floor(hz * (rampMs / 1000.0) / 2.0)), pulses / 2);
    for (std::uint32_t n = 1; n <= rising; ++n)
        QVERIFY(std::abs(static_cast<double>(times[n - 1]) - std::sqrt(n * square)) <= 1.0);
    std::uint64_t before = 0;
    for (const std::uint64_t time : times) {
        QVERIFY(static_cast<double>(time - before) >= period - 2.0);
        before = time;
    }
    for (std::uint32_t n = 1; n < rising; ++n) {
        const double mirrored = static_cast<double>(times.back() - times[pulses - n - 1]);
        QVERIFY(std::abs(mirrored - std::sqrt(n * square)) <= 1.0);
    }

    for (const std::uint32_t portion : {7u, 400u, 2000u, 123'457u}) {
        const std::vector<std::uint64_t> coarse = pulseTicks(run, portion);
        QCOMPARE(coarse.size(), times.size());
        for (std::size_t i = 0; i < times.size(); ++i)
            QCOMPARE(coarse[i], (times[i] + portion - 1) / portion * portion);
    }
}

void TestPressEngine::brakeComesToStandOnTheRamp()
{
    ctl_count whole{};
    ctl_count_start(&whole, {clockHz, 8000, 50}, 1000); // 200 pulses on each ramp
    for (std::uint32_t sent = 0; sent <= 1000; sent += 20) {
        ctl_count run = whole;
        std::uint32_t out = 0;
        while (out < sent)
            out += ctl_count_advance(&run, 1, 1, nullptr);
        ctl_count_brake(&run);
        out += static_cast<std::uint32_t>(pulseTicks(run, 100).size());
        const std::uint32_t expected = sent <= 200 ? 2 * sent : std::min(sent + 200, 1000u);
        QCOMPARE(out, expected);
    }
    ctl_count run = whole;
    ctl_count_advance(&run, 1'000'000, 1, nullptr);
    ctl_count_halt(&run);
    QVERIFY(ctl_count_done(&run));
    QCOMPARE(ctl_count_advance(&run, 10'000'000, 1, nullptr), 0u);
}

void TestPressEngine::stopErrorOfThePaper_data()
{
    QTest::addColumn<std::uint32_t>("hz");
    QTest::newRow("5 mm/s") << 500u;
    QTest::newRow("10 mm/s") << 1000u;
    QTest::newRow("15 mm/s") << 1500u;
    QTest::newRow("20 mm/s") << 2000u;
    QTest::newRow("100 mm/s") << 10'000u;
}

// 100 mm of travel, 0.01 mm per pulse, a scale of 5 um; the controller is called every 50 us to 20 ms at
// random while status blocks are read.
void TestPressEngine::stopErrorOfThePaper()
{
    QFETCH(std::uint32_t, hz);
    PressImage image;
    image.rows[CTL_PRESS_APPROACH].end = 7200;
    image.rows[CTL_PRESS_PRESS].hz = hz;
    image.rows[CTL_PRESS_PRESS].ms = 20;
    MachineOptions options;
    options.seed = 31;
    options.press.workPieceScatterMm = 0.5;
    PressBench bench(image, options, {.seed = hz, .longestTickUs = 20'000, .traffic = true});
    constexpr int strokes = 100;
    std::int64_t worst = 0;
    double worstTrueMm = 0.0;
    int exact = 0;
    for (int i = 0; i < strokes; ++i) {
        QVERIFY(bench.stroke());
        QCOMPARE(bench.core().motion.state, CTL_STATE_READY);
        QCOMPARE(bench.last().result, CTL_STROKE_RESULT_OK);
        QCOMPARE(bench.backwards, 0);
        worst = std::max(worst, std::abs(bench.last().error));
        worstTrueMm = std::max(worstTrueMm, std::abs(bench.heldMm - 100.0));
        exact += bench.last().error == 0 ? 1 : 0;
    }
    qInfo("seeds 31, %u: %d strokes, largest stop error %d pulses (%d exact), truly %.4f mm; %u answers", hz,
          strokes, static_cast<int>(worst), exact, worstTrueMm, bench.answers);
    QVERIFY(bench.answers > 1000);
    QVERIFY(worst <= 1);
    QVERIFY(worstTrueMm <= 0.012);
    QCOMPARE(bench.core().motion.cycle_count, std::uint32_t{strokes});
}

// The same machine with a prompt and with a late, busy controller: the stop differs by at most the scale's
// rounding at the contact.
void TestPressEngine::stopDoesNotDependOnTheController()
{
    MachineOptions options;
    options.press.workPieceScatterMm = 0.0;
    std::vector<double> heldMm;
    for (const std::uint32_t longestUs : {50u, 250u, 1000u, 5000u, 20'000u, 100'000u}) {
        PressBench bench(PressImage{}, options, {.seed = 3, .longestTickUs = longestUs, .traffic = true});
        QVERIFY(bench.stroke());
        QCOMPARE(bench.last().result, CTL_STROKE_RESULT_OK);
        QVERIFY(std::abs(bench.last().error) <= 1);
        heldMm.push_back(bench.heldMm);
    }
    const auto [least, most] = std::ranges::minmax(heldMm);
    qInfo("calls after at most 0.05 to 100 ms: stops within %.4f mm of one another", most - least);
    QVERIFY(most - least <= 0.012);
}

// Twenty times the backlash and twenty times the error of the screw's lead: compensated by the measurement up
// to C.
void TestPressEngine::transmissionIsCompensated()
{
    MachineOptions options;
    options.press.backlashMm = 0.6;
    options.press.leadError = -0.004;
    options.press.screwErrorMm = 0.0;
    PressBench bench(PressImage{}, options);
    QVERIFY(bench.stroke());
    const double countedMm = 24.0; // from C, 1 mm into the work piece at 75 mm, to D
    QCOMPARE(bench.core().motion.state, CTL_STATE_READY);
    const double errorMm = bench.heldMm - 100.0;
    QVERIFY2(std::abs(errorMm + 0.004 * countedMm) <= 0.015, qPrintable(QString::number(errorMm)));
    QCOMPARE(bench.last().result, CTL_STROKE_RESULT_POSITION_OUTSIDE);
}

// The seed determines scatter, heat and missing work pieces.
void TestPressEngine::sameSeedSameStrokes()
{
    const auto strokes = [](std::uint64_t seed) {
        MachineOptions options;
        options.seed = seed;
        options.press.missing = 0.3;
        PressBench bench(PressImage{}, options);
        std::vector<std::pair<int, int>> results;
        for (int i = 0; i < 30; ++i) {
            if (!bench.stroke())
                throw std::runtime_error("refused");
            results.emplace_back(bench.last().result, bench.last().force);
            while (bench.core().motion.actual_hz != 0)
                bench.tick();
            (void)ctl_motion_reset_fault(&bench.core().motion);
        }
        return results;
    };
    const auto once = strokes(5);
    QCOMPARE(strokes(5), once);
    QVERIFY(strokes(6) != once);
    const auto missed =
        std::ranges::count(once, int{CTL_STROKE_RESULT_NEVER_TOUCHED}, &std::pair<int, int>::first);
    const auto pressed = std::ranges::count(once, int{CTL_STROKE_RESULT_OK}, &std::pair<int, int>::first);
    qInfo("seed 5: %d of 30 missed", static_cast<int>(missed));
    QCOMPARE(missed + pressed, 30);
    QVERIFY(missed >= 3 && missed <= 16);
}

void TestPressEngine::wrongWorkPiece_data()
{
    QTest::addColumn<double>("pieceMm");
    QTest::addColumn<double>("missing");
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<int>("result");
    QTest::addColumn<int>("faultBit");
    QTest::addColumn<double>("deepestMm");
    QTest::newRow("none there") << 75.0 << 1.0 << 200.0 << int{CTL_STROKE_RESULT_NEVER_TOUCHED}
                                << int{CTL_FAULT_BIT_NEVER_TOUCHED} << 90.02;
    QTest::newRow("too deep") << 95.0 << 0.0 << 200.0 << int{CTL_STROKE_RESULT_NEVER_TOUCHED}
                              << int{CTL_FAULT_BIT_NEVER_TOUCHED} << 90.02;
    // 200 N after 1 mm at 80 mm/s; the servo then overruns by 2 / (2 pi 80 Hz) * 80 mm/s = 0.32 mm.
    QTest::newRow("too high") << 40.0 << 0.0 << 200.0 << int{CTL_STROKE_RESULT_TOUCHED_TOO_EARLY}
                              << int{CTL_FAULT_BIT_TOUCHED_TOO_EARLY} << 41.4;
    // 8000 N after 16 mm.
    QTest::newRow("too stiff") << 75.0 << 0.0 << 500.0 << int{CTL_STROKE_RESULT_FORCE_LIMIT}
                               << int{CTL_FAULT_BIT_FORCE_LIMIT} << 91.1;
    // Contact and, before standstill, above the limit.
    QTest::newRow("too high and too stiff")
        << 40.0 << 0.0 << 1e6 << int{CTL_STROKE_RESULT_FORCE_LIMIT} << int{CTL_FAULT_BIT_FORCE_LIMIT} << 40.4;
}

// Stops at once, goes up again, and only then enters the fault state; after a reset the next stroke runs.
void TestPressEngine::wrongWorkPiece()
{
    QFETCH(double, pieceMm);
    QFETCH(double, missing);
    QFETCH(double, stiffness);
    QFETCH(int, result);
    QFETCH(int, faultBit);
    QFETCH(double, deepestMm);
    MachineOptions options;
    options.press.workPieceMm = pieceMm;
    options.press.workPieceScatterMm = 0.0;
    options.press.missing = missing;
    options.press.stiffnessNPerMm = stiffness;
    PressBench bench(PressImage{}, options);
    QCOMPARE(ctl_start(&bench.core().motion, &bench.core().io), CTL_REFUSAL_NONE);
    double deepest = 0.0;
    while (!ctl_motion_standstill(&bench.core().motion)) {
        bench.tick();
        deepest = std::max(deepest, bench.machine().ram().positionMm());
        QVERIFY(bench.nowUs() < 60'000'000);
    }
    QVERIFY2(deepest <= deepestMm, qPrintable(QString::number(deepest)));
    QCOMPARE(bench.backwards, 0);
    QCOMPARE(int{bench.last().result}, result);
    QCOMPARE(bench.last().error, 0);
    QCOMPARE(bench.core().motion.state, CTL_STATE_FAULT);
    QCOMPARE(int{bench.core().motion.fault}, 1 << faultBit);
    QVERIFY(std::abs(bench.machine().ram().positionMm()) <= 0.015);
    QCOMPARE(bench.core().motion.cycle_count, 1u);
    QVERIFY(!bench.stroke());
    while (bench.core().motion.actual_hz != 0)
        bench.tick();
    QCOMPARE(ctl_motion_reset_fault(&bench.core().motion), CTL_REFUSAL_NONE);
    QVERIFY(bench.stroke());
    QCOMPARE(int{bench.last().result}, result);
}

void TestPressEngine::windowDecides_data()
{
    QTest::addColumn<int>("stiffness");
    QTest::addColumn<int>("result");
    QTest::newRow("in order") << 200 << int{CTL_STROKE_RESULT_OK};
    QTest::newRow("too soft") << 39 << int{CTL_STROKE_RESULT_FORCE_TOO_LOW};
    QTest::newRow("too hard") << 245 << int{CTL_STROKE_RESULT_FORCE_TOO_HIGH};
}

void TestPressEngine::windowDecides()
{
    QFETCH(int, stiffness);
    QFETCH(int, result);
    MachineOptions options;
    options.press.workPieceScatterMm = 0.0;
    options.press.stiffnessNPerMm = stiffness;
    PressBench bench(PressImage{}, options);
    QVERIFY(bench.stroke());
    QCOMPARE(int{bench.last().result}, result);
    // 25 mm deep in a spring.
    QVERIFY(std::abs(bench.last().force - 25 * stiffness) <= stiffness * 0.02);
    QVERIFY(bench.last().peak >= bench.last().force);
    QCOMPARE(bench.core().motion.state, CTL_STATE_READY);
}

void TestPressEngine::badBanksAreRefused_data()
{
    QTest::addColumn<int>("offset");
    QTest::addColumn<std::uint16_t>("value");
    QTest::addColumn<int>("result");
    QTest::addColumn<int>("detail");
    const auto row = [](int index, int word) {
        return static_cast<int>(CTL_OFFSET_BANK_ROWS + CTL_STAGE_REGISTERS * unsigned(index)) + word;
    };
    const auto header = [](const char* name, int offset, std::uint16_t value) {
        QTest::newRow(name) << offset << value << int{CTL_TRANSFER_RESULT_BAD_HEADER} << offset;
    };
    header("no layout", CTL_OFFSET_BANK_LAYOUT, CTL_TABLE_LAYOUT_NONE);
    header("another kind", CTL_OFFSET_BANK_KIND, CTL_PROGRAM_KIND_ROTARY_CUTTER);
    header("four rows", CTL_OFFSET_BANK_ROW_COUNT, 4);
    header("force window upside down", CTL_OFFSET_PRESS_MIN_STOP_FORCE, 6001);
    header("no pulses per revolution", CTL_OFFSET_PRESS_PULSES_PER_MOTOR_REV, 0xFFFF);
    const auto bad = [&row](const char* name, int index, int word, std::uint16_t value) {
        QTest::newRow(name) << row(index, word) << value << int{CTL_TRANSFER_RESULT_BAD_ROW} << index;
    };
    bad("no speed", CTL_PRESS_APPROACH, 1, 0);
    bad("above the output stage", CTL_PRESS_RETURN, 0, 4);
    bad("ramp too long", CTL_PRESS_PRESS, 7, 1001);
    bad("too far", CTL_PRESS_PRESS, 2, 0x4000);
    bad("approach above the top", CTL_PRESS_APPROACH, 2, 0xFFFF);
    bad("nothing to feel", CTL_PRESS_PROBE, 5, 0);
    bad("probe ends before it begins", CTL_PRESS_PROBE, 3, 6000);
    bad("press ends before the probe", CTL_PRESS_PRESS, 3, 8999);
    bad("felt only at the limit", CTL_PRESS_PRESS, 5, 200);
}

void TestPressEngine::badBanksAreRefused()
{
    QFETCH(int, offset);
    QFETCH(std::uint16_t, value);
    QFETCH(int, result);
    QFETCH(int, detail);
    Registers registers = PressImage{}.registers();
    registers.at(static_cast<std::size_t>(offset)) = value;
    auto bank = std::make_unique<ctl_bank>();
    std::ranges::copy(registers, bank->registers);
    const ctl_config config = benchConfig();
    const ctl_verdict verdict =
        ctl_bank_check(bank.get(), &config, static_cast<std::uint32_t>(registers.size()));
    QCOMPARE(int{verdict.result}, result);
    QCOMPARE(int{verdict.detail}, detail);
}

CAMPANEL_TEST(TestPressEngine)

} // namespace test_press_engine

#include "test_press_engine.moc"
