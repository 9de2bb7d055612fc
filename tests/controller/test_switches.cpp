// SPDX-License-Identifier: Apache-2.0
// The cam switches: their angles and leads at any speed, every n-th cycle, bags to reject, refused leads.
#include "rig.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numeric>

namespace test_switches {

using namespace campanel::test;

namespace {

constexpr std::uint64_t second = 1'000'000;
constexpr std::uint32_t slow = 8'000'000; // 60 a minute
constexpr std::uint32_t fast = 1'600'000; // 300 a minute

struct Setting {
    std::uint16_t mode = CTL_SWITCH_MODE_CYCLES;
    std::uint16_t onAngle = 0; // 0.01 degrees
    std::uint16_t offAngle = 0;
    std::uint16_t lead = 0; // 0.1 ms
    std::uint16_t every = 1;
};

void set(Rig& rig, unsigned number, const Setting& setting)
{
    constexpr unsigned stride = CTL_REG_PARAMETER_SWITCH2_MODE - CTL_REG_PARAMETER_SWITCH1_MODE;
    if (rig.write(static_cast<std::uint16_t>(CTL_REG_PARAMETER_SWITCH1_MODE + stride * (number - 1)),
                  {setting.mode, setting.onAngle, setting.offAngle, setting.lead, setting.every}) != 0)
        throw std::runtime_error("the setting was refused");
}

BankImage cutterOf(std::uint32_t cycleTicks)
{
    return camBank(10000, 1, cycleTicks);
}

unsigned switchLevels(Rig& rig)
{
    return rig.core().io.outputs & ((1u << CTL_SWITCH_COUNT) - 1u);
}

// Follows the levels of the switches from slice to slice.
class Watch {
public:
    struct Edge {
        bool isOn = false;
        double angle = 0.0;  // degrees, in the direction of the cycle, at the end of its slice
        double slice = 0.0;  // degrees that passed in the slice
        double perMs = 0.0;  // present speed, degrees
        bool isEven = false; // the speed was the same for the longest lead
    };

    Watch(Rig& rig, unsigned number)
        : m_rig(rig)
        , m_bit(1u << (number - 1))
    {
        m_angle = angle();
        m_level = level();
    }

    void run(std::uint64_t timeUs)
    {
        const std::uint64_t untilUs = m_rig.controller().nowUs() + timeUs;
        while (m_rig.controller().nowUs() < untilUs)
            step();
    }

    [[nodiscard]] bool level() const { return (m_rig.core().io.outputs & m_bit) != 0; }
    [[nodiscard]] int onEdges() const { return static_cast<int>(std::ranges::count_if(edges, &Edge::isOn)); }

    std::vector<Edge> edges;
    int cycles = 0; // boundaries passed
    // The number of times that it switched on before the cycle was at this angle.
    double onAngle = 0.0;
    int minAhead = 0;
    int maxAhead = 0;

private:
    [[nodiscard]] double angle() const
    {
        const ctl_motion& motion = m_rig.core().motion;
        if (!motion.banks->has_active)
            return 0.0;
        const double ticks =
            ctl_packer_active(motion.packer) ? motion.packer->film.phase : ctl_table_position(&motion.table);
        const double degrees = 360.0 * ticks / ctl_bank_cycle_ticks(motion.table.bank);
        return motion.direction > 0 ? degrees : std::fmod(360.0 - degrees, 360.0);
    }

    void step()
    {
        m_rig.controller().step();
        const double before = std::exchange(m_angle, angle());
        const double passed = std::fmod(m_angle - before + 360.0, 360.0);
        cycles += m_angle < before ? 1 : 0;
        const std::uint32_t cycle = ctl_bank_cycle_ticks(m_rig.core().motion.table.bank);
        const ctl_ramp& ramp = m_rig.core().motion.ramp;
        const double perMs = 360.0 * 8000.0 / cycle * ramp.speed / ramp.full;
        m_even = std::abs(perMs - m_perMs) < 1e-9 ? m_even + 1 : 0;
        m_perMs = perMs;
        m_ahead += !m_level && level() ? 1 : 0;
        m_ahead -= std::fmod(m_angle - onAngle + 360.0, 360.0) < passed ? 1 : 0;
        minAhead = std::min(minAhead, m_ahead);
        maxAhead = std::max(maxAhead, m_ahead);
        if (std::exchange(m_level, level()) != level())
            edges.push_back({level(), m_angle, passed, perMs, m_even > 400});
    }

    Rig& m_rig;
    unsigned m_bit;
    double m_angle = 0.0;
    double m_perMs = 0.0;
    int m_even = 0; // slices
    int m_ahead = 0;
    bool m_level = false;
};

// Returns how far the switch was behind the wanted angle less its lead, in slices; 0 .. 1 within the slice.
double slicesLate(const Watch::Edge& edge, const Setting& setting)
{
    const double wanted = (edge.isOn ? setting.onAngle : setting.offAngle) / 100.0;
    const double late = edge.angle - wanted + setting.lead / 10.0 * edge.perMs;
    return std::fmod(late + 720.0, 360.0) / edge.slice;
}

constexpr double rounding = 0.01; // of a slice: angles are whole ticks

} // namespace

class TestSwitches : public QObject {
    Q_OBJECT

private slots:
    void switchWithinOneSlice_data();
    void switchWithinOneSlice();
    void changeOfProgramLosesNone_data();
    void changeOfProgramLosesNone();
    void windowsThatTheLeadJumpsOverAreKept();
    void everyNthCycle();
    void standStillOff();
    void bagsToRejectOnly_data();
    void bagsToRejectOnly();
    void longLeadIsRefused();
};

void TestSwitches::switchWithinOneSlice_data()
{
    QTest::addColumn<bool>("isCutter");
    QTest::addColumn<bool>("isBackward");
    QTest::addColumn<unsigned>("cycleTicks");
    QTest::addColumn<int>("onAngle");
    QTest::addColumn<int>("offAngle");
    QTest::addColumn<int>("lead");
    QTest::newRow("cutter 60/min") << true << false << slow << 9000 << 20000 << 0;
    QTest::newRow("cutter 60/min, 0.1 ms") << true << false << slow << 9000 << 20000 << 1;
    QTest::newRow("cutter 60/min, 100 ms") << true << false << slow << 9000 << 20000 << 1000;
    QTest::newRow("cutter 300/min, 12.3 ms") << true << false << fast << 9000 << 20000 << 123;
    QTest::newRow("cutter 300/min, 100 ms, over the boundary")
        << true << false << fast << 500 << 1000 << 1000;
    QTest::newRow("cutter 300/min, window over the boundary") << true << false << fast << 35000 << 1000 << 50;
    QTest::newRow("narrower than a slice") << true << false << fast << 9000 << 9010 << 0;
    QTest::newRow("point cam 60/min") << false << false << slow << 0 << 100 << 200;
    QTest::newRow("point cam 300/min") << false << false << fast << 27000 << 100 << 1000;
    QTest::newRow("point cam backward") << false << true << fast << 9000 << 20000 << 123;
}

void TestSwitches::switchWithinOneSlice()
{
    QFETCH(bool, isCutter);
    QFETCH(bool, isBackward);
    QFETCH(unsigned, cycleTicks);
    QFETCH(int, onAngle);
    QFETCH(int, offAngle);
    QFETCH(int, lead);
    const Setting setting{CTL_SWITCH_MODE_CYCLES, static_cast<std::uint16_t>(onAngle),
                          static_cast<std::uint16_t>(offAngle), static_cast<std::uint16_t>(lead), 1};
    Rig rig;
    rig.install(isCutter ? cutterOf(cycleTicks).registers()
                         : sineCam(0.0, 1000.0, 200, cycleTicks).registers());
    rig.setParameter(CTL_REG_PARAMETER_MASTER_DIRECTION, isBackward ? 1 : 0);
    set(rig, 3, setting);
    rig.start();
    rig.run(3 * second);
    Watch watch(rig, 3);
    watch.run(10 * second);
    // Backward it switches on where it would switch off, and the angles count down.
    Setting met = setting;
    if (isBackward) {
        met.onAngle = static_cast<std::uint16_t>(36000 - setting.offAngle);
        met.offAngle = static_cast<std::uint16_t>(36000 - setting.onAngle);
    }
    QVERIFY2(std::abs(watch.onEdges() - watch.cycles) <= 1, qPrintable(QString::number(watch.onEdges())));
    QVERIFY(watch.onEdges() >= 9);
    for (const Watch::Edge& edge : watch.edges) {
        const double late = slicesLate(edge, met);
        // What is narrower than a slice is on for one.
        const double allowed = offAngle - onAngle == 10 && !edge.isOn ? 2.0 : 1.0;
        QVERIFY2(late < allowed + rounding, qPrintable(QString::number(late)));
    }
}

void TestSwitches::changeOfProgramLosesNone_data()
{
    QTest::addColumn<unsigned>("before");
    QTest::addColumn<unsigned>("after");
    QTest::addColumn<int>("onAngle");
    for (const int onAngle : {500, 4000, 9000, 18000, 34000}) {
        QTest::addRow("faster, %d", onAngle) << slow << fast << onAngle;
        QTest::addRow("slower, %d", onAngle) << fast << slow << onAngle;
    }
}

// The first window behind the change may be late or early by the lead that was not known before; none is lost
// or comes twice.
void TestSwitches::changeOfProgramLosesNone()
{
    QFETCH(unsigned, before);
    QFETCH(unsigned, after);
    QFETCH(int, onAngle);
    const Setting setting{CTL_SWITCH_MODE_CYCLES, static_cast<std::uint16_t>(onAngle),
                          static_cast<std::uint16_t>((onAngle + 2000) % 36000), 500, 1};
    Rig rig;
    rig.install(cutterOf(before));
    set(rig, 1, setting);
    rig.start();
    rig.run(4 * second);
    Watch watch(rig, 1);
    watch.run(3 * second);
    const Registers next = cutterOf(after).registers();
    QCOMPARE(rig.download(next, 2), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(next, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);
    Watch over(rig, 1);
    over.onAngle = onAngle / 100.0;
    over.run(8 * second);
    QCOMPARE(rig.core().banks.active_crc, crc32(next));
    QVERIFY2(std::abs(over.onEdges() - over.cycles) <= 1,
             qPrintable(QString::number(over.onEdges()) + u'/' + QString::number(over.cycles)));
    QVERIFY2(over.maxAhead - over.minAhead <= 1, qPrintable(QString::number(over.maxAhead - over.minAhead)));
    int checked = 0;
    for (const Watch::Edge& edge : over.edges) {
        if (!edge.isEven)
            continue;
        ++checked;
        QVERIFY2(slicesLate(edge, setting) < 1.0 + rounding,
                 qPrintable(QString::number(slicesLate(edge, setting))));
    }
    QVERIFY(checked >= 8);
}

// A point cam without a ramp has its full speed, and its full lead, from one slice to the next.
void TestSwitches::windowsThatTheLeadJumpsOverAreKept()
{
    CamImage cam = sineCam(0.0, 1000.0, 200, fast);
    cam.masterRampMs = 0;
    Rig rig;
    rig.install(cam.registers());
    set(rig, 1, {CTL_SWITCH_MODE_CYCLES, 3000, 6000, 1000, 1}); // 100 ms are 180 degrees
    rig.start();
    Watch watch(rig, 1);
    const bool isOnAtOnce = watch.level();
    watch.run(50'000);
    QVERIFY(isOnAtOnce || !watch.edges.empty());
    QCOMPARE(watch.level(), false);
    // 30 degrees are 16.7 ms.
    const double degrees = watch.edges.back().angle - (isOnAtOnce ? 0.0 : watch.edges.front().angle);
    QVERIFY2(degrees >= 30.0 - 0.5 && degrees < 32.0, qPrintable(QString::number(degrees)));
}

void TestSwitches::everyNthCycle()
{
    Rig rig;
    rig.install(cutterOf(fast));
    set(rig, 1, {CTL_SWITCH_MODE_CYCLES, 1000, 2000, 100, 3});
    set(rig, 8, {CTL_SWITCH_MODE_CYCLES, 30000, 31000, 0, 3});
    rig.start();
    rig.run(second);
    for (int run = 0; run < 2; ++run) {
        Watch first(rig, 1);
        std::vector<unsigned> numbers; // of the cycles in which each is on
        std::vector<unsigned> others;
        unsigned last = 0;
        for (const std::uint64_t endUs = rig.controller().nowUs() + 6 * second;
             rig.controller().nowUs() < endUs;) {
            rig.controller().step();
            const unsigned now = rig.core().io.outputs;
            const bool isLate = rig.core().packer.film.phase > fast / 2; // ahead: belongs to the next cycle
            if ((now & ~last & 1u) != 0)
                numbers.push_back(rig.core().io.switches.number + (isLate ? 1 : 0));
            if ((now & ~last & 0x80u) != 0)
                others.push_back(rig.core().io.switches.number);
            last = now;
        }
        QVERIFY(numbers.size() >= 9 && numbers.size() <= 11);
        for (const auto* all : {&numbers, &others}) {
            for (const unsigned number : *all)
                QCOMPARE(number % 3, 0u);
        }
        // They stay in step over a stop in the middle of a cycle.
        QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_READY, 10 * second));
        rig.start();
        rig.run(second);
    }
}

void TestSwitches::standStillOff()
{
    Rig rig;
    rig.install(cutterOf(slow));
    set(rig, 1, {CTL_SWITCH_MODE_CYCLES, 0, 35999, 0, 1});
    set(rig, 2, {CTL_SWITCH_MODE_CYCLES, 9000, 9000, 0, 1}); // never
    set(rig, 4, {CTL_SWITCH_MODE_OFF, 0, 35999, 0, 1});
    QCOMPARE(switchLevels(rig), 0u);
    rig.start();
    rig.run(2 * second);
    QCOMPARE(switchLevels(rig), 1u);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(switchLevels(rig), 0u);
    rig.start(); // in the middle of its window
    rig.run(10'000);
    QCOMPARE(switchLevels(rig), 1u);
    set(rig, 1, {CTL_SWITCH_MODE_OFF, 0, 35999, 0, 1});
    rig.run(1'000);
    QCOMPARE(switchLevels(rig), 0u);
    // A move is no cycle.
    CamImage move = sineCam(2000.0, 0.0, 100, slow);
    move.atEnd = CTL_END_BEHAVIOR_HOLD_SPEED;
    move.kind = CTL_PROGRAM_KIND_SPEED_MOVE;
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.install(move.registers(), 2);
    set(rig, 1, {CTL_SWITCH_MODE_CYCLES, 0, 35999, 0, 1});
    rig.command(CTL_COMMAND_START);
    rig.run(500'000);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(switchLevels(rig), 0u);
}

void TestSwitches::bagsToRejectOnly_data()
{
    QTest::addColumn<unsigned>("cycleTicks");
    QTest::addColumn<bool>("productsMiss");
    QTest::addColumn<int>("changes");
    for (const unsigned cycleTicks : {slow, fast}) {
        const int rate = cycleTicks == slow ? 60 : 300;
        QTest::addRow("power-up, %d/min", rate) << cycleTicks << false << 0;
        QTest::addRow("products missing and misplaced, %d/min", rate) << cycleTicks << true << 0;
        QTest::addRow("changes of program, %d/min", rate) << cycleTicks << false << 6;
    }
}

// The switch is on once for each bag whose record makes it scrap, and for no other, also when the next cut is
// skipped.
void TestSwitches::bagsToRejectOnly()
{
    QFETCH(unsigned, cycleTicks);
    QFETCH(bool, productsMiss);
    QFETCH(int, changes);
    constexpr unsigned bad = 1u << CTL_BAG_BIT_EMPTY | 1u << CTL_BAG_BIT_PRODUCT_ACROSS |
                             1u << CTL_BAG_BIT_START_UP | 1u << CTL_BAG_BIT_CHANGE_OVER;
    campanel::controller::MachineOptions options;
    options.products.missing = productsMiss ? 0.25 : 0.0;
    options.products.misplaced = productsMiss ? 0.1 : 0.0;
    Rig rig(options);
    rig.install(cutterOf(cycleTicks));
    rig.setParameter(CTL_REG_PARAMETER_SKIP_LIMIT, 100);
    set(rig, 5, {CTL_SWITCH_MODE_REJECTED_BAGS, 24000, 33000, 200, 1});
    rig.start();
    const int bags = productsMiss ? 300 : 40 * std::max(changes, 1);
    int rejected = 0;
    int kept = 0;
    int startUp = 0;
    int changeOver = 0;
    int marked = -1; // of the bag cut last; -1: none yet
    int pulses = 0;  // since that cut
    bool before = false;
    std::uint16_t session = 1;
    while (rejected + kept < bags) {
        rig.controller().step();
        const bool isOn = (rig.core().io.outputs & 0x10u) != 0;
        pulses += isOn && !before ? 1 : 0;
        before = isOn;
        const auto& cut = rig.controller().cut();
        if (!cut)
            continue;
        QVERIFY(!isOn); // the window lies between two cuts
        if (marked >= 0)
            QCOMPARE(pulses, marked);
        pulses = 0;
        const ctl_packer& packer = rig.core().packer;
        const unsigned flags = packer.records[CTL_BAG_REGISTERS * (packer.bags % CTL_BAG_RECORDS) + 3];
        const bool isGood = cut->lengthUm && (flags & bad) == 0 && (flags & 1u << CTL_BAG_BIT_TRACKED) != 0;
        QVERIFY(!isGood || !cut->products.empty());
        marked = isGood ? 0 : 1;
        (isGood ? kept : rejected) += 1;
        startUp += cut->lengthUm && (flags & 1u << CTL_BAG_BIT_START_UP) != 0 ? 1 : 0;
        changeOver += (flags & 1u << CTL_BAG_BIT_CHANGE_OVER) != 0 ? 1 : 0;
        if (changes != 0 && (rejected + kept) % 40 == 20) {
            const bool isLonger = session % 2 == 1;
            BankImage next = cutterOf(cycleTicks);
            next.bagLengthUm += isLonger ? 15'000 : 0;
            ++session;
            QCOMPARE(rig.download(next.registers(), session), CTL_TRANSFER_RESULT_ACCEPTED);
            QCOMPARE(rig.apply(next.registers(), CTL_APPLY_MODE_NEXT_CYCLE, session), CTL_REFUSAL_NONE);
        }
    }
    qInfo("%d bags kept, %d rejected: start-up %d, change of program %d", kept, rejected, startUp,
          changeOver);
    QVERIFY(kept > bags / 2);
    QVERIFY(startUp >= 1);
    QCOMPARE(rejected > bags / 6, productsMiss);
    QCOMPARE(changeOver, changes);
}

void TestSwitches::longLeadIsRefused()
{
    const Registers quick = sineCam(0.0, 100.0, 50, 799'992).registers(); // a millionth less than 100 ms
    const Registers even = sineCam(0.0, 100.0, 50, 800'000).registers();
    Rig rig;
    rig.install(quick);
    set(rig, 6, {CTL_SWITCH_MODE_CYCLES, 0, 9000, 1000, 1});
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_SWITCH6_LEAD_TOO_LONG);
    QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
    set(rig, 2, {CTL_SWITCH_MODE_REJECTED_BAGS, 0, 9000, 1000, 1});
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_SWITCH2_LEAD_TOO_LONG);
    set(rig, 2, {CTL_SWITCH_MODE_OFF, 0, 9000, 1000, 1});
    set(rig, 6, {CTL_SWITCH_MODE_CYCLES, 0, 9000, 999, 1});
    rig.start();
    // One that runs may change to it no more.
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.install(even, 2);
    set(rig, 6, {CTL_SWITCH_MODE_CYCLES, 0, 9000, 1000, 1});
    rig.start();
    QCOMPARE(rig.download(quick, 3), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(quick, CTL_APPLY_MODE_NEXT_CYCLE, 3), CTL_REFUSAL_SWITCH6_LEAD_TOO_LONG);
    rig.run(second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    QCOMPARE(rig.core().banks.active_crc, crc32(even));
}

CAMPANEL_TEST(TestSwitches)

} // namespace test_switches

#include "test_switches.moc"
