// SPDX-License-Identifier: Apache-2.0
// Errors that a packing machine must report: missing, double or misplaced marks, a sensor too far away,
// products that do not fit, film that stretches beyond the limits. Each ends in its alarm or refusal, and the
// knife never closes on a product.
#include "packing_bench.h"

#include "ctl_registers.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_packing_trouble {

using namespace campanel;
using namespace campanel::test;
using controller::PackedBag;
using controller::PackingEnd;
using controller::PackingJob;

namespace {

struct Trouble {
    const char* name;
    double lengthMm;
    void (*make)(PackingJob& job);
    PackingEnd end;
    std::uint32_t expected; // refusal, or the warning bits, at least one of which must be set
};

constexpr std::uint32_t bit(unsigned number)
{
    return 1u << number;
}

constexpr std::uint32_t marksLost = bit(CTL_WARNING_BIT_MARKS_LOST);
constexpr std::uint32_t pitchWrong = bit(CTL_WARNING_BIT_MARK_PITCH_WRONG);
constexpr std::uint32_t atLimit = bit(CTL_WARNING_BIT_CORRECTION_AT_LIMIT);
constexpr std::uint32_t tooLong = bit(CTL_WARNING_BIT_PRODUCT_TOO_LONG);
constexpr std::uint32_t joined = bit(CTL_WARNING_BIT_PRODUCTS_JOINED);
constexpr std::uint32_t tooManySkips = bit(CTL_WARNING_BIT_TOO_MANY_SKIPS);

const Trouble troubles[] = {
    {"no marks", 250, [](PackingJob& job) { job.machine.film.marksMissing = 1; }, PackingEnd::Alarm,
     marksLost},
    {"no marks, short bags", 100, [](PackingJob& job) { job.machine.film.marksMissing = 1; },
     PackingEnd::Alarm, marksLost},
    {"two marks a bag", 250, [](PackingJob& job) { job.machine.film.marksFalse = 1; }, PackingEnd::Alarm,
     pitchWrong},
    {"two marks a bag, long bags", 460, [](PackingJob& job) { job.machine.film.marksFalse = 1; },
     PackingEnd::Alarm, pitchWrong},
    {"print 5 % too long", 250, [](PackingJob& job) { job.machine.film.printError = 0.05; },
     PackingEnd::Alarm, pitchWrong},
    {"print 5 % too short", 250, [](PackingJob& job) { job.machine.film.printError = -0.05; },
     PackingEnd::Alarm, pitchWrong},
    // Within the window of a mark, but more than the possible correction per bag.
    {"print 5 % too long, short bags", 100, [](PackingJob& job) { job.machine.film.printError = 0.05; },
     PackingEnd::Alarm, pitchWrong | atLimit | tooManySkips},
    {"stretch sets in by 8 %", 250,
     [](PackingJob& job) {
         job.machine.film.stretchStep = 0.08;
         job.machine.film.stretchStepM = 20;
     },
     PackingEnd::Alarm, marksLost | pitchWrong | atLimit},
    {"stretch sets in by 8 %, short bags", 100,
     [](PackingJob& job) {
         job.machine.film.stretchStep = 0.08;
         job.machine.film.stretchStepM = 20;
     },
     PackingEnd::Alarm, marksLost | pitchWrong | atLimit},
    {"stretch falls by 8 %, long bags", 460,
     [](PackingJob& job) {
         job.machine.film.stretchStep = -0.08;
         job.machine.film.stretchStepM = 20;
     },
     PackingEnd::Alarm, marksLost | pitchWrong | atLimit},
    {"product longer than the bag", 250, [](PackingJob& job) { job.machine.products.lengthMm = 260; },
     PackingEnd::Alarm, tooLong},
    {"product that leaves no clearance", 250, [](PackingJob& job) { job.machine.products.lengthMm = 245; },
     PackingEnd::Alarm, tooLong},
    {"products anywhere", 250,
     [](PackingJob& job) {
         job.machine.products.misplaced = 1;
         set16(job, CTL_REG_PARAMETER_SKIP_LIMIT, 2);
     },
     PackingEnd::Alarm, tooManySkips},
    {"sensor farther than the buffer", 100,
     [](PackingJob& job) { set32(job, CTL_REG_PARAMETER_MARK_DISTANCE, 5'000'000); }, PackingEnd::Refused,
     CTL_REFUSAL_SENSOR_TOO_FAR},
    {"window of half a bag", 100, [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_MARK_WINDOW, 30'000); },
     PackingEnd::Refused, CTL_REFUSAL_MARK_WINDOW_TOO_WIDE},
    {"other prints ignored up to the next mark", 250,
     [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_MARK_MASKING, 2440); }, PackingEnd::Refused,
     CTL_REFUSAL_MARK_MASKING_TOO_LONG},
    {"no mark is that wide", 250,
     [](PackingJob& job) {
         set16(job, CTL_REG_PARAMETER_MARK_WIDTH_MIN, 6000);
         set16(job, CTL_REG_PARAMETER_MARK_WIDTH_MAX, 5000);
     },
     PackingEnd::Refused, CTL_REFUSAL_NO_MARK_WIDTH_ALLOWED},
    {"jaws that end at the cut", 250,
     [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_JAWS_BEFORE, 2500); }, PackingEnd::Refused,
     CTL_REFUSAL_JAWS_EXCLUDE_CUT},
    {"jaws that begin at the cut", 250,
     [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_JAWS_BEHIND, 2500); }, PackingEnd::Refused,
     CTL_REFUSAL_JAWS_EXCLUDE_CUT},
    {"jaws of more than a quarter turn", 250,
     [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_JAWS_BEFORE, 9001); }, PackingEnd::BadParameter,
     CTL_REG_PARAMETER_JAWS_BEFORE},
    {"a mark sensor that is 50 ms late", 250,
     [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_MARK_DEAD_TIME, 50'000); }, PackingEnd::BadParameter,
     CTL_REG_PARAMETER_MARK_DEAD_TIME},
    {"an eye that is 50 ms late", 250,
     [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_EYE_DEAD_TIME, 50'000); }, PackingEnd::BadParameter,
     CTL_REG_PARAMETER_EYE_DEAD_TIME},
    {"marks narrower than the minimum", 250,
     [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_MARK_WIDTH_MIN, 6000); }, PackingEnd::Alarm,
     marksLost},
    {"marks wider than the maximum", 250,
     [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_MARK_WIDTH_MAX, 4000); }, PackingEnd::Alarm,
     marksLost},
    {"products that hang together", 250,
     [](PackingJob& job) {
         job.machine.products.lengthMm = 60;
         job.machine.products.joined = 0.05;
         set16(job, CTL_REG_PARAMETER_PRODUCT_LENGTH_MAX, 700);
     },
     PackingEnd::Alarm, joined},
    {"eye beside the film", 250, [](PackingJob& job) { set32(job, CTL_REG_PARAMETER_EYE_DISTANCE, 20'000); },
     PackingEnd::Refused, CTL_REFUSAL_EYE_TOO_NEAR},
    {"parameter out of its range", 250,
     [](PackingJob& job) { set16(job, CTL_REG_PARAMETER_CUT_CLEARANCE, 65'000); }, PackingEnd::BadParameter,
     CTL_REG_PARAMETER_CUT_CLEARANCE},
};

} // namespace

class TestPackingTrouble : public QObject {
    Q_OBJECT

private slots:
    void endsAsItShould_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < std::size(troubles); ++i)
            QTest::newRow(troubles[i].name) << static_cast<int>(i);
    }
    void endsAsItShould()
    {
        QFETCH(int, index);
        const Trouble& trouble = troubles[index];
        const Packed packed = pack(cutterAt(trouble.lengthMm, 60), 5000, trouble.make);
        QCOMPARE(packed.result.end, trouble.end);
        if (trouble.end == PackingEnd::Alarm)
            QVERIFY2((packed.result.detail & trouble.expected) != 0,
                     qPrintable(QString::number(packed.result.detail, 16)));
        else
            QCOMPARE(packed.result.detail, trouble.expected);
        QVERIFY(!packed.anyThroughProduct());
    }

    // The operator restarts repeatedly: still no product is cut.
    void goesOnUnharmed_data() { endsAsItShould_data(); }
    void goesOnUnharmed()
    {
        QFETCH(int, index);
        const Trouble& trouble = troubles[index];
        if (trouble.end != PackingEnd::Alarm)
            return;
        const Packed packed = pack(cutterAt(trouble.lengthMm, 60), 500, [&trouble](PackingJob& job) {
            trouble.make(job);
            job.goOn = true;
        });
        QVERIFY(packed.result.starts > 1);
        QVERIFY(!packed.anyThroughProduct());
    }

    // The sealing window takes nearly the whole cycle: no time is left to correct the film.
    void noRoomToCorrect()
    {
        program::ProgramImage image = cutterAt(250, 20);
        program::Recipe recipe = image.recipe;
        recipe.cutter().k = {40, 25, 1.04, 1.02};
        auto tight = program::buildProgram(recipe);
        QVERIFY(tight.has_value());
        const Packed packed = pack(*tight, 10);
        QCOMPARE(packed.result.end, PackingEnd::Refused);
        QCOMPARE(packed.result.detail, std::uint32_t{CTL_REFUSAL_NO_ROOM_TO_CORRECT});
    }

    // A jump of a mark as large as the window, at any place in a bag: the marks are followed, or lost with an
    // alarm. No cut may be reported as tracked when it is not.
    void marksOnTheWindowsEdge()
    {
        const program::ProgramImage image = cutterAt(250, 60);
        int followed = 0;
        for (int part = 0; part < 20; ++part) {
            for (const std::uint16_t windowUm :
                 {std::uint16_t{2499}, std::uint16_t{2500}, std::uint16_t{2501}}) {
                const Packed packed = pack(image, 120, [&](PackingJob& job) {
                    job.machine.film.slipMm = 0;
                    job.machine.film.stretch = 0;
                    job.machine.film.markNoiseMm = 0;
                    job.machine.film.stretchStep = 0.01;
                    job.machine.film.stretchStepM = 12 + part * 0.0125;
                    set16(job, CTL_REG_PARAMETER_MARK_WINDOW, windowUm);
                });
                QVERIFY(!packed.anyThroughProduct());
                const bool done = packed.result.end == PackingEnd::Done;
                QVERIFY(done || (packed.result.end == PackingEnd::Alarm &&
                                 (packed.result.detail & (marksLost | pitchWrong)) != 0));
                if (done)
                    QVERIFY(std::abs(packed.bags.back().markErrorMm) < 0.2);
                followed += done ? 1 : 0;
            }
        }
        QVERIFY(followed > 0);
    }

    // Too many skips, then a restart: the bag has all of its lengths, from both starts.
    void bagAcrossTwoStarts()
    {
        const Packed packed = pack(cutterAt(250, 60), 2000, [](PackingJob& job) {
            job.machine.products.misplaced = 0.5;
            set16(job, CTL_REG_PARAMETER_SKIP_LIMIT, 2);
            job.goOn = true;
        });
        QCOMPARE(packed.result.end, PackingEnd::Done);
        QVERIFY(packed.result.alarms[CTL_WARNING_BIT_TOO_MANY_SKIPS] > 5);
        QVERIFY(!packed.anyThroughProduct());
        QCOMPARE(packed.result.skipsUnexplained, 0u);
        for (const PackedBag& bag : packed.bags)
            QVERIFY2(std::abs(bag.deviationMm) < 5, qPrintable(QString::number(bag.number)));
    }

    // Nothing comes, and the film is saved: it stands still, and the run reports it.
    void noProductsAtAll()
    {
        const Packed packed = pack(cutterAt(250, 60), 100, [](PackingJob& job) {
            job.machine.products.missing = 1;
            set16(job, CTL_REG_PARAMETER_EMPTY_BAG, 1);
        });
        QCOMPARE(packed.result.end, PackingEnd::NoBags);
        QVERIFY(packed.bags.size() < 10);
    }
};

CAMPANEL_TEST(TestPackingTrouble)

} // namespace test_packing_trouble

#include "test_packing_trouble.moc"
