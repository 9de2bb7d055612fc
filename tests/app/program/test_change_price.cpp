// SPDX-License-Identifier: Apache-2.0
// The announced price of a change of program against the controller's core on its simulated machine: scrap
// bags, skipped cuts, the longest bag and the time until a bag counts, for marks anywhere on the new film.
#include "app/program/change_price.h"
#include "app/program/program_image.h"
#include "base/ctl_words.h"
#include "controller/rig.h"
#include "modbus/map/register_map.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace test_change_price {

using namespace campanel;

namespace {

constexpr double productMm = 100;
constexpr std::uint64_t second = 1'000'000;

double defaultOf(const char* name)
{
    return modbus::findRegister(name)->defaultValue;
}

program::ProgramImage imageOf(double bagMm, double bagsPerMin)
{
    program::Recipe recipe = program::defaultRecipe(profile::ProgramKind::RotaryCutter);
    recipe.cutter().bagLengthMm = bagMm;
    recipe.cutter().rateBagsPerMin = bagsPerMin;
    return program::buildProgram(recipe).value();
}

program::ChangeParameters changeParameters()
{
    return {.knifeStepHz = defaultOf("parameter.knife_step"),
            .filmStepHz = defaultOf("parameter.film_step"),
            .infeedStepHz = defaultOf("parameter.infeed_step"),
            .filmPulsesPerMm = defaultOf("parameter.film_pulses") / defaultOf("parameter.film_feed"),
            .flightPulses = defaultOf("parameter.flight_pulses"),
            .rampS = defaultOf("parameter.ramp_time") / 1000,
            .hasAntiCut = true};
}

program::PriceParameters priceParameters(bool tracks)
{
    return {.tracksMarks = tracks,
            .phaseLimitMm = defaultOf("parameter.phase_limit"),
            .productMm = productMm,
            .clearanceMm = defaultOf("parameter.cut_clearance"),
            .layDistanceMm = defaultOf("parameter.product_distance"),
            .hasAntiCut = true};
}

struct Actual {
    bool isDone = false;
    int scrap = 0;
    int skipped = 0;
    double longestMm = 0;
    double seconds = 0;
};

// Runs one program until its bags count, changes to the other, and returns what happens until a bag of it
// counts; by the clock, or behind a line of this speed.
Actual change(const program::ProgramImage& from, const program::ProgramImage& to, bool tracks,
              double lineMmPerS, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(-0.5, 0.5);
    controller::MachineOptions options;
    options.seed = seed;
    options.products.lengthMm = productMm;
    options.film.misplacedMm = share(random) * to.cutter().cycle.bagLengthMm;
    if (lineMmPerS > 0)
        options.shaft = {.counts = 10'000, .speedMmPerS = lineMmPerS};
    const auto rig = std::make_unique<test::Rig>(options);
    rig->setParameter(CTL_REG_PARAMETER_MARK_TRACKING, tracks ? 1 : 0);
    rig->setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 50);
    rig->install(from.registers);
    if (lineMmPerS > 0)
        rig->setParameter(CTL_REG_MASTER_SOURCE, CTL_MASTER_SOURCE_ENCODER);
    rig->run(second);
    rig->start();
    const ctl_packer& packer = rig->core().packer;
    const auto flags = [&] {
        return packer.records[CTL_BAG_REGISTERS * (packer.bags % CTL_BAG_RECORDS) + 3];
    };
    constexpr unsigned bad = 1U << CTL_BAG_BIT_START_UP | 1U << CTL_BAG_BIT_CHANGE_OVER;
    const auto runWhile = [&](const auto& condition) {
        for (std::uint64_t us = 0; us < 120 * second && condition(); us += 5000)
            rig->run(5000);
        return !condition();
    };
    if (!runWhile([&] { return packer.bags < 3 || (flags() & bad) != 0; }))
        return {};
    rig->run(static_cast<std::uint64_t>((share(random) + 8.5) * from.solved.cycleS() * 1e6));
    Actual actual;
    const std::uint32_t skipped = packer.skipped;
    const std::uint32_t generation = rig->core().banks.generation;
    if (rig->download(to.registers, 2) != CTL_TRANSFER_RESULT_ACCEPTED ||
        rig->apply(to.registers, CTL_APPLY_MODE_NEXT_CYCLE, 2) != CTL_REFUSAL_NONE)
        return {};
    const std::uint64_t beganUs = rig->controller().nowUs();
    std::uint32_t bags = packer.bags;
    bool counts = false;
    actual.isDone = runWhile([&] {
        if (packer.bags != bags && rig->core().banks.generation != generation) {
            counts = (flags() & bad) == 0;
            actual.scrap += counts ? 0 : 1;
            const double setMm = static_cast<double>(packer.last_cut.set_um) / 1000;
            if (packer.last_cut.bags > 1)
                actual.longestMm = std::max(actual.longestMm, setMm);
        }
        bags = packer.bags;
        return !counts;
    });
    actual.seconds = static_cast<double>(rig->controller().nowUs() - beganUs) / 1e6;
    actual.skipped = static_cast<int>(packer.skipped - skipped);
    return actual;
}

} // namespace

class TestChangePrice : public QObject {
    Q_OBJECT

private slots:
    void whatIsToldIsWhatHappens_data()
    {
        QTest::addColumn<double>("fromMm");
        QTest::addColumn<double>("fromRate");
        QTest::addColumn<double>("toMm");
        QTest::addColumn<double>("toRate");
        QTest::addColumn<bool>("tracks");
        QTest::addColumn<double>("lineMmPerS");
        QTest::addRow("180 to 220 mm") << 180.0 << 80.0 << 220.0 << 80.0 << true << 0.0;
        QTest::addRow("250 to 200 mm") << 250.0 << 60.0 << 200.0 << 60.0 << true << 0.0;
        QTest::addRow("200 to 300 mm, slower") << 200.0 << 90.0 << 300.0 << 60.0 << true << 0.0;
        QTest::addRow("another rate") << 250.0 << 60.0 << 250.0 << 80.0 << true << 0.0;
        QTest::addRow("without marks") << 180.0 << 80.0 << 220.0 << 80.0 << false << 0.0;
        QTest::addRow("180 to 220 mm, an encoder") << 180.0 << 80.0 << 220.0 << 80.0 << true << 220.0;
        QTest::addRow("250 to 200 mm, an encoder") << 250.0 << 60.0 << 200.0 << 60.0 << true << 200.0;
        QTest::addRow("250 to 200 mm, a slow line") << 250.0 << 60.0 << 200.0 << 60.0 << true << 40.0;
        QTest::addRow("another rate, an encoder") << 250.0 << 60.0 << 250.0 << 80.0 << true << 250.0;
    }
    void whatIsToldIsWhatHappens()
    {
        QFETCH(double, fromMm);
        QFETCH(double, fromRate);
        QFETCH(double, toMm);
        QFETCH(double, toRate);
        QFETCH(bool, tracks);
        QFETCH(double, lineMmPerS);
        const program::ProgramImage from = imageOf(fromMm, fromRate);
        const program::ProgramImage to = imageOf(toMm, toRate);
        program::ChangeParameters parameters = changeParameters();
        if (lineMmPerS > 0)
            parameters.line = {.share = lineMmPerS * from.solved.cycleS() / fromMm,
                               .maxShare = defaultOf("master.speed_max") / 100,
                               .engage = defaultOf("master.engage") / 100};
        const auto course =
            program::programChange(from.recipe, from.solved, to.recipe, to.solved, parameters);
        QVERIFY(course.has_value());
        const program::ChangePrice price =
            program::changePrice(from.solved, to.solved, *course, priceParameters(tracks));
        Actual worst;
        int leastScrap = 1000;
        constexpr unsigned changes = 12;
        for (unsigned seed = 1; seed <= changes; ++seed) {
            const Actual actual = change(from, to, tracks, lineMmPerS, seed);
            QVERIFY2(actual.isDone, qPrintable(QStringLiteral("seed %1").arg(seed)));
            leastScrap = std::min(leastScrap, actual.scrap);
            worst.scrap = std::max(worst.scrap, actual.scrap);
            worst.skipped = std::max(worst.skipped, actual.skipped);
            worst.longestMm = std::max(worst.longestMm, actual.longestMm);
            worst.seconds = std::max(worst.seconds, actual.seconds);
        }
        qInfo("scrap %d to %d (told %d to %d), skipped %d (%d), longest %.0f mm (%.0f), %.1f s (%.1f)",
              leastScrap, worst.scrap, price.minScrap, price.maxScrap, worst.skipped, price.maxSkipped,
              worst.longestMm, price.longestBagMm, worst.seconds, price.maxSeconds);
        // Nothing worse happens than is told, and what is told is not far from it.
        QVERIFY(leastScrap >= price.minScrap && worst.scrap <= price.maxScrap);
        QVERIFY(worst.skipped <= price.maxSkipped);
        QVERIFY(worst.longestMm <= price.longestBagMm + 1);
        QVERIFY(worst.seconds <= price.maxSeconds);
        QVERIFY2(price.maxScrap <= worst.scrap + 3, "told scrap");
        QVERIFY2(price.maxSkipped <= worst.skipped + 3, "told cuts");
        QVERIFY2(price.longestBagMm <= 2.5 * worst.longestMm, "told length");
        QVERIFY2(price.maxSeconds <= 2 * worst.seconds, "told time");
    }
};

CAMPANEL_TEST(TestChangePrice)

} // namespace test_change_price

#include "test_change_price.moc"
