// SPDX-License-Identifier: Apache-2.0
// A machine whose true pulses, film feed and directions are not those that the controller was told, and what
// is measured of them. The core reads nothing of the simulated machine but its pins and encoders.
#include "rig.h"

#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <cstdio>

namespace test_commissioning {

using namespace campanel::test;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 300 a minute
constexpr std::int64_t knifePulses = 10'000;    // of a cycle and of a turn, by the program
constexpr double bagMm = 250.0;

struct Run {
    int bags = 0;
    double meanMm = 0.0;

    [[nodiscard]] double offPercent() const { return 100.0 * (meanMm / bagMm - 1.0); }
};

class Bench : public Rig {
public:
    explicit Bench(const MachineOptions& options)
        : Rig(options)
    {
        BankImage image = camBank(knifePulses, 1, cycleTicks);
        image.bagLengthUm = 250'000;
        install(image);
        write(CTL_REG_PARAMETER_MARK_TRACKING, {0});
        write(CTL_REG_PARAMETER_ANTI_CUT, {0});
    }

    // Lets the machine cut for this time by the clock, and measures its bags with a ruler.
    Run cut(std::uint64_t timeUs = 20'000'000)
    {
        Run run;
        double sumMm = 0.0;
        start();
        for (const std::uint64_t untilUs = controller().nowUs() + timeUs; controller().nowUs() < untilUs;) {
            controller().step();
            if (const auto& cut = controller().cut(); cut && cut->lengthUm) {
                ++run.bags;
                sumMm += *cut->lengthUm / 1000.0;
            }
        }
        run.meanMm = run.bags > 0 ? sumMm / run.bags : 0.0;
        command(CTL_COMMAND_STOP_NOW);
        runUntilState(CTL_STATE_READY);
        return run;
    }
};

MachineOptions plain()
{
    MachineOptions options;
    options.film.stretch = 0.0;
    options.products.missing = 1.0;
    return options;
}

} // namespace

class TestCommissioning : public QObject {
    Q_OBJECT

private slots:
    void wrongDataMakeWrongBags_data()
    {
        QTest::addColumn<double>("feedMm");
        QTest::addColumn<double>("filmPulses");
        QTest::addColumn<double>("knifePulses");
        QTest::addColumn<double>("reversed");
        QTest::addColumn<double>("offPercent");
        QTest::newRow("as it was told") << 150.0 << 10'000.0 << 0.0 << 0.0 << 0.0;
        QTest::newRow("film per turn") << 147.0 << 10'000.0 << 0.0 << 0.0 << -2.0;
        QTest::newRow("pulses per turn of the film") << 150.0 << 10'100.0 << 0.0 << 0.0 << -0.99;
        QTest::newRow("pulses per turn of the knife") << 150.0 << 10'000.0 << 10'100.0 << 0.0 << 1.0;
        QTest::newRow("film backward") << 150.0 << 10'000.0 << 0.0 << 2.0 << -100.0;
    }

    void wrongDataMakeWrongBags()
    {
        QFETCH(double, feedMm);
        QFETCH(double, filmPulses);
        QFETCH(double, knifePulses);
        QFETCH(double, reversed);
        QFETCH(double, offPercent);
        MachineOptions options = plain();
        options.filmFeedMm = feedMm;
        options.filmPulses = filmPulses;
        options.knifePulses = knifePulses;
        options.reversed = reversed;
        const Run run = Bench(options).cut();
        std::printf("%-30s %d bags, %.2f mm, %+.2f %%\n", QTest::currentDataTag(), run.bags, run.meanMm,
                    run.offPercent());
        QVERIFY(run.bags > 50);
        QVERIFY(std::abs(run.offPercent() - offPercent) < 0.05);
    }

    void knifeThatTurnsBackwardMakesNoBag()
    {
        MachineOptions options = plain();
        options.reversed = 1.0;
        QCOMPARE(Bench(options).cut().bags, 0);
    }
};

CAMPANEL_TEST(TestCommissioning)

} // namespace test_commissioning

#include "test_commissioning.moc"
