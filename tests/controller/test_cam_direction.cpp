// SPDX-License-Identifier: Apache-2.0
// The direction of a point cam's master: the sign of its speed in the program, reversed by the parameter.
// Backward, the same rows give the same curve without drift.
#include "rig.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace test_cam_direction {

using namespace campanel::test;

namespace {

constexpr std::uint64_t second = 1'000'000;
constexpr std::int16_t backwards = -600;

} // namespace

class TestCamDirection : public QObject {
    Q_OBJECT

private slots:
    void signAndParameter_data();
    void signAndParameter();
    void backwardsWithoutDrift_data();
    void backwardsWithoutDrift();
    void changeOfSignWhileRunning();
};

void TestCamDirection::signAndParameter_data()
{
    QTest::addColumn<int>("masterRate");
    QTest::addColumn<int>("parameter");
    QTest::addColumn<int>("direction");
    QTest::newRow("forward") << 600 << 0 << 1;
    QTest::newRow("forward, turned round") << 600 << 1 << -1;
    QTest::newRow("backward") << -600 << 0 << -1;
    QTest::newRow("backward, turned round") << -600 << 1 << 1;
    QTest::newRow("slowest backward") << -1 << 0 << -1;
    QTest::newRow("fastest backward") << -10'000 << 0 << -1;
}

void TestCamDirection::signAndParameter()
{
    QFETCH(int, masterRate);
    QFETCH(int, parameter);
    QFETCH(int, direction);
    CamImage cam = sineCam(10'000.0, 800.0, 100, 4'800'000);
    cam.masterRate = static_cast<std::int16_t>(masterRate);
    Rig rig;
    rig.install(cam.registers());
    rig.setParameter(CTL_REG_PARAMETER_MASTER_DIRECTION, static_cast<std::uint16_t>(parameter));
    rig.start();
    std::int64_t before = rig.commanded();
    rig.run(second / 10);
    // From the first pulse: never in the other direction.
    QVERIFY(direction * (rig.commanded() - before) > 0);
    rig.run(4 * second);
    QVERIFY(direction * rig.commanded() > 50'000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.commanded(), direction * std::int64_t{10'000} * rig.core().motion.cycle_count);
}

void TestCamDirection::backwardsWithoutDrift_data()
{
    QTest::addColumn<double>("whole");
    QTest::addColumn<std::uint32_t>("remainder");
    QTest::newRow("progressive") << 1000.0 << 1u;
    QTest::newRow("regressive") << -1001.0 << 2u;
    QTest::newRow("closed") << 0.0 << 0u;
}

// At each update, at about fifty angles of the cycle, the axis has reached the master's position of the
// previous update. The curve itself is computed in floating point, over 10^4 cycles.
void TestCamDirection::backwardsWithoutDrift()
{
    QFETCH(double, whole);
    QFETCH(std::uint32_t, remainder);
    constexpr double swing = 60.0;
    constexpr double turn = 2.0 * std::numbers::pi;
    constexpr std::uint32_t cycleTicks = 163'841; // prime to the update's 16 000
    constexpr std::uint32_t wraps = 10'000;
    const double net = whole + remainder / 3.0;
    CamImage cam = sineCam(net, swing, 200, cycleTicks);
    cam.advance = static_cast<std::int32_t>(whole);
    cam.remainder = remainder;
    cam.divisor = 3;
    cam.masterRampMs = 0;
    cam.masterRate = backwards;
    Rig rig;
    rig.install(cam.registers());
    rig.write(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT, {15, 0}); // the lag itself must not cause a fault
    rig.start();
    const std::uint64_t begunUs = rig.controller().nowUs();
    double worst = 0;
    for (std::uint64_t update = 1; rig.core().motion.cycle_count < wraps; ++update) {
        while (rig.controller().nowUs() < begunUs + update * CTL_CAM_UPDATE_US)
            rig.controller().step();
        const double cycles = -16'000.0 * static_cast<double>(update - 1) / cycleTicks;
        const double exact = net * cycles + swing * std::sin(turn * cycles);
        worst = std::max(worst, std::abs(static_cast<double>(rig.commanded()) - exact));
    }
    QVERIFY2(worst <= 0.5 + 3.0 / 256.0, qPrintable(QString::number(worst)));
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QVERIFY(rig.core().motion.cycle_count > wraps);
    const double exact = -net * rig.core().motion.cycle_count;
    QVERIFY(std::abs(static_cast<double>(rig.commanded()) - exact) <= 0.5 + 1.0 / 256.0);
}

// The new program begins at a boundary in the old direction, then reverses by the ramp.
void TestCamDirection::changeOfSignWhileRunning()
{
    CamImage cam = sineCam(10'000.0, 800.0, 100, 4'000'000);
    Rig rig;
    rig.install(cam.registers());
    rig.start();
    rig.run(2 * second);
    cam.masterRate = backwards;
    const Registers image = cam.registers();
    QCOMPARE(rig.download(image, 2), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);
    QVERIFY(rig.maxJolt(3 * second) <= 2);
    QCOMPARE(rig.core().motion.direction, -1);
    QVERIFY(rig.signedWide(CTL_REG_STATUS_COMMANDED_FREQUENCY) < -9000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.commanded() % 10'000, std::int64_t{0});
}

CAMPANEL_TEST(TestCamDirection)

} // namespace test_cam_direction

#include "test_cam_direction.moc"
