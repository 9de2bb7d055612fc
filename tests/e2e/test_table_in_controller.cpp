// SPDX-License-Identifier: Apache-2.0
// A recipe's table as executed by the controller: downloaded frame by frame, then 10^6 cycles of its engine.
// The counts are compared with K Z / N as an exact fraction, computed here. Tables of intervals pass the
// controller's check and its engine.
#include "app/program/program_change.h"
#include "app/program/program_image.h"
#include "base/ctl_words.h"
#include "engine/ctl_interval.h"
#include "motion/ctl_change.h"
#include "profile/cutter/limits.h"
#include "profile/intervals/intervals.h"
#include "profile/laws/laws.h"
#include "rig.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTest>
#include <QTextStream>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace test_table_in_controller {

using namespace campanel;
using test::Rig;

namespace {

constexpr std::int64_t manyCycles = 1'000'000;
constexpr std::int64_t clockHz = 8'000'000;

struct Case {
    int pulsesPerRev = 10000;
    int knives = 1;
    int gearNumerator = 1;
    int gearDenominator = 1;
    int slices = 20;
    double bagLengthMm = 250;
    double rateBagsPerMin = 60;
};

program::Recipe recipeOf(const Case& values)
{
    program::Recipe recipe;
    recipe.cutter().bagLengthMm = values.bagLengthMm;
    recipe.cutter().rateBagsPerMin = values.rateBagsPerMin;
    recipe.cutter().k = {4, 2.5, 1.6667, 1.3333};
    recipe.cutter().slicesPerRamp = values.slices;
    recipe.machine.knifeRadiusMm = 60;
    recipe.machine.knives = values.knives;
    recipe.machine.pulsesPerMotorRev = values.pulsesPerRev;
    recipe.machine.gearNumerator = values.gearNumerator;
    recipe.machine.gearDenominator = values.gearDenominator;
    return recipe;
}

// Returns the whole pulses of n cycles: floor(n K Z / N).
std::int64_t exactPulses(const Case& values, std::int64_t cycles)
{
    const std::int64_t numerator = std::int64_t{values.pulsesPerRev} * values.gearNumerator;
    return cycles * numerator / (std::int64_t{values.gearDenominator} * values.knives);
}

// Installs like the line: blocks, seal with the controller's own check, CRC-32, apply.
void install(Rig& rig, const program::ProgramImage& image)
{
    QCOMPARE(rig.download(image.registers), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(image.registers, CTL_APPLY_MODE_WHEN_STOPPED), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().banks.active_crc, image.crc);
    QCOMPARE(rig.core().banks.generation, 1u);
}

// Returns the bank as held by the controller.
std::unique_ptr<ctl_bank> bankOf(const profile::IntervalTable& table)
{
    auto bank = std::make_unique<ctl_bank>();
    std::uint16_t* header = bank->registers;
    header[CTL_OFFSET_BANK_LAYOUT] = CTL_TABLE_LAYOUT_INTERVALS;
    header[CTL_OFFSET_BANK_KIND] = CTL_PROGRAM_KIND_POSITION_MOVE;
    header[CTL_OFFSET_BANK_ROW_COUNT] = static_cast<std::uint16_t>(table.rows.size());
    header[CTL_OFFSET_BANK_END_BEHAVIOR] = CTL_END_BEHAVIOR_STOP;
    header[CTL_OFFSET_INTERVAL_FRACTION_BITS] = static_cast<std::uint16_t>(table.fractionBits);
    ctl_put32(&header[CTL_OFFSET_BANK_CYCLE_TICKS], table.cycleTicks);
    ctl_put32(&header[CTL_OFFSET_BANK_DIVISOR], 1);
    ctl_put32(&header[CTL_OFFSET_BANK_ADVANCE], static_cast<std::uint32_t>(table.advance));
    std::uint16_t* registers = &header[CTL_OFFSET_BANK_ROWS];
    for (const profile::IntervalRow& row : table.rows) {
        for (const std::uint32_t value : {row.pulses, row.firstSpeed, row.lastSpeed, row.acceleration}) {
            ctl_put32(registers, value);
            registers += 2;
        }
    }
    return bank;
}

} // namespace

std::unique_ptr<ctl_bank> bankOf(const program::ProgramImage& image)
{
    auto bank = std::make_unique<ctl_bank>();
    std::ranges::copy(image.registers, bank->registers);
    return bank;
}

// Returns a feasible recipe of this kind with random values.
program::ProgramImage randomProgram(profile::ProgramKind kind, std::mt19937_64& random)
{
    const auto pick = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    while (true) {
        program::Recipe recipe = program::defaultRecipe(kind);
        if (recipe.isCutter()) {
            recipe.cutter().bagLengthMm = pick(100, 460);
            recipe.cutter().rateBagsPerMin = pick(20, 380);
        } else {
            auto& cam = std::get<profile::PointCamProgram>(recipe.program);
            cam.ends = profile::SplineEnds::Natural; // the speed at its ends is not zero
            for (profile::Knot& knot : cam.knots)
                knot.slaveMm += pick(-5, 5);
            cam.knots.back().slaveMm = cam.knots.front().slaveMm + 20;
            cam.masterRateRevPerMin = pick(2, 60) * (random() % 2 == 0 ? 1 : -1);
            cam.masterRampS = pick(0.1, 3);
        }
        if (auto image = program::buildProgram(recipe))
            return *image;
    }
}

class TestTableInController : public QObject {
    Q_OBJECT

private slots:
    void changeIsPredicted_data();
    void changeIsPredicted();
    void changeWaitsForAProduct();
    void changesOfTheDocuments_data();
    void changesOfTheDocuments();
    void aMillionCyclesWithoutDrift_data();
    void aMillionCyclesWithoutDrift();
    void slicesDoNotChangeTheCycle_data();
    void slicesDoNotChangeTheCycle();
    void theShaftStandsWhereItShould_data();
    void theShaftStandsWhereItShould();
    void intervalsAreAccepted();
};

void TestTableInController::aMillionCyclesWithoutDrift_data()
{
    QTest::addColumn<Case>("values");
    QTest::newRow("K 10000") << Case{};
    QTest::newRow("K 10007, N 3") << Case{.pulsesPerRev = 10007, .knives = 3, .bagLengthMm = 83};
    QTest::newRow("gear 7/3") << Case{.gearNumerator = 7, .gearDenominator = 3};
    // 82.7 per minute is not a whole number of ticks: the value must be rounded once, not once per row.
    QTest::newRow("K 10007, N 3, gear 7/3, rate 82.7, 60 slices") << Case{10007, 3, 7, 3, 60, 83, 82.7};
}

void TestTableInController::aMillionCyclesWithoutDrift()
{
    QFETCH(Case, values);
    const auto image = program::buildProgram(recipeOf(values));
    QVERIFY2(image, image ? "" : program::describe(image.error()).c_str());
    Rig rig;
    install(rig, *image);

    const double cycleTicks = 60 / values.rateBagsPerMin * clockHz;
    ctl_step step{};
    ctl_step_reset(&step, ctl_active_bank(&rig.core().banks));
    std::int64_t pulses = 0;
    std::int64_t ticks = 0;
    for (std::int64_t cycle = 1; cycle <= manyCycles; ++cycle) {
        ctl_step_begin_cycle(&step);
        std::int64_t ticksOfCycle = 0;
        while (!ctl_step_between_cycles(&step)) {
            std::uint32_t advance = image->stepTable().cycleTicks;
            pulses += ctl_step_advance(&step, &advance, nullptr);
            ticksOfCycle += advance;
        }
        ticks += ticksOfCycle;
        if (pulses != exactPulses(values, cycle) ||
            std::abs(static_cast<double>(ticksOfCycle) - cycleTicks) >= 1)
            QFAIL(qPrintable(QStringLiteral("cycle %1: %2 pulses, %3 expected; %4 ticks, %5 expected")
                                 .arg(cycle)
                                 .arg(pulses)
                                 .arg(exactPulses(values, cycle))
                                 .arg(ticksOfCycle)
                                 .arg(cycleTicks)));
    }
    QCOMPARE(ticks, manyCycles * std::llround(cycleTicks));
}

void TestTableInController::slicesDoNotChangeTheCycle_data()
{
    QTest::addColumn<int>("slices");
    for (const int slices : {1, 2, 3, 20, 60, 127, 255})
        QTest::addRow("%d slices", slices) << slices;
}

// Each pulse as given by the timer's interrupt, one by one.
void TestTableInController::slicesDoNotChangeTheCycle()
{
    QFETCH(int, slices);
    const auto image = program::buildProgram(recipeOf({.slices = slices}));
    QVERIFY2(image, image ? "" : program::describe(image.error()).c_str());
    Rig rig;
    install(rig, *image);
    ctl_step step{};
    ctl_step_reset(&step, ctl_active_bank(&rig.core().banks));
    for (int cycle = 0; cycle < 3; ++cycle) {
        int pulses = 0;
        std::int64_t ticks = 0;
        ctl_step_begin_cycle(&step);
        while (!ctl_step_between_cycles(&step)) {
            const ctl_event event = ctl_step_next(&step);
            pulses += event.pulse ? 1 : 0;
            ticks += event.ticks;
        }
        QCOMPARE(pulses, 10000);
        QCOMPARE(ticks, clockHz);
    }
}

void TestTableInController::theShaftStandsWhereItShould_data()
{
    QTest::addColumn<Case>("values");
    QTest::newRow("K 10000") << Case{};
    QTest::newRow("K 10007, N 3") << Case{.pulsesPerRev = 10007, .knives = 3, .bagLengthMm = 83};
    QTest::newRow("gear 7/3, 127 slices") << Case{.gearNumerator = 7, .gearDenominator = 3, .slices = 127};
}

// The whole controller with its machine: homed, started, a hundred seconds of bags, stopped at a cycle's end.
// The sent pulses and the encoder of the shaft must both match the number of cycles.
void TestTableInController::theShaftStandsWhereItShould()
{
    QFETCH(Case, values);
    const auto image = program::buildProgram(recipeOf(values));
    QVERIFY2(image, image ? "" : program::describe(image.error()).c_str());
    Rig rig;
    install(rig, *image);
    rig.start();
    const std::int64_t cyclesBefore = rig.core().motion.cycle_count;
    rig.run(100'000'000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.run(2'000'000); // the axis follows with a lag
    const std::int64_t cycles = rig.core().motion.cycle_count - cyclesBefore;
    QVERIFY2(cycles > 95 && cycles < 105, qPrintable(QString::number(cycles)));
    QCOMPARE(rig.commanded(), exactPulses(values, cycles));
    QCOMPARE(rig.core().motion.actual - rig.core().motion.origin, exactPulses(values, cycles));
}

// Random moves between rest and speeds: the controller's own check accepts every compiled table, and its
// engine gives all pulses in the table's time.
void TestTableInController::intervalsAreAccepted()
{
    constexpr unsigned seed = 17;
    constexpr int cases = 400;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const auto uniform = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    ctl_config config = test::benchConfig();
    const profile::Machine machine;
    config.max_pulse_hz = static_cast<std::uint32_t>(machine.maxPulseFrequencyHz);
    int accepted = 0;
    for (int i = 0; i < cases; ++i) {
        const profile::Law& law = profile::laws()[random() % profile::laws().size()];
        const double durationS = std::exp(uniform(std::log(0.02), std::log(1)));
        const double mmPerS = (random() % 2 == 0 ? 1 : -1) * std::exp(uniform(std::log(2), std::log(800)));
        profile::MotionProfile motion;
        if (law.isDisplacementLaw && random() % 2 == 0)
            motion.addDisplacement(durationS, mmPerS * durationS, law, defaultParameters(law));
        else
            motion.addRamp(durationS, random() % 2 == 0 ? 0 : mmPerS / 3, mmPerS, law, defaultParameters(law),
                           false);
        const auto mode = static_cast<profile::IntervalMode>(random() % 2);
        const auto table = compileIntervals(motion, machine, uniform(0.01, 0.3) * std::abs(mmPerS), mode);
        if (!table)
            continue;
        ++accepted;
        const auto bank = bankOf(*table);
        const ctl_verdict verdict = ctl_interval_check(bank.get(), &config);
        QVERIFY2(verdict.result == CTL_TRANSFER_RESULT_ACCEPTED,
                 qPrintable(QStringLiteral("case %1, %2: result %3, row %4")
                                .arg(i)
                                .arg(QString::fromUtf8(law.key.data()))
                                .arg(verdict.result)
                                .arg(verdict.detail)));
        ctl_interval engine{};
        ctl_interval_reset(&engine, bank.get(), static_cast<std::uint32_t>(clockHz));
        ctl_interval_begin_cycle(&engine);
        std::uint32_t ticks = 2 * table->cycleTicks;
        QCOMPARE(ctl_interval_advance(&engine, &ticks, nullptr), static_cast<std::int32_t>(table->advance));
        QCOMPARE(ticks, table->cycleTicks);
    }
    qInfo("%d of %d compiled", accepted, cases);
    QVERIFY(accepted > cases / 2);
}

void TestTableInController::changeIsPredicted_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("cutter") << static_cast<int>(profile::ProgramKind::RotaryCutter);
    QTest::newRow("point cam") << static_cast<int>(profile::ProgramKind::PointCam);
}

// The panel's formula and the core's say the same share for a thousand pairs.
void TestTableInController::changeIsPredicted()
{
    QFETCH(int, kind);
    std::mt19937_64 random(7);
    Rig rig;
    std::vector<program::ProgramImage> programs;
    for (int i = 0; i < 46; ++i)
        programs.push_back(randomProgram(static_cast<profile::ProgramKind>(kind), random));
    install(rig, programs.front());
    rig.start();
    const ctl_board& board = rig.core().board;
    const program::ChangeParameters parameters{
        .knifeStepHz = ctl_parameter32(&board, CTL_REG_PARAMETER_KNIFE_STEP) * 1.0,
        .filmStepHz = ctl_parameter32(&board, CTL_REG_PARAMETER_FILM_STEP) * 1.0,
        .infeedStepHz = ctl_parameter32(&board, CTL_REG_PARAMETER_INFEED_STEP) * 1.0,
        .filmPulsesPerMm = 10'000.0 / 150.0,
        .flightPulses = 20'000.0,
        .rampS = 0.8};
    int slowing = 0;
    int pairs = 0;
    for (const program::ProgramImage& from : programs) {
        for (std::size_t i = 0; i < 22; ++i) {
            const program::ProgramImage& to = programs[i];
            const auto predicted =
                program::programChange(from.recipe, from.solved, to.recipe, to.solved, parameters);
            const ctl_change_plan plan =
                ctl_change_between(&board, &rig.core().packer, bankOf(from).get(), bankOf(to).get(),
                                   ctl_bank_direction(bankOf(from).get()));
            const double share = std::ldexp(static_cast<double>(plan.share), -31);
            QCOMPARE(predicted.has_value(), ctl_change_refusal(&plan) == CTL_REFUSAL_NONE);
            if (!predicted)
                continue;
            // The first row of a step table has its pulses rounded to whole ones.
            QVERIFY2(
                std::abs(predicted->shareBefore - share) < 0.02 * share + 0.001,
                qPrintable(
                    QStringLiteral("%1: %2, the core %3").arg(pairs).arg(predicted->shareBefore).arg(share)));
            slowing += share < 0.99 ? 1 : 0;
            ++pairs;
            // Behind an encoder only the steps count.
            const double steps = std::ldexp(static_cast<double>(plan.steps), -31);
            for (const double lineShare : {0.95 * steps, 1.05 * steps}) {
                program::ChangeParameters led = parameters;
                led.line = {.share = lineShare, .maxShare = 1e9};
                const auto way =
                    program::programChange(from.recipe, from.solved, to.recipe, to.solved, led)->way;
                QVERIFY(steps < 0.05 || steps > 10.0 ||
                        (way == program::ChangeWay::LeavesLine) == (lineShare > steps));
            }
        }
    }
    QVERIFY2(pairs > 1000 && slowing > 500, qPrintable(QStringLiteral("%1 of %2").arg(slowing).arg(pairs)));
}

// A product under the first cut keeps the change waiting for two cycles, as announced.
void TestTableInController::changeWaitsForAProduct()
{
    const auto programOf = [](double lengthMm, double rate) {
        program::Recipe recipe = recipeOf({.bagLengthMm = lengthMm});
        recipe.cutter().rateBagsPerMin = rate;
        return *program::buildProgram(recipe);
    };
    const program::ProgramImage from = programOf(250, 60);
    int waits = 0;
    for (const double lengthMm : {200.0, 270.0, 340.0, 400.0, 450.0}) {
        const program::ProgramImage to = programOf(lengthMm, 90);
        const auto timeS = [&](double missing) {
            controller::MachineOptions options;
            options.products.missing = missing;
            Rig rig(options);
            install(rig, from);
            rig.start();
            rig.run(10'000'000);
            const std::uint32_t generation = rig.core().banks.generation;
            const std::uint64_t beganUs = rig.controller().nowUs();
            rig.download(to.registers, 2);
            rig.apply(to.registers, CTL_APPLY_MODE_NEXT_CYCLE, 2);
            while (rig.core().banks.generation == generation)
                rig.controller().step();
            while (rig.core().motion.ramp.speed < rig.core().motion.ramp.full)
                rig.controller().step();
            return static_cast<double>(rig.controller().nowUs() - beganUs) / 1e6;
        };
        Rig rig;
        const ctl_board& board = rig.core().board;
        const program::ChangeParameters parameters{
            .knifeStepHz = ctl_parameter32(&board, CTL_REG_PARAMETER_KNIFE_STEP) * 1.0,
            .filmStepHz = ctl_parameter32(&board, CTL_REG_PARAMETER_FILM_STEP) * 1.0,
            .infeedStepHz = ctl_parameter32(&board, CTL_REG_PARAMETER_INFEED_STEP) * 1.0,
            .filmPulsesPerMm = 10'000.0 / 150.0,
            .flightPulses = 20'000.0,
            .rampS = 0.8,
            .hasAntiCut = true};
        const auto predicted =
            program::programChange(from.recipe, from.solved, to.recipe, to.solved, parameters);
        const double waitS = timeS(0.0) - timeS(1.0);
        const bool isWaiting = waitS > predicted->productWaitS / 2;
        waits += isWaiting ? 1 : 0;
        QVERIFY2(std::abs(waitS - (isWaiting ? predicted->productWaitS : 0.0)) < 0.05,
                 qPrintable(QStringLiteral("%1 mm: %2 s more, announced %3 s")
                                .arg(lengthMm)
                                .arg(waitS)
                                .arg(predicted->productWaitS)));
    }
    QVERIFY(waits > 0);
}

void TestTableInController::changesOfTheDocuments_data()
{
    QTest::addColumn<double>("fromMm");
    QTest::addColumn<double>("fromRate"); // 0: the fastest
    QTest::addColumn<double>("toMm");
    QTest::addColumn<double>("toRate");
    QTest::newRow("250-faster") << 250.0 << 60.0 << 250.0 << 120.0;
    QTest::newRow("250-to-460") << 250.0 << 0.0 << 460.0 << 0.0;
    QTest::newRow("460-to-100") << 460.0 << 0.0 << 100.0 << 0.0;
}

// The changes of docs/change-of-program.md: the speed of the film has no step. With CAMPANEL_SPEEDS the
// speeds are written into that folder, for docs/draw_changes.py.
void TestTableInController::changesOfTheDocuments()
{
    QFETCH(double, fromMm);
    QFETCH(double, fromRate);
    QFETCH(double, toMm);
    QFETCH(double, toRate);
    const auto programOf = [](double lengthMm, double rate) {
        program::Recipe recipe = recipeOf({.bagLengthMm = lengthMm});
        const auto slow = program::solveProgram(recipe);
        const double fastest = profile::fastestRate(*slow->cutter)->rateBagsPerMin;
        recipe.cutter().rateBagsPerMin = std::floor(rate > 0 ? rate : std::min(300.0, fastest));
        return *program::buildProgram(recipe);
    };
    const program::ProgramImage from = programOf(fromMm, fromRate);
    const program::ProgramImage to = programOf(toMm, toRate);
    controller::MachineOptions options;
    options.products.missing = 1.0; // their spacing on the film belongs to the bags before
    Rig rig(options);
    rig.setParameter(CTL_REG_PARAMETER_MARK_TRACKING, 0);
    install(rig, from);
    rig.start();
    rig.run(10'000'000);
    QCOMPARE(rig.download(to.registers, 2), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(to.registers, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);

    QFile file(QStringLiteral("%1/%2.csv")
                   .arg(qEnvironmentVariable("CAMPANEL_SPEEDS"), QLatin1String(QTest::currentDataTag())));
    QTextStream out(&file);
    if (qEnvironmentVariableIsSet("CAMPANEL_SPEEDS"))
        QVERIFY2(file.open(QIODevice::WriteOnly), qPrintable(file.errorString()));
    out << "time_s,film_mm_per_s,knife_mm_per_s\n";
    constexpr std::uint64_t periodUs = 2'000;
    constexpr double perS = 1e6 / periodUs;
    const double filmMm = 150.0 / 10'000 / CTL_FINE;
    const double knifeMm = 2 * M_PI * 60.0 / 10'000;
    std::int64_t film = ctl_feed_position(&rig.core().packer.film);
    std::int64_t knife = rig.core().motion.commanded;
    double before = 0.0;
    double largest = 0.0;
    for (int i = 1; i <= 2000; ++i) {
        rig.run(periodUs);
        const std::int64_t filmNow = ctl_feed_position(&rig.core().packer.film);
        const std::int64_t knifeNow = rig.core().motion.commanded;
        const double speed = static_cast<double>(filmNow - film) * filmMm * perS;
        if (i > 1)
            largest = std::max(largest, std::abs(speed - before));
        before = speed;
        out << i / perS << ',' << speed << ',' << static_cast<double>(knifeNow - knife) * knifeMm * perS
            << '\n';
        film = filmNow;
        knife = knifeNow;
    }
    QCOMPARE(rig.core().banks.generation, 2u);
    QCOMPARE(rig.core().motion.ramp.speed, rig.core().motion.ramp.full);
    // The ramp of 0.8 s alone changes 1500 mm/s by 3.8 mm/s in 2 ms.
    QVERIFY2(largest < 6.0, qPrintable(QString::number(largest)));
}

CAMPANEL_TEST(TestTableInController)

} // namespace test_table_in_controller

#include "test_table_in_controller.moc"
