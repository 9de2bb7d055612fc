// SPDX-License-Identifier: Apache-2.0
// The separate parts of a packing machine's line: gate, feed, marks, products.
#include "ctl_registers.h"
#include "packer/ctl_feed.h"
#include "packer/ctl_gate.h"
#include "packer/ctl_marks.h"
#include "packer/ctl_phase.h"
#include "packer/ctl_products.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cstdlib>
#include <random>

namespace test_packing_parts {

namespace {

constexpr std::int64_t bag = 400'000; // 1/256 pulse
constexpr std::int64_t sensor = 4 * bag + 1234;

ctl_mark_settings markSettings()
{
    ctl_mark_settings settings{};
    settings.nominal = bag;
    settings.distance = sensor;
    settings.window = 10'000;
    settings.jump = 1000;
    settings.max_difference = bag / 50;
    settings.phase_gain = 250;
    settings.length_gain = 100;
    settings.missing_limit = 3;
    return settings;
}

// Returns marks after two of them, a bag apart, the second one at 2 bags.
ctl_marks followingMarks()
{
    ctl_marks marks{};
    const ctl_mark_settings settings = markSettings();
    ctl_marks_search(&marks, &settings, 0);
    ctl_marks_see(&marks, bag);
    ctl_marks_see(&marks, 2 * bag);
    return marks;
}

const ctl_mark& newest(const ctl_marks& marks)
{
    return *ctl_marks_waiting(&marks, marks.count - 1);
}

ctl_product_settings productSettings()
{
    ctl_product_settings settings{};
    settings.flight = 1'000'000;
    settings.lay = 500'000;
    settings.eye = 2'000'000;
    settings.ratio = 1u << 20; // as much film as infeed
    settings.distance = 3 * bag + bag / 2;
    return settings;
}

// Passes product `number` under the eye, `behind` its place.
void passEye(ctl_products& products, std::int64_t number, std::int64_t behind, std::int64_t length)
{
    const ctl_product_settings& settings = products.settings;
    const std::int64_t middle = number * settings.flight + settings.lay - settings.eye + behind;
    ctl_products_edge(&products, middle - length / 2, true);
    ctl_products_edge(&products, middle + length / 2, false);
}

} // namespace

class TestPackingParts : public QObject {
    Q_OBJECT

private slots:
    void gateLagsByWholeCyclesAndIsNeverSlowInTheWindow();
    void gateStandsAtTheBoundary();
    void gateIsCutInAnyPieces();
    void feedIsExactOverManyCycles();
    void correctionHasNoStep();
    void shiftIsWithinOneLimit_data();
    void shiftIsWithinOneLimit();
    void shiftMovesFilmAndPlan();
    void marksAreFoundAndReckonedBack();
    void errorIsDividedBetweenSlipAndLength();
    void jumpIsBelievedAtOnce();
    void edgeOfTheWindowBelongsToIt();
    void falseMarksChangeNothing();
    void printsBehindAMarkAreMasked();
    void missingMarksAreReckonedUntilTooMany();
    void filmThatDoesNotFit();
    void noMarksAtAll();
    void taughtPitchAndScatter();
    void productsLieWhereTheyWereSeen();
    void missingProductIsKnownInTime();
    void acrossMeansWithClearance();
};

// Any window, pieces and answers. Seeds are fixed; the message contains the failing one.
void TestPackingParts::gateLagsByWholeCyclesAndIsNeverSlowInTheWindow()
{
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        std::mt19937 random(seed);
        const auto pick = [&random](std::uint32_t from, std::uint32_t to) {
            return std::uniform_int_distribution<std::uint32_t>(from, to)(random);
        };
        const std::uint32_t cycle = pick(1000, 400'000'000);
        const std::uint32_t engage = pick(cycle / 40, cycle / 2);
        const std::uint32_t release = pick(engage + cycle / 40, cycle - cycle / 40);
        ctl_gate gate{};
        ctl_gate_reset(&gate, cycle, engage, release);
        std::uint64_t driver = 0;
        std::uint64_t own = 0;
        std::uint64_t waited = 0;
        while (driver < 40ull * cycle) {
            if (ctl_gate_asks(&gate)) {
                const bool wait = pick(0, 2) == 0;
                ctl_gate_answer(&gate, wait);
                waited += wait ? 1 : 0;
            }
            const std::uint32_t piece = ctl_gate_piece(&gate);
            QVERIFY2(piece > 0, qPrintable(QString::number(seed)));
            const std::uint32_t ticks = std::min(piece, pick(1, cycle / 50));
            const bool inWindow = gate.phase >= engage && gate.phase < release;
            const std::uint32_t travelled = ctl_gate_advance(&gate, ticks);
            QVERIFY2(!inWindow || travelled == ticks, qPrintable(QString::number(seed)));
            QVERIFY2(travelled <= ticks + 1, qPrintable(QString::number(seed)));
            driver += ticks;
            own += travelled;
            QCOMPARE(own % cycle, std::uint64_t{gate.phase % cycle});
            if (gate.state == CTL_GATE_STATE_RUNNING)
                QVERIFY2(driver - own == waited * cycle, qPrintable(QString::number(seed)));
        }
        QVERIFY2(waited > 0, qPrintable(QString::number(seed)));
    }
}

void TestPackingParts::gateStandsAtTheBoundary()
{
    ctl_gate gate{};
    ctl_gate_reset(&gate, 1000, 400, 600);
    QCOMPARE(ctl_gate_advance(&gate, ctl_gate_piece(&gate)), 600u);
    QVERIFY(ctl_gate_asks(&gate));
    ctl_gate_answer(&gate, true);
    QCOMPARE(gate.state, CTL_GATE_STATE_SLOWING);
    QCOMPARE(ctl_gate_piece(&gate), 800u);
    QCOMPARE(ctl_gate_advance(&gate, 800), 400u);
    QCOMPARE(gate.state, CTL_GATE_STATE_STANDING);
    QCOMPARE(gate.phase, 0u);
    QCOMPARE(ctl_gate_piece(&gate), 200u);
    QCOMPARE(ctl_gate_advance(&gate, 200), 0u);
    ctl_gate_answer(&gate, true);
    QCOMPARE(ctl_gate_piece(&gate), 1000u);
    QCOMPARE(ctl_gate_advance(&gate, 1000), 0u);
    ctl_gate_answer(&gate, false);
    QCOMPARE(gate.state, CTL_GATE_STATE_CATCHING_UP);
    QCOMPARE(ctl_gate_advance(&gate, 800), 400u);
    // 600 + 800 + 200 + 1000 + 800 of the driver are 3400: two cycles and 400 were skipped.
    QCOMPARE(gate.state, CTL_GATE_STATE_RUNNING);
    QCOMPARE(gate.phase, 400u);
}

void TestPackingParts::gateIsCutInAnyPieces()
{
    ctl_gate whole{};
    ctl_gate_reset(&whole, 8'000'000, 3'200'000, 4'800'000);
    ctl_gate_advance(&whole, 4'800'000);
    ctl_gate_answer(&whole, true);
    ctl_gate pieces = whole;
    std::uint32_t travelled = 0;
    for (std::uint32_t at = 0; at < 6'000'000; at += 2000) {
        travelled += ctl_gate_advance(&pieces, 2000);
        ctl_gate once = whole;
        QCOMPARE(ctl_gate_advance(&once, at + 2000), travelled);
    }
    // Half way through the ramp: x - x^3 + x^4 / 2 at 1/2 is 13/32 of 2 a.
    ctl_gate half = whole;
    QCOMPARE(ctl_gate_advance(&half, 3'200'000), 6'400'000u / 32u * 13u);
}

void TestPackingParts::feedIsExactOverManyCycles()
{
    ctl_feed feed{};
    ctl_feed_reset(&feed, 999'983, 77, 1'706'667);
    std::int64_t corrected = 0;
    for (int i = 0; i < 1000; ++i) {
        ctl_feed_advance(&feed, 600'000, 1'706'667);
        ctl_feed_correct(&feed, i % 7 - 3, 700'000);
        corrected += i % 7 - 3;
        ctl_feed_advance(&feed, 399'983, 1'706'667);
        ctl_feed_advance(&feed, 300'017, 1'706'667);
        QCOMPARE(feed.span, 0u);
        QCOMPARE(ctl_feed_position(&feed) - static_cast<std::int64_t>(300'017ull * 1'706'667 / 999'983),
                 77 + std::int64_t{1'706'667} * (i + 1) + corrected);
        ctl_feed_reset(&feed, 999'983, feed.start, 1'706'667);
    }
}

void TestPackingParts::shiftIsWithinOneLimit_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<qint64>("wanted");
    QTest::addColumn<qint64>("length");
    QTest::addColumn<qint64>("shift");
    QTest::addColumn<qint64>("step");
    QTest::addColumn<bool>("reaches"); // the step
    const auto row = [](const char* name, ctl_phase_mode mode, qint64 wanted, qint64 length, qint64 shift,
                        qint64 step, bool reaches) {
        QTest::newRow(name) << static_cast<int>(mode) << wanted << length << shift << step << reaches;
    };
    row("none", CTL_PHASE_LIMITED, 0, 0, 0, 0, true);
    row("within", CTL_PHASE_LIMITED, 700, 300, 700, 400, true);
    row("at the limit", CTL_PHASE_LIMITED, 500, 0, 500, 500, true);
    row("beyond", CTL_PHASE_LIMITED, 501, 0, 500, 500, false);
    row("beyond, backwards", CTL_PHASE_LIMITED, -9000, 0, -500, -500, false);
    row("length at its limit", CTL_PHASE_LIMITED, 1400, 5000, 1400, 400, true);
    row("length against it", CTL_PHASE_LIMITED, 0, -5000, -500, 500, false);
    row("fast", CTL_PHASE_FAST, 9999, 0, 9999, 9999, false);
    row("too fast", CTL_PHASE_FAST, 30'000, 0, 10'000, 10'000, false);
    row("fast and short", CTL_PHASE_FAST_AND_SHORT, 30'000, 0, 5000, 5000, false);
}

void TestPackingParts::shiftIsWithinOneLimit()
{
    QFETCH(int, mode);
    QFETCH(qint64, wanted);
    QFETCH(qint64, length);
    const auto how = static_cast<ctl_phase_mode>(mode);
    const ctl_phase_limits limits{100'000, 1000, 500};
    ctl_phase phase{};
    phase.limited_in_row = 3;
    QTEST(static_cast<qint64>(ctl_phase_allow(&phase, &limits, how, wanted, length)), "shift");
    QTEST(static_cast<qint64>(phase.step), "step");
    QTEST(ctl_phase_reaches(&limits, wanted, length), "reaches");
    QVERIFY(std::abs(phase.step + phase.length) <= ctl_phase_max(&limits, how));
    const bool isLimited = phase.step + phase.length != wanted && how == CTL_PHASE_LIMITED;
    QCOMPARE(phase.limited, isLimited ? 1u : 0u);
    QCOMPARE(phase.limited_in_row, isLimited ? 4u : 0u);
}

void TestPackingParts::shiftMovesFilmAndPlan()
{
    ctl_feed feed{};
    ctl_feed_reset(&feed, 1'000'000, 0, 1'000'000);
    std::int64_t command = 900'000;
    ctl_phase_move(&feed, &command, -700, 800'000);
    QCOMPARE(command, 899'300);
    ctl_feed_advance(&feed, 900'000, 1'000'000);
    QCOMPARE(ctl_feed_position(&feed), command);
}

void TestPackingParts::correctionHasNoStep()
{
    ctl_feed feed{};
    ctl_feed_reset(&feed, 1'000'000, 0, 1'000'000);
    ctl_feed_correct(&feed, -100'000, 800'000);
    std::int64_t before = 0;
    std::int64_t speedBefore = 1000;
    for (int i = 0; i < 900; ++i) {
        ctl_feed_advance(&feed, 1000, 1'000'000);
        const std::int64_t speed = ctl_feed_position(&feed) - before;
        before += speed;
        // The largest slope of 3 x^2 - 2 x^3 is 1.5, of its slope 6.
        QVERIFY(speed <= 1001 && speed >= 1000 - 188 - 1);
        QVERIFY(std::abs(speed - speedBefore) <= 3);
        speedBefore = speed;
    }
    QCOMPARE(before, 900'000 - 100'000);
}

void TestPackingParts::marksAreFoundAndReckonedBack()
{
    const ctl_marks marks = followingMarks();
    QCOMPARE(marks.state, CTL_MARK_STATE_ALIGNING);
    QCOMPARE(newest(marks).at, 2 * bag + sensor);
    QVERIFY(newest(marks).seen);
    // Those between sensor and knife had passed before the start.
    QCOMPARE(marks.count, 5u);
    for (std::uint32_t i = 0; i < 4; ++i) {
        QCOMPARE(ctl_marks_waiting(&marks, i)->at, newest(marks).at - (4 - i) * bag);
        QVERIFY(!ctl_marks_waiting(&marks, i)->seen);
    }
}

void TestPackingParts::errorIsDividedBetweenSlipAndLength()
{
    ctl_marks marks = followingMarks();
    const std::int64_t first = ctl_marks_waiting(&marks, 0)->at;
    ctl_marks_see(&marks, 3 * bag + 800);
    QCOMPARE(marks.error, 800);
    QCOMPARE(ctl_marks_waiting(&marks, 0)->at, first + 200); // a quarter is slip: all are at other places
    QCOMPARE(newest(marks).at, 3 * bag + 200 + sensor);
    QCOMPARE(marks.pitch, bag + 80); // a tenth is length
    QCOMPARE(marks.expected, 4 * bag + 200 + 80);
}

void TestPackingParts::jumpIsBelievedAtOnce()
{
    ctl_marks marks = followingMarks();
    const std::int64_t first = ctl_marks_waiting(&marks, 0)->at;
    ctl_marks_see(&marks, 3 * bag + 4000); // 1 % more stretch
    QCOMPARE(ctl_marks_waiting(&marks, 0)->at, first);
    QCOMPARE(newest(marks).at, 3 * bag + 4000 + sensor);
    QCOMPARE(marks.pitch, bag + 4000);
    ctl_marks_see(&marks, 4 * bag + 8000);
    QCOMPARE(marks.error, 0);
}

void TestPackingParts::edgeOfTheWindowBelongsToIt()
{
    for (const std::int64_t side : {-1, 1}) {
        ctl_marks marks = followingMarks();
        ctl_marks_see(&marks, 3 * bag + side * 10'000);
        QCOMPARE(marks.followed, 2u);
        QCOMPARE(marks.unexpected, 0u);
        ctl_marks beyond = followingMarks();
        ctl_marks_see(&beyond, 3 * bag + side * 10'001);
        QCOMPARE(beyond.followed, 1u);
        QCOMPARE(beyond.unexpected, 1u);
        // The controller expects the next mark then; the record has the distance from this one's place.
        QCOMPARE(beyond.off, side * 10'001);
    }
}

void TestPackingParts::falseMarksChangeNothing()
{
    ctl_marks marks = followingMarks();
    const ctl_marks before = marks;
    ctl_marks_see(&marks, 2 * bag + 50);
    ctl_marks_see(&marks, 2 * bag + bag / 2);
    QCOMPARE(marks.unexpected, 2u);
    QCOMPARE(marks.expected, before.expected);
    QCOMPARE(marks.count, before.count);
    ctl_marks_see(&marks, 3 * bag);
    ctl_marks_see(&marks, 3 * bag + 30); // the same mark twice
    QCOMPARE(marks.followed, 2u);
    QCOMPARE(marks.unexpected, 3u);
    QCOMPARE(marks.alarm, 0u);
}

// A print behind a mark is ignored up to the masking distance, whatever the state; not the mark that comes
// behind a print that was taken for it.
void TestPackingParts::printsBehindAMarkAreMasked()
{
    ctl_mark_settings settings = markSettings();
    settings.masking = bag / 2;
    ctl_marks marks{};
    ctl_marks_search(&marks, &settings, 0);
    QCOMPARE(ctl_marks_see(&marks, bag), CTL_MARK_VERDICT_SEARCHED);
    QCOMPARE(ctl_marks_see(&marks, bag + bag / 2 - 1), CTL_MARK_VERDICT_MASKED);
    QCOMPARE(ctl_marks_see(&marks, 2 * bag), CTL_MARK_VERDICT_SEARCHED);
    QCOMPARE(ctl_marks_see(&marks, 2 * bag + 1), CTL_MARK_VERDICT_MASKED);
    QCOMPARE(ctl_marks_see(&marks, 2 * bag + bag / 2), CTL_MARK_VERDICT_OUTSIDE_WINDOW);
    QCOMPARE(ctl_marks_see(&marks, 3 * bag - 9000), CTL_MARK_VERDICT_TAKEN);
    QCOMPARE(ctl_marks_see(&marks, 3 * bag), CTL_MARK_VERDICT_TAKEN); // instead of it
    QCOMPARE(ctl_marks_see(&marks, 3 * bag + 50), CTL_MARK_VERDICT_MASKED);
    QCOMPARE(marks.followed, 2u);
    QCOMPARE(marks.unexpected, 2u);
}

void TestPackingParts::missingMarksAreReckonedUntilTooMany()
{
    ctl_marks marks = followingMarks();
    ctl_marks_pass(&marks, 3 * bag + 10'000);
    QCOMPARE(marks.missing, 0u);
    ctl_marks_pass(&marks, 3 * bag + 10'001);
    QCOMPARE(marks.missing, 1u);
    QVERIFY(!newest(marks).seen);
    QCOMPARE(newest(marks).at, 3 * bag + sensor);
    ctl_marks_see(&marks, 4 * bag);
    QCOMPARE(marks.missing_in_row, 0u);
    ctl_marks_pass(&marks, 7 * bag);
    QCOMPARE(marks.alarm, 0u);
    ctl_marks_pass(&marks, 7 * bag + 10'001);
    QCOMPARE(marks.alarm, CTL_WARNING_BIT_MARKS_LOST);
}

void TestPackingParts::filmThatDoesNotFit()
{
    ctl_marks marks{};
    const ctl_mark_settings settings = markSettings();
    ctl_marks_search(&marks, &settings, 0);
    for (int i = 1; i < 20; ++i)
        ctl_marks_see(&marks, i * (bag + bag / 10));
    QCOMPARE(marks.state, CTL_MARK_STATE_SEARCHING);
    QCOMPARE(marks.alarm, CTL_WARNING_BIT_MARK_PITCH_WRONG);
    // Found first, then spliced to another film: marks come, but never at the expected places.
    ctl_marks spliced = followingMarks();
    for (int i = 1; i < 8; ++i)
        ctl_marks_see(&spliced, 2 * bag + bag / 2 + i * bag);
    QCOMPARE(spliced.alarm, CTL_WARNING_BIT_MARK_PITCH_WRONG);
}

void TestPackingParts::noMarksAtAll()
{
    ctl_marks marks{};
    const ctl_mark_settings settings = markSettings();
    ctl_marks_search(&marks, &settings, 500);
    ctl_marks_pass(&marks, 500 + 4 * bag);
    QCOMPARE(marks.alarm, 0u);
    ctl_marks_pass(&marks, 501 + 4 * bag);
    QCOMPARE(marks.alarm, CTL_WARNING_BIT_MARKS_LOST);
}

void TestPackingParts::taughtPitchAndScatter()
{
    ctl_marks marks{};
    ctl_marks_teach(&marks, 4);
    QCOMPARE(ctl_marks_taught_pitch(&marks), 0);
    for (const std::int64_t at : {1000, 11'000, 21'300, 31'000, 99'999})
        ctl_marks_see(&marks, at);
    QCOMPARE(marks.teaching.count, 4u);
    QCOMPARE(ctl_marks_taught_pitch(&marks), 10'000);
    // Gaps of 10000, 10300, 9700.
    QCOMPARE(ctl_marks_taught_variance(&marks), 90'000u);
}

void TestPackingParts::productsLieWhereTheyWereSeen()
{
    ctl_products products{};
    const ctl_product_settings settings = productSettings();
    ctl_products_set(&products, &settings, 1);
    passEye(products, 3, 0, 200'000);
    passEye(products, 4, -30'000, 100'000);
    QCOMPARE(products.longest, 200'000);
    // Laid half-way between two readings, with the film at 5000.
    ctl_products_lay(&products, 3'400'000, 3'600'000, 0, 10'000);
    QCOMPARE(products.laid_count, 1u);
    QCOMPARE(products.laid[0].lead, 5000 + settings.distance - 100'000);
    QCOMPARE(products.laid[0].trail, 5000 + settings.distance + 100'000);
    ctl_products_lay(&products, 4'500'000, 4'500'000, 400'000, 400'000);
    QCOMPARE(products.laid[1].lead, 400'000 + settings.distance - 30'000 - 50'000);
    QCOMPARE(products.total, 2u);
    QCOMPARE(ctl_products_cut(&products, 5000 + settings.distance + 150'000), 1u);
    QCOMPARE(products.laid_count, 1u);
}

void TestPackingParts::missingProductIsKnownInTime()
{
    ctl_products products{};
    const ctl_product_settings settings = productSettings();
    ctl_products_set(&products, &settings, 1);
    // The place of product 3 is at the eye from 1.0 to 2.0 million, that of product 4 up to 3.0.
    QVERIFY(!ctl_products_missing(&products, 3, 1'999'999));
    QVERIFY(ctl_products_missing(&products, 3, 2'000'000));
    // The previous one was already under the eye at the start: unknown.
    QVERIFY(!ctl_products_missing(&products, 1, 2'000'000));
    ctl_products_edge(&products, 2'900'000, true); // begins in its place, ends in the next one's
    QVERIFY(!ctl_products_missing(&products, 4, 3'000'000));
    ctl_products_edge(&products, 3'050'000, false);
    QVERIFY(!ctl_products_missing(&products, 4, 3'050'000));
    ctl_products_lay(&products, 0, 4'600'000, 0, 0);
    QCOMPARE(products.total, 1u); // product 4
}

void TestPackingParts::acrossMeansWithClearance()
{
    ctl_products products{};
    const ctl_product_settings settings = productSettings();
    ctl_products_set(&products, &settings, 0);
    passEye(products, 3, 0, 200'000);
    ctl_products_lay(&products, 3'500'000, 3'500'000, 0, 0);
    const std::int64_t middle = settings.distance;
    QVERIFY(ctl_products_across(&products, middle, 0));
    QVERIFY(ctl_products_across(&products, middle + 104'999, 5000));
    QVERIFY(!ctl_products_across(&products, middle + 105'000, 5000));
    QVERIFY(!ctl_products_across(&products, middle - 105'000, 5000));
    QVERIFY(ctl_products_across(&products, middle - 104'999, 5000));
}

CAMPANEL_TEST(TestPackingParts)

} // namespace test_packing_parts

#include "test_packing_parts.moc"
