// SPDX-License-Identifier: Apache-2.0
// The truth of the soak: what it believes of a controller whose clock keeps up, and of one whose computer
// stops it.
#include "tests/soak/truth.h"
#include "tests/support/test_program.h"

namespace test_truth {

using namespace campanel;
using namespace campanel::soak;
using std::chrono::milliseconds;

// A controller, and the time of this computer.
struct Bench {
    explicit Bench(ControllerTime time)
        : truth(time, powerUp)
    {
    }
    // Lets both clocks pass; the controller's falls behind by `standsMs`.
    void pass(int ms, int standsMs = 0)
    {
        now += milliseconds{ms};
        age += milliseconds{ms - standsMs};
    }
    // Returns the sentence about a status that was taken 2 ms after its question and 2 ms before its arrival.
    std::string status()
    {
        block.uptimeS = static_cast<std::uint32_t>(age.count() / 1000);
        block.sampleTimeMs = static_cast<std::uint16_t>(age.count());
        ++block.linkRequests;
        return truth.checkStatus(block, now - milliseconds{2}, now + milliseconds{2});
    }
    void activate(std::uint32_t crc)
    {
        block.activeCrc = crc;
        ++block.generation;
        block.state = modbus::State::Ready;
        block.programKind = modbus::ProgramKind::PositionMove;
    }

    Clock::time_point powerUp = Clock::now();
    Truth truth;
    milliseconds age{5000};
    Clock::time_point now = powerUp + age;
    modbus::StatusBlock block = [] {
        modbus::StatusBlock status;
        status.state = modbus::State::Idle;
        return status;
    }();
};

class TestTruth : public QObject {
    Q_OBJECT

private slots:
    void aSteadyClockTellsOfOldAnswers()
    {
        Bench bench(ControllerTime::Steady);
        QCOMPARE(bench.status(), std::string());
        bench.pass(1000);
        QCOMPARE(bench.status(), std::string());
        bench.pass(1000, 400);
        QVERIFY(bench.status().starts_with("taken "));
    }

    // A host that stops the controller for a while also stops its clock, for good.
    void aClockMayStand()
    {
        Bench bench(ControllerTime::MayStand);
        QCOMPARE(bench.status(), std::string());
        bench.pass(12'000, 11'000);
        QCOMPARE(bench.status(), std::string());
        bench.pass(10);
        QCOMPARE(bench.status(), std::string());
    }

    // While it stood, a program became active: the next status says so and the table read back is the right
    // one.
    void aProgramBecomesActiveWhileTheClockStands()
    {
        Bench bench(ControllerTime::MayStand);
        QCOMPARE(bench.status(), std::string());
        const std::uint32_t crc = bench.truth.imageCrcs().front();
        bench.truth.applying(crc);
        bench.pass(3000, 2500);
        bench.activate(crc);
        QCOMPARE(bench.status(), std::string());
        QCOMPARE(bench.truth.activeCrc(), crc);
        QCOMPARE(bench.truth.checkBank(bench.truth.image(crc)), std::string());
    }

    void aClockThatMayStandNeverRunsAheadOrBack()
    {
        Bench bench(ControllerTime::MayStand);
        QCOMPARE(bench.status(), std::string());
        bench.age += milliseconds{60'000};
        QVERIFY(bench.status().starts_with("counts "));
        bench.age -= milliseconds{60'100};
        QVERIFY(bench.status().starts_with("goes back "));
    }

    void anAnswerCountedBeforeIsWrong()
    {
        Bench bench(ControllerTime::MayStand);
        QCOMPARE(bench.status(), std::string());
        bench.pass(10);
        bench.block.linkRequests -= 1;
        QVERIFY(bench.status().starts_with("answers counted"));
    }

    // A move takes as long as the controller's own clock says.
    void aMoveEndsByTheControllersClock_data()
    {
        QTest::addColumn<int>("ownMs");
        QTest::addColumn<bool>("mayMove");
        QTest::newRow("it stood") << 500 << true;
        QTest::newRow("it ran") << 4900 << false;
    }
    void aMoveEndsByTheControllersClock()
    {
        QFETCH(const int, ownMs);
        QFETCH(const bool, mayMove);
        Bench bench(ControllerTime::MayStand);
        const std::uint32_t crc = bench.truth.imageCrcs().front();
        bench.truth.applying(crc);
        bench.activate(crc);
        QCOMPARE(bench.status(), std::string());
        bench.truth.commandCarriedOut(true);
        bench.block.state = modbus::State::Running;
        bench.pass(10);
        QCOMPARE(bench.status(), std::string());
        bench.pass(5000, 5000 - ownMs);
        QCOMPARE(bench.status().empty(), mayMove);
    }
};

CAMPANEL_TEST(TestTruth)

} // namespace test_truth

#include "test_truth.moc"
