// SPDX-License-Identifier: Apache-2.0
// When pulses leave: the ticks that the port is given against the definition, tick by tick, for every engine;
// and of the whole controller against its table, with a full line, seals and saves beside it.
#include "engine/ctl_count.h"
#include "engine/ctl_step.h"
#include "engine/ctl_table.h"
#include "rig.h"
#include "tests/support/cam_image.h"
#include "tests/support/interval_image.h"
#include "tests/support/press_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <functional>
#include <memory>
#include <random>

namespace test_pulse_trains {

using namespace campanel::test;

namespace {

__extension__ typedef unsigned __int128 Wide; // products that must not be rounded

struct Pulse {
    std::uint32_t tick = 0;
    std::int32_t direction = 0;
    bool operator==(const Pulse&) const = default;
};
using Pulses = std::vector<Pulse>;

// Appends what a port is given.
void append(Pulses& pulses, const ctl_train& train)
{
    for (ctl_train left = train; left.count != 0;) {
        const std::int32_t direction = left.direction;
        pulses.push_back({ctl_train_next(&left), direction});
    }
}

ctl_port portInto(Pulses& pulses)
{
    ctl_port port{};
    port.context = &pulses;
    port.pulses = [](void* context, const ctl_train* train) {
        append(*static_cast<Pulses*>(context), *train);
    };
    return port;
}

std::unique_ptr<ctl_bank> bankOf(const std::vector<std::uint16_t>& registers)
{
    auto bank = std::make_unique<ctl_bank>();
    std::ranges::copy(registers, bank->registers);
    return bank;
}

// A table at full speed; time passes as ctl_motion lets it pass.
class Follower {
public:
    explicit Follower(const ctl_bank& bank)
        : m_port(portInto(pulses))
    {
        ctl_table_init(&m_table, &m_config);
        ctl_table_reset(&m_table, &bank);
    }

    void pass(std::uint32_t ticks)
    {
        while (ticks != 0) {
            const std::uint32_t part = std::min(ticks, ctl_table_longest_pass(&m_table));
            ctl_pace pace{&m_port, m_tick, part, part};
            const ctl_pace whole = pace;
            while (pace.travel != 0) {
                if (ctl_table_between_cycles(&m_table))
                    ctl_table_begin_cycle(&m_table, 1);
                std::uint32_t used = pace.travel;
                count += ctl_table_advance(&m_table, 1, &used, &pace);
                ctl_pace_take(&pace, used, used);
            }
            count += ctl_table_pass(&m_table, part, &whole);
            m_tick += part;
            ticks -= part;
        }
    }

    Pulses pulses;
    std::int64_t count = 0;

private:
    ctl_config m_config = benchConfig();
    ctl_table m_table{};
    ctl_port m_port;
    std::uint32_t m_tick = 0xFFFFF000u; // the count of ticks wraps in each run
};

} // namespace

class TestPulseTrains : public QObject {
    Q_OBJECT

private slots:
    void trainsFollowTheirDefinition();
    void slowMasterStretchesThem();
    void slowMasterKeepsThemInTheirSlice();
    void portionsDoNotMatter_data();
    void portionsDoNotMatter();
    void countedRunTellsEachTick();
    void pulsesLeaveWithinTheirSlice();
    void runningCutterKeepsItsTable();
};

// Row: floor(j * ticks / count). Line: the first tick at which the axis is there.
void TestPulseTrains::trainsFollowTheirDefinition()
{
    constexpr std::uint64_t seed = 61;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (int i = 0; i < 3000; ++i) {
        const auto ticks = static_cast<std::uint32_t>(1 + random() % 20'000);
        const auto number = static_cast<std::uint32_t>(random() % 60);
        Pulses row;
        append(row, ctl_train_even(number, ticks));
        QCOMPARE(row.size(), std::size_t{number});
        for (std::uint32_t j = 1; j <= number; ++j)
            QCOMPARE(row[j - 1].tick, static_cast<std::uint32_t>(std::uint64_t{j} * ticks / number));

        const std::int64_t from = static_cast<std::int64_t>(random() % 20'000) - 10'000;
        const std::int64_t to = from + static_cast<std::int64_t>(random() % 20'000) - 10'000;
        Pulses expected;
        const auto whole = [from, to, ticks](std::int64_t passed) {
            const std::int64_t way = (to - from) * passed;
            const std::int64_t exact = from * ticks + way; // 1/256 pulse, times ticks
            const std::int64_t unit = std::int64_t{256} * ticks;
            return exact / unit - (exact % unit < 0 ? 1 : 0);
        };
        for (std::int64_t tick = 1; tick <= ticks; ++tick) {
            const std::int64_t moved = whole(tick) - whole(tick - 1);
            for (std::int64_t j = 0; j < std::abs(moved); ++j)
                expected.push_back({static_cast<std::uint32_t>(tick), moved < 0 ? -1 : 1});
        }
        Pulses line;
        append(line, ctl_train_line(from, to, ticks));
        QCOMPARE(line, expected);
    }
}

// Below full speed a pulse leaves at its share of the slice, to one tick.
void TestPulseTrains::slowMasterStretchesThem()
{
    constexpr std::uint64_t seed = 62;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (int i = 0; i < 3000; ++i) {
        const auto ticks = static_cast<std::uint32_t>(2000 + random() % 48'000);
        const auto travel = static_cast<std::uint32_t>(1 + random() % ticks);
        const auto number = static_cast<std::uint32_t>(1 + random() % 60);
        const auto row = static_cast<std::uint32_t>(number + random() % 60'000);
        Pulses pulses;
        const ctl_port port = portInto(pulses);
        const ctl_pace pace{&port, 1000, ticks, travel};
        const ctl_train train = ctl_train_even(number, row);
        ctl_pace_give(&pace, &train);
        QCOMPARE(pulses.size(), std::size_t{number});
        for (std::uint32_t j = 1; j <= number; ++j) {
            const Wide exact = Wide{j} * row * ticks / (Wide{number} * travel);
            const std::int64_t off =
                static_cast<std::int64_t>(pulses[j - 1].tick) - 1000 - static_cast<std::int64_t>(exact);
            QVERIFY2(off >= -1 && off <= 1, qPrintable(QString::number(off)));
        }
    }
}

// A pulse belongs to the slice by its whole tick; what is left of its tick, stretched, may not carry it out.
void TestPulseTrains::slowMasterKeepsThemInTheirSlice()
{
    constexpr std::uint64_t seed = 63;
    constexpr std::uint32_t slice = 2000;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    for (int i = 0; i < 300; ++i) {
        const auto number = static_cast<std::uint32_t>(1 + random() % 200);
        const auto row = static_cast<std::uint32_t>(41 * number + random() % 100'000);
        const auto travel = static_cast<std::uint32_t>(1 + random() % slice);
        Pulses pulses;
        const ctl_port port = portInto(pulses);
        ctl_train left = ctl_train_even(number, row);
        std::uint32_t start = 0;
        for (std::uint32_t passed = 0; passed < row; passed += travel, start += slice) {
            const std::size_t before = pulses.size();
            ctl_train train = ctl_train_until(&left, passed + travel);
            train.tick -= passed;
            const ctl_pace pace{&port, start, slice, travel};
            ctl_pace_give(&pace, &train);
            for (std::size_t j = before; j < pulses.size(); ++j)
                QVERIFY2(pulses[j].tick - start <= slice,
                         qPrintable(QString::number(pulses[j].tick - start)));
        }
        QCOMPARE(pulses.size(), std::size_t{number});
        QVERIFY(std::ranges::is_sorted(pulses, {}, &Pulse::tick));
    }
}

void TestPulseTrains::portionsDoNotMatter_data()
{
    QTest::addColumn<std::vector<std::uint16_t>>("bank");
    std::mt19937_64 random(63);
    for (int i = 0; i < 5; ++i)
        QTest::addRow("step table %d", i) << randomBank(random).registers();
    QTest::newRow("cam points") << sineCam(200.3, 900, 100, 80'000).registers();
    IntervalImage intervals;
    intervals.rows = {{40, 1000, 9000}, {200, 9000, 9000}, {60, 9000, 500}};
    QTest::newRow("intervals") << intervals.registers();
    intervals.backwards = true;
    QTest::newRow("intervals backwards") << intervals.registers();
}

// Tick by tick a pulse leaves at the tick whose call returned it; in any portions the port is given the same.
void TestPulseTrains::portionsDoNotMatter()
{
    constexpr std::uint64_t seed = 64;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    QFETCH(const std::vector<std::uint16_t>, bank);
    const auto program = bankOf(bank);
    constexpr std::uint32_t ticks = 600'000;
    Follower singly(*program);
    Pulses expected;
    for (std::uint32_t tick = 1; tick <= ticks; ++tick) {
        const std::int64_t before = singly.count;
        singly.pass(1);
        const std::int64_t moved = singly.count - before;
        for (std::int64_t j = 0; j < std::abs(moved); ++j)
            expected.push_back({0xFFFFF000u + tick, moved < 0 ? -1 : 1});
    }
    QVERIFY(expected.size() > 3);
    QCOMPARE(singly.pulses, expected);
    Follower inPortions(*program);
    for (std::uint32_t left = ticks; left != 0;) {
        const std::uint32_t part = std::min(left, static_cast<std::uint32_t>(1 + random() % 5000));
        inPortions.pass(part);
        left -= part;
    }
    QCOMPARE(inPortions.pulses, expected);
}

void TestPulseTrains::countedRunTellsEachTick()
{
    const ctl_count_speed speed{8'000'000, 20'000, 20};
    ctl_count singly{};
    ctl_count_start(&singly, speed, 3000);
    Pulses expected;
    std::uint32_t tick = 0;
    while (!ctl_count_done(&singly)) {
        ++tick;
        if (ctl_count_advance(&singly, 1, -1, nullptr) != 0)
            expected.push_back({tick, -1});
    }
    Pulses pulses;
    const ctl_port port = portInto(pulses);
    ctl_count run{};
    ctl_count_start(&run, speed, 3000);
    for (std::uint32_t start = 0; !ctl_count_done(&run); start += 2000) {
        const ctl_pace pace{&port, start, 2000, 2000};
        ctl_count_advance(&run, 2000, -1, &pace);
    }
    QCOMPARE(pulses, expected);
}

namespace {

// Hears what the simulated machine is given.
class Listener {
public:
    explicit Listener(Rig& rig)
        : m_rig(rig)
    {
        rig.controller().onPulses = [this](const ctl_train& train) { hear(train); };
    }
    ~Listener() { m_rig.controller().onPulses = {}; }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    std::function<void(std::uint32_t)> heard;
    int outside = 0;    // pulses outside their slice
    int disordered = 0; // pulses before the one before
    int pulses = 0;

private:
    void hear(ctl_train train)
    {
        const ctl_board& board = m_rig.core().board;
        while (train.count != 0) {
            const std::uint32_t tick = ctl_train_next(&train);
            outside += tick - board.tick > board.slice_ticks ? 1 : 0;
            disordered += pulses != 0 && static_cast<std::int32_t>(tick - m_last) < 0 ? 1 : 0;
            m_last = tick;
            ++pulses;
            if (heard)
                heard(tick);
        }
    }

    Rig& m_rig;
    std::uint32_t m_last = 0;
};

BankImage cutterBank()
{
    return camBank(10'001, 3, 1'600'000, 400);
}

} // namespace

// Homing, ramps, jogging, stops and a change of program: everything lies in its slice, in the order of time.
void TestPulseTrains::pulsesLeaveWithinTheirSlice()
{
    Rig rig;
    rig.core().board.tick = 0xFFFF0000u; // the count of ticks wraps on the way
    Listener listener(rig);
    rig.install(cutterBank());
    rig.start();
    rig.run(2'000'000);
    const Registers other = camBank(10'001, 3, 2'000'000, 400).registers();
    QCOMPARE(rig.download(other), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(other, CTL_APPLY_MODE_NEXT_CYCLE), CTL_REFUSAL_NONE);
    rig.run(3'000'000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    for (const unsigned key : {1u, 2u}) {
        for (int i = 0; i < 10; ++i) {
            rig.heartbeat(static_cast<std::uint16_t>(key));
            rig.run(50'000);
        }
        rig.heartbeat();
        rig.run(500'000);
    }
    rig.start();
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.install(quinticMove(5000, 100, 4'000'000).registers(), 2);
    rig.start();
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.install(trapezoidMove().registers(), 3);
    rig.start();
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.install(PressImage{}.registers(), 4);
    rig.start();
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QVERIFY(listener.pulses > 100'000);
    QCOMPARE(listener.outside, 0);
    QCOMPARE(listener.disordered, 0);
}

// At full speed each pulse of the knife leaves at the tick that ctl_step_next() says, while the line asks
// without a pause, a program is downloaded and sealed in pieces, and one is saved.
void TestPulseTrains::runningCutterKeepsItsTable()
{
    Rig rig;
    rig.core().board.config.work_registers = 48;
    Listener listener(rig);
    rig.setParameter(CTL_REG_PARAMETER_MARK_TRACKING, 0);
    rig.setParameter(CTL_REG_PARAMETER_ANTI_CUT, 0);
    const BankImage bank = cutterBank();
    rig.install(bank);
    rig.start();
    const ctl_motion& motion = rig.core().motion;
    while (motion.ramp.speed != motion.ramp.full)
        rig.controller().step();
    ctl_step table = motion.table.step;
    std::uint32_t tick = rig.core().board.tick;
    std::uint64_t compared = 0;
    std::int64_t largest = 0;
    listener.heard = [&](std::uint32_t leaves) {
        ctl_event event{};
        do {
            if (ctl_step_between_cycles(&table))
                ctl_step_begin_cycle(&table);
            event = ctl_step_next(&table);
            tick += event.ticks;
        } while (!event.pulse);
        largest =
            std::max(largest, std::abs(static_cast<std::int64_t>(static_cast<std::int32_t>(leaves - tick))));
        ++compared;
    };
    for (int i = 0; i < 5; ++i) {
        QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(bank.registers())), CTL_REFUSAL_NONE);
        QCOMPARE(rig.download(bank.registers(), static_cast<std::uint16_t>(10 + i)),
                 CTL_TRANSFER_RESULT_ACCEPTED);
        rig.run(1'000'000);
    }
    QVERIFY(compared > 50'000);
    QCOMPARE(largest, std::int64_t{0});
}

CAMPANEL_TEST(TestPulseTrains)

} // namespace test_pulse_trains

#include "test_pulse_trains.moc"
