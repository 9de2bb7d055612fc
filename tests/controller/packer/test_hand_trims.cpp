// SPDX-License-Identifier: Apache-2.0
// The operator's hand on cut, product and length: each moves by what was asked within three bags, without a
// step of an axis, and nothing is cut through a product.
#include "rig.h"

#include "base/ctl_kept.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace test_hand_trims {

using namespace campanel::test;
using campanel::controller::BagCut;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 0.2 s: 300 a minute
constexpr std::uint64_t cycleUs = 200'000;
constexpr double bagMm = 250.0;
constexpr double fine = 256.0;
constexpr int illegalValue = 3;
// The steps of speed that an axis may make at a change of program, pulses/s.
constexpr double maxFilmHz = 1300.0;
constexpr double maxInfeedHz = 800.0;
enum class Master { Clock, Shaft, Wheel };

MachineOptions calm(Master master)
{
    MachineOptions options;
    options.film.slipMm = 0.0;
    options.film.stretch = 0.0;
    options.film.markNoiseMm = 0.0;
    options.products.scatterMm = 0.0;
    options.products.laySlipMm = 0.0;
    options.products.eyeNoiseMm = 0.0;
    options.products.lengthScatterMm = 0.0;
    if (master == Master::Clock)
        return options;
    options.shaft.counts = 10'000;
    options.shaft.speedMmPerS = bagMm * 1e6 / cycleUs;
    options.shaft.drivesFilm = master == Master::Wheel;
    return options;
}

double middle(const BagCut& cut)
{
    const auto& laid = cut.products.front();
    return (laid.leadMm + laid.trailMm) / 2;
}

class Line : public Rig {
public:
    explicit Line(Master master = Master::Clock, bool marks = true)
        : Line(calm(master), master, marks)
    {
    }
    Line(const MachineOptions& options, Master master, bool marks, MemoryFlash* flash = nullptr)
        : Rig(options, flash)
    {
        install(bank());
        setParameter(CTL_REG_PARAMETER_MARK_TRACKING, marks ? 1 : 0);
        setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 100);
        if (master != Master::Clock) {
            write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
            write(CTL_REG_MASTER_PLACE,
                  {static_cast<std::uint16_t>(master == Master::Wheel ? CTL_MASTER_PLACE_WHEEL
                                                                      : CTL_MASTER_PLACE_SHAFT)});
            run(500'000);
        }
        start();
        run(40 * cycleUs);
    }
    static BankImage bank()
    {
        BankImage image = camBank(10000, 1, cycleTicks);
        image.bagLengthUm = 250'000;
        return image;
    }

    int set(std::uint16_t address, double mm)
    {
        m_film.known = m_infeed.known = 0; // the frames take some slices
        return write(address, {static_cast<std::uint16_t>(std::lround(mm * 1000))});
    }
    std::uint16_t save() { return command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, core().banks.active_crc); }
    double value(std::uint16_t address) { return static_cast<std::int16_t>(status(address)) / 1000.0; }
    // Returns the next cut, with a product in its bag.
    BagCut next()
    {
        for (int i = 0; i < 40'000; ++i) {
            step();
            if (controller().cut() && controller().cut()->lengthUm && !controller().cut()->products.empty())
                return *controller().cut();
        }
        return {};
    }
    BagCut after(int bags)
    {
        for (int i = 1; i < bags; ++i)
            (void)next();
        return next();
    }
    // Where the middle of the product is behind the cut at its front, mm.
    double productMm()
    {
        const BagCut front = next();
        const BagCut end = next();
        return middle(end) - front.drawnMm;
    }
    void step()
    {
        controller().step();
        const ctl_packer& packer = core().packer;
        note(packer.film_at, m_film, m_filmStep);
        note(packer.infeed_at, m_infeed, m_infeedStep);
        cutsThrough += controller().cut() && controller().cut()->throughProduct ? 1 : 0;
    }
    void steps(std::uint64_t timeUs)
    {
        const std::uint64_t untilUs = controller().nowUs() + timeUs;
        while (controller().nowUs() < untilUs)
            step();
    }
    // The largest changes of speed in a slice, against those without a touch: the counts of an encoder are
    // some, too.
    void learnSteps()
    {
        steps(20 * cycleUs);
        m_filmHz = std::exchange(m_filmStep, 0.0);
        m_infeedHz = std::exchange(m_infeedStep, 0.0);
    }
    bool hasStepped()
    {
        const bool film = m_filmStep > m_filmHz + maxFilmHz / 4;
        const bool infeed = m_infeedStep > m_infeedHz + maxInfeedHz / 4;
        m_filmStep = m_infeedStep = 0.0;
        return film || infeed;
    }

    int cutsThrough = 0;

private:
    struct Axis {
        std::int64_t at = 0;
        std::int64_t way = 0;
        int known = 0;
    };
    static void note(std::int64_t at, Axis& axis, double& largest)
    {
        const std::int64_t way = at - axis.at;
        if (axis.known >= 2)
            largest = std::max(largest, std::abs(static_cast<double>(way - axis.way)) / fine * 4000.0);
        axis = {at, way, axis.known + 1};
    }
    Axis m_film;
    Axis m_infeed;
    double m_filmStep = 0.0;
    double m_infeedStep = 0.0;
    double m_filmHz = 0.0;
    double m_infeedHz = 0.0;
};

} // namespace

class TestHandTrims : public QObject {
    Q_OBJECT

private slots:
    void theCutMovesOnThePrint_data();
    void theCutMovesOnThePrint();
    void theCutMovesToTheProductWithoutMarks();
    void theProductMovesInItsBag_data();
    void theProductMovesInItsBag();
    void bagsBecomeLongerWithoutMarks();
    void aSetOffsetMovesTheCutToo();
    void trimsAtStandstillActFromTheStart();
    void trimsBelongToTheProgramsName();
    void trimsSurviveAPowerCutWhenSaved();
    void unsavedTrimsSurviveAPowerCut();
    void keptTrimsBelongToTheirProgram();
    void recordOfOtherTrimsIsNone();
    void trimsBeyondTheirLimitsAreRefused();
    void randomTouchesCutNoProduct_data();
    void randomTouchesCutNoProduct();
};

void TestHandTrims::theCutMovesOnThePrint_data()
{
    QTest::addColumn<int>("master");
    QTest::newRow("clock") << int(Master::Clock);
    QTest::newRow("encoder on a shaft") << int(Master::Shaft);
    QTest::newRow("encoder on the film") << int(Master::Wheel);
}

void TestHandTrims::theCutMovesOnThePrint()
{
    QFETCH(int, master);
    Line line{static_cast<Master>(master)};
    const double before = line.next().markErrorMm;
    line.learnSteps();
    const std::uint32_t limitedBefore = line.core().packer.phase.limited;
    for (const double mm : {2.0, -0.5, 5.0, 0.0}) {
        QCOMPARE(line.set(CTL_REG_HAND_CUT, mm), 0);
        const BagCut third = line.after(3);
        QVERIFY2(std::abs(third.markErrorMm - before - mm) < 0.1,
                 qPrintable(QString::number(third.markErrorMm - before)));
        const BagCut fourth = line.next();
        QVERIFY2(std::abs(*fourth.lengthUm / 1000.0 - bagMm) < 0.1,
                 qPrintable(QString::number(*fourth.lengthUm)));
        QCOMPARE(ctl_packer_bag_class(&line.core().packer), CTL_BAG_GOOD);
        QVERIFY(!line.hasStepped());
    }
    QCOMPARE(line.core().packer.phase.limited, limitedBefore);
}

void TestHandTrims::theCutMovesToTheProductWithoutMarks()
{
    Line line(Master::Clock, false);
    const double before = line.productMm();
    QCOMPARE(line.set(CTL_REG_HAND_CUT, 4.0), 0);
    (void)line.after(2);
    // At once, with the products that are on the film already, and for good.
    for (int i = 0; i < 10; ++i) {
        const double moved = line.productMm() - before;
        QVERIFY2(std::abs(moved + 4.0) < 0.1, qPrintable(QString::number(moved)));
    }
}

void TestHandTrims::theProductMovesInItsBag_data()
{
    QTest::addColumn<int>("master");
    QTest::addColumn<bool>("marks");
    QTest::newRow("clock, marks") << int(Master::Clock) << true;
    QTest::newRow("clock, no marks") << int(Master::Clock) << false;
    QTest::newRow("encoder on a shaft") << int(Master::Shaft) << true;
}

// Those that lie on the film already stay where they are: two bags here.
void TestHandTrims::theProductMovesInItsBag()
{
    QFETCH(int, master);
    QFETCH(bool, marks);
    Line line(static_cast<Master>(master), marks);
    const double before = line.productMm();
    line.learnSteps();
    for (const double mm : {2.0, -20.0, 20.0, 0.0}) {
        QCOMPARE(line.set(CTL_REG_HAND_PRODUCT, mm), 0);
        (void)line.after(std::abs(mm) > 3.0 ? 7 : 4);
        const double moved = line.productMm() - before;
        QVERIFY2(std::abs(moved + mm) < 0.15, qPrintable(QString::number(moved)));
        QVERIFY(!line.hasStepped());
    }
}

void TestHandTrims::bagsBecomeLongerWithoutMarks()
{
    Line line(Master::Clock, false);
    const double before = line.productMm();
    line.learnSteps();
    for (const double mm : {1.5, -5.0, 0.0}) {
        QCOMPARE(line.set(CTL_REG_HAND_LENGTH, mm), 0);
        (void)line.after(2);
        for (int i = 0; i < 10; ++i) {
            const double lengthMm = *line.next().lengthUm / 1000.0;
            QVERIFY2(std::abs(lengthMm - bagMm - mm) < 0.05, qPrintable(QString::number(lengthMm)));
        }
        // The product is in the middle of the longer bag.
        QVERIFY2(std::abs(line.productMm() - before - mm / 2) < 0.15,
                 qPrintable(QString::number(line.productMm() - before)));
        // The set length is the one that was asked for.
        QVERIFY(std::abs(static_cast<int>(line.core().packer.last_cut.set_um) - (250'000 + mm * 1000)) < 5);
        QVERIFY(!line.hasStepped());
    }
    Line marks;
    QCOMPARE(marks.set(CTL_REG_HAND_LENGTH, 2.0), 0);
    QVERIFY(std::abs(*marks.after(5).lengthUm / 1000.0 - bagMm) < 0.05);
}

// The technician's parameter moves the cut in the same way; far, the bags are scrap until it is there.
void TestHandTrims::aSetOffsetMovesTheCutToo()
{
    Line line;
    const double before = line.next().markErrorMm;
    QCOMPARE(line.write(CTL_REG_PARAMETER_MARK_OFFSET, {0, 3'000}), 0);
    QVERIFY(std::abs(line.after(3).markErrorMm - before - 3.0) < 0.1);
    QVERIFY(line.core().packer.in_register);
    QCOMPARE(line.write(CTL_REG_PARAMETER_MARK_OFFSET, {0, 63'000}), 0);
    (void)line.after(2);
    QVERIFY(!line.core().packer.in_register);
    QVERIFY(std::abs(line.after(6).markErrorMm - before - 63.0) < 0.1);
    QVERIFY(line.core().packer.in_register);
    QCOMPARE(line.core().motion.state, CTL_STATE_RUNNING);
}

void TestHandTrims::trimsAtStandstillActFromTheStart()
{
    Line line;
    const double before = line.next().markErrorMm;
    const double productBefore = line.productMm();
    line.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(line.runUntilState(CTL_STATE_READY));
    QCOMPARE(line.set(CTL_REG_HAND_CUT, -1.5), 0);
    QCOMPARE(line.set(CTL_REG_HAND_PRODUCT, 3.0), 0);
    line.run(1'000'000);
    QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(std::abs(line.after(3).markErrorMm - before + 1.5) < 0.2);
    (void)line.after(3);
    QVERIFY(std::abs(line.productMm() - productBefore + 3.0) < 0.3);
}

void TestHandTrims::trimsBelongToTheProgramsName()
{
    Line line;
    const auto change = [&line](std::uint16_t session, std::uint16_t name) {
        Registers image = Line::bank().registers();
        image[CTL_OFFSET_PROGRAM_RECIPE_VERSION] = session;
        image[CTL_OFFSET_PROGRAM_RECIPE_NAME] = name;
        QCOMPARE(line.download(image, session), CTL_TRANSFER_RESULT_ACCEPTED);
        QCOMPARE(line.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, session), CTL_REFUSAL_NONE);
        const std::uint32_t generation = line.core().banks.generation;
        for (int i = 0; i < 100 && line.core().banks.generation == generation; ++i)
            line.run(cycleUs);
        QCOMPARE(line.core().banks.generation, generation + 1);
        line.run(1000);
    };
    line.set(CTL_REG_HAND_CUT, 1.0);
    line.set(CTL_REG_HAND_NEXT_CUT, -2.0);
    line.set(CTL_REG_HAND_NEXT_PRODUCT, 5.0);
    change(2, 0); // the same recipe again
    QCOMPARE(line.value(CTL_REG_HAND_CUT), 1.0);
    QCOMPARE(line.value(CTL_REG_HAND_NEXT_CUT), 0.0);
    line.set(CTL_REG_HAND_NEXT_CUT, -2.0);
    line.set(CTL_REG_HAND_NEXT_PRODUCT, 5.0);
    change(3, 'B' << 8);
    QCOMPARE(line.value(CTL_REG_HAND_CUT), -2.0);
    QCOMPARE(line.value(CTL_REG_HAND_PRODUCT), 5.0);
    change(4, 'C' << 8); // one without trims
    QCOMPARE(line.value(CTL_REG_HAND_CUT), 0.0);
    QCOMPARE(line.value(CTL_REG_HAND_PRODUCT), 0.0);
}

// On a board that keeps no records.
void TestHandTrims::trimsSurviveAPowerCutWhenSaved()
{
    MemoryFlash flash;
    flash.hasRecords = false;
    Line line(calm(Master::Clock), Master::Clock, true, &flash);
    line.set(CTL_REG_HAND_CUT, 1.0);
    QCOMPARE(line.save(), CTL_REFUSAL_NONE);
    line.set(CTL_REG_HAND_CUT, 2.0);
    line.set(CTL_REG_HAND_NEXT_CUT, 3.0);
    line.controller().restart();
    QCOMPARE(line.value(CTL_REG_HAND_CUT), 1.0);
    QCOMPARE(line.value(CTL_REG_HAND_NEXT_CUT), 0.0);
}

// At each moment: the trims behind the power cut are those whose write was answered last.
void TestHandTrims::unsavedTrimsSurviveAPowerCut()
{
    MemoryFlash flash;
    Line line(calm(Master::Clock), Master::Clock, true, &flash);
    QCOMPARE(line.save(), CTL_REFUSAL_NONE);
    const Bytes slot = flash.contents[0];
    std::mt19937_64 random(17);
    for (int i = 0; i < 200; ++i) {
        const auto mm = [&random] { return static_cast<double>(random() % 8001) / 1000.0 - 4.0; };
        const double cut = mm();
        const double product = mm();
        line.run(random() % (3 * cycleUs));
        QCOMPARE(line.set(CTL_REG_HAND_CUT, cut), 0);
        line.run(random() % 1000);
        QCOMPARE(line.set(CTL_REG_HAND_PRODUCT, product), 0);
        line.run(random() % 1000);
        line.controller().restart();
        QCOMPARE(line.value(CTL_REG_HAND_CUT), cut);
        QCOMPARE(line.value(CTL_REG_HAND_PRODUCT), product);
        line.start();
    }
    QCOMPARE(flash.contents[0], slot);
}

// Another program at power-up has the trims that were saved with it, and so has the same one with other
// values.
void TestHandTrims::keptTrimsBelongToTheirProgram()
{
    MemoryFlash flash;
    Line line(calm(Master::Clock), Master::Clock, true, &flash);
    line.set(CTL_REG_HAND_CUT, 1.0);
    QCOMPARE(line.save(), CTL_REFUSAL_NONE);
    line.set(CTL_REG_HAND_CUT, 2.0);
    line.controller().restart();
    QCOMPARE(line.value(CTL_REG_HAND_CUT), 2.0);
    Registers image = Line::bank().registers();
    for (const unsigned name : {unsigned{'A'} << 8, 0u}) {
        image[CTL_OFFSET_PROGRAM_RECIPE_VERSION] = 7;
        image[CTL_OFFSET_PROGRAM_RECIPE_NAME] = static_cast<std::uint16_t>(name);
        line.install(image, 2); // not saved
        line.set(CTL_REG_HAND_CUT, 3.0);
        line.controller().restart();
        QCOMPARE(line.value(CTL_REG_HAND_CUT), 1.0);
    }
    // Back from a program of another name the first one has no trims.
    line.set(CTL_REG_HAND_CUT, 2.0);
    image[CTL_OFFSET_PROGRAM_RECIPE_NAME] = 'A' << 8;
    line.install(image, 2);
    line.install(Line::bank().registers(), 3);
    line.run(1000);
    QCOMPARE(line.value(CTL_REG_HAND_CUT), 0.0);
    line.controller().restart();
    QCOMPARE(line.value(CTL_REG_HAND_CUT), 0.0);
    // A change of the same recipe leaves the trims, and so does a power cut behind its save.
    line.set(CTL_REG_HAND_CUT, 4.0);
    image[CTL_OFFSET_PROGRAM_RECIPE_NAME] = 0;
    line.install(image, 4);
    line.run(1000);
    QCOMPARE(line.save(), CTL_REFUSAL_NONE);
    line.controller().restart();
    QCOMPARE(line.value(CTL_REG_HAND_CUT), 4.0);
}

void TestHandTrims::recordOfOtherTrimsIsNone()
{
    MemoryFlash flash;
    Line line(calm(Master::Clock), Master::Clock, true, &flash);
    QCOMPARE(line.save(), CTL_REFUSAL_NONE);
    line.set(CTL_REG_HAND_CUT, 2.0);
    const Bytes good = flash.records[CTL_KEPT_TRIMS];
    const auto valueWith = [&](const Bytes& record) {
        flash.records[CTL_KEPT_TRIMS] = record;
        line.controller().restart();
        return line.value(CTL_REG_HAND_CUT);
    };
    for (const std::size_t byte : {1u, 2u, 6u}) { // version, program, a cut beyond its limits
        Bytes wrong = good;
        wrong.at(byte) ^= 0x41u;
        QCOMPARE(valueWith(wrong), 0.0);
    }
    QCOMPARE(valueWith(Bytes(good.begin(), good.end() - 1)), 0.0);
    QCOMPARE(valueWith({}), 0.0); // of a controller that kept none
    QCOMPARE(valueWith(good), 2.0);
    flash.hasRecords = false;
    Line without(calm(Master::Clock), Master::Clock, true, &flash);
    QCOMPARE(without.value(CTL_REG_HAND_CUT), 0.0);
}

void TestHandTrims::trimsBeyondTheirLimitsAreRefused()
{
    Line line;
    for (const auto& [address, mm] : {std::pair{CTL_REG_HAND_CUT, 10.001},
                                      {CTL_REG_HAND_CUT, -10.001},
                                      {CTL_REG_HAND_PRODUCT, 20.001},
                                      {CTL_REG_HAND_LENGTH, -5.001}})
        QCOMPARE(line.set(static_cast<std::uint16_t>(address), mm), illegalValue);
    for (const unsigned address : {CTL_REG_HAND_CUT, CTL_REG_HAND_PRODUCT, CTL_REG_HAND_LENGTH})
        QCOMPARE(line.value(static_cast<std::uint16_t>(address)), 0.0);
}

void TestHandTrims::randomTouchesCutNoProduct_data()
{
    QTest::addColumn<int>("master");
    QTest::addColumn<bool>("marks");
    QTest::newRow("clock, marks") << int(Master::Clock) << true;
    QTest::newRow("clock, no marks") << int(Master::Clock) << false;
    QTest::newRow("encoder on a shaft") << int(Master::Shaft) << true;
    QTest::newRow("encoder on the film") << int(Master::Wheel) << true;
}

// Products are misplaced, missing and long, and stops come in between.
void TestHandTrims::randomTouchesCutNoProduct()
{
    QFETCH(int, master);
    QFETCH(bool, marks);
    bool isSet = false;
    const int touches = qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES", &isSet);
    MachineOptions options;
    options.products.misplaced = 0.2;
    options.products.missing = 0.02;
    options.products.lengthMm = 170.0;
    options.shaft = calm(static_cast<Master>(master)).shaft;
    Line line(options, static_cast<Master>(master), marks);
    std::mt19937_64 random(static_cast<std::uint64_t>(master) + 1);
    const auto upTo = [&random](double mm) {
        return std::uniform_real_distribution<double>(-mm, mm)(random);
    };
    const std::uint32_t skipped = line.core().packer.skipped;
    for (int i = 0; i < (isSet ? touches / 4 : 500); ++i) {
        switch (random() % 3) {
        case 0:
            QCOMPARE(line.set(CTL_REG_HAND_CUT, upTo(10.0)), 0);
            break;
        case 1:
            QCOMPARE(line.set(CTL_REG_HAND_PRODUCT, upTo(20.0)), 0);
            break;
        default:
            QCOMPARE(line.set(CTL_REG_HAND_LENGTH, upTo(5.0)), 0);
            break;
        }
        line.steps(random() % (2 * cycleUs));
        if (i % 100 == 99) {
            line.command(CTL_COMMAND_STOP_AT_CYCLE_END);
            QVERIFY(line.runUntilState(CTL_STATE_READY));
        }
        if (line.core().motion.state == CTL_STATE_READY)
            line.start();
        QCOMPARE(line.cutsThrough, 0);
        QVERIFY(line.core().motion.state != CTL_STATE_FAULT);
    }
    QVERIFY2(line.core().packer.skipped > skipped, "no product was in the way, so nothing was shown");
}

CAMPANEL_TEST(TestHandTrims)

} // namespace test_hand_trims

#include "test_hand_trims.moc"
