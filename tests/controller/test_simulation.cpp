// SPDX-License-Identifier: Apache-2.0
// The simulated machine: the same seed gives the same run for any division of time; and its speed.
#include "rig.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QTest>

namespace test_simulation {

using namespace campanel::test;

namespace {

// Returns everything that a run leaves behind.
std::vector<std::int64_t> scenario(std::uint64_t seed, std::uint64_t portionUs)
{
    campanel::controller::MachineOptions options;
    options.seed = seed;
    Rig rig(options);
    rig.install(camBank(10007, 3, 1'600'000));
    rig.command(CTL_COMMAND_START);
    std::vector<std::int64_t> trace;
    const std::uint64_t startUs = rig.controller().nowUs();
    for (std::uint64_t passedUs = 0; passedUs < 20'000'000; passedUs += portionUs) {
        rig.controller().runTo(startUs + passedUs + portionUs);
        if ((passedUs + portionUs) % 1'000'000 != 0)
            continue;
        const ctl_core& core = rig.core();
        trace.insert(trace.end(), {core.motion.commanded, core.motion.actual, core.motion.cycle_count,
                                   core.bags.count, core.bags.length_um, core.motion.actual_hz});
    }
    return trace;
}

} // namespace

class TestSimulation : public QObject {
    Q_OBJECT

private slots:
    void sameSeedSameRun();
    void fasterThanRealTime();
};

void TestSimulation::sameSeedSameRun()
{
    const auto once = scenario(1, 250);
    QCOMPARE(once.size(), std::size_t{20 * 6});
    QVERIFY(scenario(1, 20'000) == once);
    QVERIFY(scenario(1, 1'000'000) == once);
    QVERIFY(scenario(2, 20'000) != once);
}

void TestSimulation::fasterThanRealTime()
{
    Rig rig;
    rig.install(camBank(10000, 1, 8'000'000));
    rig.command(CTL_COMMAND_START);
    QElapsedTimer timer;
    timer.start();
    constexpr int seconds = 200;
    rig.run(seconds * 1'000'000ull);
    const double factor = seconds * 1e9 / static_cast<double>(timer.nsecsElapsed());
    qInfo("%.0f simulated seconds a second; ctl_core takes %zu bytes", factor, sizeof(ctl_core));
    QVERIFY(factor > 20.0);
}

CAMPANEL_TEST(TestSimulation)

} // namespace test_simulation

#include "test_simulation.moc"
