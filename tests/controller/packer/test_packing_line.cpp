// SPDX-License-Identifier: Apache-2.0
// Film, infeed and knife together: the controller's core on the simulated packing machine.
#include "rig.h"

#include "packer/ctl_packer.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <cstdlib>

namespace test_packing_line {

using namespace campanel::test;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 0.2 s: 300 a minute
constexpr std::uint64_t cycleUs = 200'000;
constexpr double fine = 256.0;

BankImage cutter(std::uint32_t bagUm = 250'000)
{
    BankImage bank = camBank(10000, 1, cycleTicks);
    bank.bagLengthUm = bagUm;
    return bank;
}

// Returns a machine without disturbances.
MachineOptions calm()
{
    MachineOptions options;
    options.film.slipMm = 0.0;
    options.film.stretch = 0.0;
    options.film.markNoiseMm = 0.0;
    options.products.scatterMm = 0.0;
    options.products.laySlipMm = 0.0;
    options.products.eyeNoiseMm = 0.0;
    options.products.lengthScatterMm = 0.0;
    return options;
}

// Returns the deviations of the bags cut during this time, mm.
std::vector<double> bagsOf(Rig& rig, std::uint64_t timeUs)
{
    std::vector<double> deviations;
    const std::uint64_t untilUs = rig.controller().nowUs() + timeUs;
    while (rig.controller().nowUs() < untilUs) {
        rig.controller().step();
        const auto& cut = rig.controller().cut();
        if (cut && cut->lengthUm)
            deviations.push_back(*cut->lengthUm / 1000.0 - 250.0 * rig.core().packer.last_cut.bags);
    }
    return deviations;
}

double largest(const std::vector<double>& values)
{
    double result = 0.0;
    for (const double value : values)
        result = std::max(result, std::abs(value));
    return result;
}

} // namespace

class TestPackingLine : public QObject {
    Q_OBJECT

private slots:
    void filmIsDrawnExactly();
    void bagsFollowTheMarks();
    void correctionsLeaveTheSealingWindowAlone();
    void knifeStaysOpenOverAProduct();
    void firstCutIsAskedAboutToo();
    void changesOfLengthCutNoProduct();
    void filmWaitsForAProduct();
    void trimLengthensBagsOnlyWithoutMarks();
    void otherLengthAtTheBoundary();
    void stopAndStartGoOn();
    void cutsOfAStopMeetTheirMarks_data();
    void cutsOfAStopMeetTheirMarks();
    void jogIsForgottenByTheNextRun();
    void teachingMeasuresTheMarks();
    void feedsThatAreTooFastAreRefused();
    void olderFlashKeepsItsParameters();
    void registersTellWhatHappens();
};

void TestPackingLine::filmIsDrawnExactly()
{
    Rig rig(calm());
    rig.install(cutter(100'001));
    rig.setParameter(CTL_REG_PARAMETER_MARK_TRACKING, 0);
    rig.start();
    rig.run(20'000'000);
    const ctl_packer& packer = rig.core().packer;
    QVERIFY(packer.number > 90);
    // 100.001 mm are 1706683.7 in 1/256 pulse of 0.015 mm: rounded down once, then exact.
    const std::int64_t bag = 100'001LL * 10'000 * 256 / 150'000;
    QCOMPARE(packer.film.start, packer.number * bag);
    QVERIFY(std::abs(static_cast<double>(packer.film_sent) * fine -
                     static_cast<double>(ctl_feed_position(&packer.film))) < fine);
    QCOMPARE(packer.infeed.start, packer.number * packer.flight);
}

void TestPackingLine::bagsFollowTheMarks()
{
    Rig rig;
    rig.install(cutter());
    rig.start();
    bagsOf(rig, 20 * cycleUs);
    QCOMPARE(rig.core().packer.marks.state, CTL_MARK_STATE_TRACKING);
    const std::vector<double> deviations = bagsOf(rig, 300 * cycleUs);
    QCOMPARE(deviations.size(), std::size_t{300});
    QVERIFY2(largest(deviations) < 0.2, qPrintable(QString::number(largest(deviations))));
    // The film is stretched by 0.25 % on average: without the marks every bag is short.
    rig.setParameter(CTL_REG_PARAMETER_MARK_TRACKING, 0);
    bagsOf(rig, 3 * cycleUs);
    QVERIFY(largest(bagsOf(rig, 100 * cycleUs)) > 0.1);
}

void TestPackingLine::correctionsLeaveTheSealingWindowAlone()
{
    Rig rig;
    rig.install(cutter());
    rig.start();
    rig.run(20 * cycleUs);
    const ctl_packer& packer = rig.core().packer;
    const double perSlice = static_cast<double>(packer.bag) * 250.0 / static_cast<double>(cycleUs);
    double fastest = 1.0;
    std::int64_t before = ctl_feed_position(&packer.film);
    for (int i = 0; i < 100 * 800; ++i) {
        const bool inside = packer.film.phase >= packer.engage && packer.film.phase < packer.release;
        rig.controller().step();
        const bool still = packer.film.phase >= packer.engage && packer.film.phase <= packer.release;
        const double share = static_cast<double>(ctl_feed_position(&packer.film) - before) / perSlice;
        before = ctl_feed_position(&packer.film);
        if (inside && still)
            QVERIFY2(std::abs(share - 1.0) < 3e-4, qPrintable(QString::number(share)));
        fastest = std::max(fastest, share);
    }
    QVERIFY2(fastest > 1.001, "nothing was corrected, so nothing was shown");
}

void TestPackingLine::knifeStaysOpenOverAProduct()
{
    MachineOptions options;
    options.products.misplaced = 0.3;
    Rig rig(options);
    rig.install(cutter());
    rig.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 100);
    rig.start();
    const ctl_packer& packer = rig.core().packer;
    const std::int64_t stroke = 10'000;
    int cuts = 0;
    bool stood = false;
    for (std::uint64_t us = 0; us < 500 * cycleUs; us += 250) {
        rig.controller().step();
        if (packer.knife_gate.state == CTL_GATE_STATE_STANDING) {
            stood = true;
            QCOMPARE(rig.commanded() % stroke, 0); // the boundary of its cycle: open
        }
        if (!rig.controller().cut())
            continue;
        ++cuts;
        QVERIFY(!rig.controller().cut()->throughProduct);
        if (cuts > 10)
            QVERIFY2(std::abs(rig.controller().cut()->markErrorMm) < 0.6,
                     qPrintable(QString::number(rig.controller().cut()->markErrorMm)));
    }
    QVERIFY(stood);
    QVERIFY(packer.skipped > 20);
    // The cuts correspond exactly to the bags of film.
    QVERIFY(std::abs(static_cast<int>(packer.skipped) + cuts -
                     static_cast<int>(packer.film.start / packer.bag)) <= 3);
}

// At every start the knife may be above an unchecked product.
void TestPackingLine::firstCutIsAskedAboutToo()
{
    MachineOptions options;
    options.products.misplaced = 0.7;
    Rig rig(options);
    rig.install(cutter());
    rig.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 100);
    std::uint32_t waitedAtOnce = 0;
    for (int i = 0; i < 60; ++i) {
        rig.start();
        waitedAtOnce += rig.core().packer.knife_gate.state == CTL_GATE_STATE_STANDING ? 1u : 0u;
        for (std::uint64_t us = 0; us < (8 + static_cast<std::uint64_t>(i % 7)) * cycleUs; us += 250) {
            rig.controller().step();
            QVERIFY(!rig.controller().cut() || !rig.controller().cut()->throughProduct);
        }
        rig.command(CTL_COMMAND_STOP_NOW);
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
        rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
        rig.run(50'000);
        rig.heartbeat();
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
    }
    QVERIFY(waitedAtOnce > 3);
}

void TestPackingLine::changesOfLengthCutNoProduct()
{
    MachineOptions options;
    options.products.misplaced = 0.1;
    options.products.lengthMm = 120.0;
    Rig rig(options);
    rig.install(cutter());
    rig.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 100);
    rig.start();
    int cuts = 0;
    for (std::uint16_t change = 1; change <= 30; ++change) {
        const BankImage other = cutter(change % 2 != 0 ? 190'000 : 250'000);
        rig.download(other.registers(), change);
        QCOMPARE(rig.apply(other.registers(), CTL_APPLY_MODE_NEXT_CYCLE, change), CTL_REFUSAL_NONE);
        for (std::uint64_t us = 0; us < 25 * cycleUs || rig.core().banks.generation == change; us += 250) {
            rig.controller().step();
            QVERIFY(us < 300 * cycleUs);
            if (!rig.controller().cut())
                continue;
            ++cuts;
            QVERIFY(!rig.controller().cut()->throughProduct);
        }
        QCOMPARE(rig.core().banks.generation, change + 1u);
    }
    QVERIFY(cuts > 300);
}

void TestPackingLine::filmWaitsForAProduct()
{
    MachineOptions options = calm();
    options.products.missing = 0.2;
    Rig rig(options);
    rig.install(cutter());
    rig.setParameter(CTL_REG_PARAMETER_EMPTY_BAG, 1);
    rig.start();
    rig.run(20 * cycleUs);
    const ctl_packer& packer = rig.core().packer;
    std::uint32_t empty = 0;
    std::uint64_t standsUs = 0;
    int cuts = 0;
    for (std::uint64_t us = 0; us < 400 * cycleUs; us += 250) {
        rig.controller().step();
        standsUs = packer.film_gate.state == CTL_GATE_STATE_STANDING ? standsUs + 250 : 0;
        if (standsUs != 0)
            QCOMPARE(packer.film.phase, 0u);
        if (standsUs > 3u * CTL_TOWER_STEP_US) // the light tower shows it
            QVERIFY((rig.core().tower.conditions & 1u << CTL_SIGNAL_BIT_WAITING) != 0);
        if (!rig.controller().cut())
            continue;
        ++cuts;
        empty += rig.controller().cut()->products.empty() ? 1u : 0u;
        QCOMPARE(rig.core().packer.last_cut.bags, 1u);
    }
    const auto saved = static_cast<int>(packer.saved_um / 250'000);
    QVERIFY(saved > 40);
    QCOMPARE(empty, 0u);
    QVERIFY(std::abs(cuts + saved - 400) < 12);
    // Infeed and film are apart by the cycles of the saved bags.
    const double apart =
        static_cast<double>(packer.number * packer.bag - packer.film.start) / static_cast<double>(packer.bag);
    QVERIFY2(std::abs(apart - saved) < 1.1, qPrintable(QString::number(apart)));
}

void TestPackingLine::trimLengthensBagsOnlyWithoutMarks()
{
    Rig rig(calm());
    rig.install(cutter());
    rig.setParameter(CTL_REG_PARAMETER_LENGTH_TRIM, static_cast<std::uint16_t>(-1500));
    rig.start();
    rig.run(20 * cycleUs);
    QVERIFY(largest(bagsOf(rig, 20 * cycleUs)) < 0.02);
    rig.setParameter(CTL_REG_PARAMETER_MARK_TRACKING, 0);
    rig.run(3 * cycleUs);
    for (const double deviation : bagsOf(rig, 20 * cycleUs))
        QVERIFY2(std::abs(deviation + 1.5) < 0.02, qPrintable(QString::number(deviation)));
}

void TestPackingLine::otherLengthAtTheBoundary()
{
    Rig rig(calm());
    rig.install(cutter());
    rig.start();
    rig.run(20 * cycleUs);
    const BankImage other = cutter(300'000);
    rig.download(other.registers(), 2);
    QCOMPARE(rig.apply(other.registers(), CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);
    const ctl_packer& packer = rig.core().packer;
    std::int64_t before = ctl_feed_position(&packer.film);
    const double perSlice = 300.0 / 0.015 * fine * 250.0 / static_cast<double>(cycleUs);
    for (std::uint64_t us = 0; us < 20 * cycleUs; us += 250) {
        rig.controller().step();
        const std::int64_t now = ctl_feed_position(&packer.film);
        QVERIFY(now >= before && static_cast<double>(now - before) < 1.25 * perSlice);
        before = now;
    }
    QCOMPARE(rig.core().banks.generation, 2u);
    rig.run(20 * cycleUs);
    QCOMPARE(packer.marks.state, CTL_MARK_STATE_TRACKING);
    QVERIFY(std::abs(static_cast<double>(rig.core().bags.length_um) - 300'000.0) < 20.0);
}

void TestPackingLine::stopAndStartGoOn()
{
    Rig rig(calm());
    rig.install(cutter());
    rig.start();
    rig.run(20 * cycleUs);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    const ctl_packer& packer = rig.core().packer;
    QCOMPARE(packer.master, 0u);
    QCOMPARE(packer.infeed_sent, packer.number * packer.flight / 256);
    rig.start();
    QCOMPARE(packer.marks.state, CTL_MARK_STATE_TRACKING);
    // In the ramp, at 300 a minute, film and knife lag by different times.
    std::vector<double> deviations = bagsOf(rig, 20 * cycleUs);
    QVERIFY2(largest(deviations) < 1.0, qPrintable(QString::number(largest(deviations))));
    deviations.erase(deviations.begin(), deviations.begin() + 2);
    QVERIFY2(largest(deviations) < 0.05, qPrintable(QString::number(largest(deviations))));
}

// Stops at every part of a cycle, after its cut was planned and before; the master slows down over several
// cuts.
void TestPackingLine::cutsOfAStopMeetTheirMarks_data()
{
    QTest::addColumn<int>("command");
    QTest::addColumn<double>("limitMm");
    QTest::newRow("at the end of the cycle") << int{CTL_COMMAND_STOP_AT_CYCLE_END} << 0.05;
    QTest::newRow("now") << int{CTL_COMMAND_STOP_NOW} << 0.2;
}

void TestPackingLine::cutsOfAStopMeetTheirMarks()
{
    QFETCH(int, command);
    QFETCH(double, limitMm);
    std::vector<double> errors;
    Rig rig(calm());
    rig.install(cutter());
    for (std::uint64_t part = 0; part < 20; ++part) {
        rig.start();
        rig.run(20 * cycleUs + part * cycleUs / 20);
        rig.command(static_cast<std::uint16_t>(command));
        while (rig.core().motion.state != CTL_STATE_READY) {
            rig.controller().step();
            if (rig.controller().cut())
                errors.push_back(rig.controller().cut()->markErrorMm);
        }
    }
    QVERIFY(errors.size() > 20);
    QVERIFY2(largest(errors) < limitMm, qPrintable(QString::number(largest(errors))));
}

void TestPackingLine::jogIsForgottenByTheNextRun()
{
    Rig rig(calm());
    rig.install(cutter());
    rig.start();
    rig.run(20 * cycleUs);
    rig.command(CTL_COMMAND_STOP_NOW);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    for (int i = 0; i < 20; ++i) {
        rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
        rig.run(50'000);
    }
    rig.heartbeat();
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.start();
    const ctl_packer& packer = rig.core().packer;
    rig.run(30 * cycleUs);
    QCOMPARE(packer.infeed.start % packer.flight, 0); // again among the products' places
    QCOMPARE(packer.marks.state, CTL_MARK_STATE_TRACKING);
    QVERIFY(largest(bagsOf(rig, 20 * cycleUs)) < 0.05);
}

void TestPackingLine::teachingMeasuresTheMarks()
{
    MachineOptions options = calm();
    options.film.printError = 0.04;
    Rig rig(options);
    rig.install(cutter());
    rig.setParameter(CTL_REG_PARAMETER_MARK_TRACKING, 0);
    QCOMPARE(rig.command(CTL_COMMAND_TEACH_MARKS, 1), CTL_REFUSAL_BAD_ARGUMENT);
    rig.start();
    QCOMPARE(rig.command(CTL_COMMAND_TEACH_MARKS, 10), CTL_REFUSAL_NONE);
    QCOMPARE(rig.status(CTL_REG_PACKER_TEACH_MARKS), 0);
    rig.run(20 * cycleUs);
    QCOMPARE(rig.status(CTL_REG_PACKER_TEACH_MARKS), 10);
    QVERIFY(std::abs(static_cast<double>(rig.statusWide(CTL_REG_PACKER_TEACH_PITCH)) - 260'000.0) < 5.0);
    QVERIFY(rig.status(CTL_REG_PACKER_TEACH_SCATTER) < 5);
}

// A slot as written by controllers with ten parameters.
void TestPackingLine::feedsThatAreTooFastAreRefused()
{
    Rig rig;
    rig.install(cutter()); // 83 kHz for the film, 100 for the infeed, a little more in corrections
    rig.write(CTL_REG_PARAMETER_FILM_PULSES, {0, 20'000});
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    rig.command(CTL_COMMAND_STOP_NOW);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.write(CTL_REG_PARAMETER_FILM_PULSES, {0, 20'400}); // 170 kHz and 0.15 / 0.8 of that
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_FEED_TOO_FAST);
    rig.write(CTL_REG_PARAMETER_FILM_PULSES, {0, 10'000});
    rig.write(CTL_REG_PARAMETER_FLIGHT_PULSES, {0, 30'000});
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_FEED_TOO_FAST);
}

void TestPackingLine::olderFlashKeepsItsParameters()
{
    MemoryFlash flash;
    const Registers image = cutter().registers();
    Bytes bytes;
    const auto append = [&bytes](std::uint32_t value, int size) {
        for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
            bytes.push_back(static_cast<std::uint8_t>(value >> shift & 0xFFu));
    };
    append(0x43414D32, 4);
    append(7, 4);
    append(3, 4);
    for (const std::uint16_t parameter : Registers{2500, 1, 1234, 0, 1000, 0, 2000, 0, 3000, 0})
        append(parameter, 2);
    for (const std::uint16_t value : image)
        append(value, 2);
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1u) != 0 ? (crc >> 1) ^ 0xEDB88320u : crc >> 1;
    }
    append(~crc, 4);
    flash.contents[0] = bytes;
    Rig rig({}, &flash);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_READY);
    QCOMPARE(rig.status(CTL_REG_PARAMETER_RAMP_TIME), 1234);
    QCOMPARE(rig.statusWide(CTL_REG_PARAMETER_MARK_DISTANCE), 900'000u);
    rig.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 9);
    QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(image)), CTL_REFUSAL_NONE);
    Rig again({}, &flash);
    QCOMPARE(again.status(CTL_REG_PARAMETER_RAMP_TIME), 1234);
    QCOMPARE(again.status(CTL_REG_PARAMETER_SKIP_LIMIT), 9);
}

void TestPackingLine::registersTellWhatHappens()
{
    Rig rig(calm());
    Registers nothing(104, 0);
    std::fill(nothing.begin() + (CTL_REG_PACKER_CUTS - CTL_REG_PACKER_MARK_STATE), nothing.end(), 0x8000);
    QCOMPARE(rig.read(CTL_REG_PACKER_MARK_STATE, 104), nothing);
    rig.install(cutter());
    rig.start();
    rig.run(20 * cycleUs + 50'000);
    const ctl_packer& packer = rig.core().packer;
    const Registers group = rig.read(CTL_REG_PACKER_MARK_STATE, 104);
    const auto at = [&group](unsigned address) { return group.at(address - CTL_REG_PACKER_MARK_STATE); };
    QCOMPARE(at(CTL_REG_PACKER_MARK_STATE), CTL_MARK_STATE_TRACKING);
    const unsigned newest = CTL_REG_PACKER_BAGS + CTL_BAG_REGISTERS * (packer.bags % CTL_BAG_RECORDS);
    QVERIFY(std::abs(static_cast<std::int16_t>(at(newest))) < 20);
    QCOMPARE(at(newest + 3), 1u << CTL_BAG_BIT_TRACKED | 1u << 8);
    // Cuts are a bag apart, marks at the cuts, a product in the middle between two of them.
    const auto tenths = [&](unsigned address) { return static_cast<std::int16_t>(at(address)); };
    for (unsigned i = 0; i + 1 < CTL_VIEW_CUTS; ++i)
        QVERIFY(std::abs(tenths(CTL_REG_PACKER_CUTS + i + 1) - tenths(CTL_REG_PACKER_CUTS + i) - 2500) <= 4);
    const int toCut = tenths(CTL_REG_PACKER_CUTS);
    QVERIFY(toCut >= 0 && toCut <= 2500);
    int nearest = 10'000;
    for (unsigned i = 0; i < packer.marks.count; ++i)
        nearest = std::min(nearest, std::abs(tenths(CTL_REG_PACKER_SEEN_MARKS + i) - toCut));
    QVERIFY2(nearest <= 4, qPrintable(QString::number(nearest)));
    const int lead = tenths(CTL_REG_PACKER_SEEN_PRODUCTS);
    const int trail = tenths(CTL_REG_PACKER_SEEN_PRODUCTS + 1);
    QCOMPARE(trail - lead, 1500);
    const int off = ((lead + trail) / 2 - toCut - 1250) % 2500;
    QVERIFY2(std::abs(off) < 60 || std::abs(off) > 2440, qPrintable(QString::number(off)));
}

CAMPANEL_TEST(TestPackingLine)

} // namespace test_packing_line

#include "test_packing_line.moc"
