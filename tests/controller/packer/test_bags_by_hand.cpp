// SPDX-License-Identifier: Apache-2.0
// Bags by hand: one bag out of standstill, one cut of the knife alone, the next bag for a person. Each is
// counted once, and film, knife and infeed keep their phase.
#include "rig.h"

#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace test_bags_by_hand {

using namespace campanel::test;
using campanel::controller::MachineOptions;

namespace {

constexpr std::uint32_t cycleTicks = 1'600'000; // 300 a minute
constexpr std::uint64_t cycleUs = 200'000;
constexpr std::int64_t knifePulses = 10'000; // a cycle
constexpr double bagMm = 250.0;

enum class Leader { Clock, Shaft, Wheel };

MachineOptions ledBy(Leader leader, double missing)
{
    MachineOptions options;
    options.products.missing = missing;
    if (leader == Leader::Clock)
        return options;
    options.shaft.counts = 10'000;
    options.shaft.speedMmPerS = bagMm * 1e6 / cycleUs;
    options.shaft.drivesFilm = leader == Leader::Wheel;
    return options;
}

class Line : public Rig {
public:
    explicit Line(Leader leader = Leader::Clock, double missing = 0.0)
        : Rig(ledBy(leader, missing))
    {
        BankImage image = camBank(knifePulses, 1, cycleTicks);
        image.bagLengthUm = 250'000;
        install(image);
        if (leader == Leader::Clock)
            return;
        write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
        write(CTL_REG_MASTER_PLACE,
              {static_cast<std::uint16_t>(leader == Leader::Wheel ? CTL_MASTER_PLACE_WHEEL
                                                                  : CTL_MASTER_PLACE_SHAFT)});
        run(500'000);
    }

    void step()
    {
        controller().step();
        const auto& cut = controller().cut();
        cuts += cut ? 1 : 0;
        through += cut && cut->throughProduct ? 1 : 0;
        if (cut && cut->lengthUm && ctl_packer_bag_class(&core().packer) == CTL_BAG_GOOD)
            largestMm = std::max(largestMm, std::abs(*cut->lengthUm / 1000.0 - bagMm));
        fastest = std::max(fastest, ctl_motion_master_speed(&core().motion));
    }
    void steps(std::uint64_t timeUs)
    {
        for (const std::uint64_t untilUs = controller().nowUs() + timeUs; controller().nowUs() < untilUs;)
            step();
    }
    bool ends(std::uint64_t timeoutUs = 30'000'000)
    {
        const std::uint64_t untilUs = controller().nowUs() + timeoutUs;
        while (core().motion.state != CTL_STATE_READY && controller().nowUs() < untilUs)
            step();
        steps(300'000); // the drives come to rest
        return core().motion.state == CTL_STATE_READY;
    }
    // Runs so many cycles, and stops at the end of one or at once.
    bool runs(int cycles, std::uint16_t stop = CTL_COMMAND_STOP_AT_CYCLE_END, std::uint64_t moreUs = 0)
    {
        start();
        steps(static_cast<std::uint64_t>(cycles) * cycleUs + moreUs);
        command(stop);
        return ends();
    }
    std::uint16_t makesOne()
    {
        cuts = 0;
        fastest = 0;
        const std::uint16_t refusal = command(CTL_COMMAND_JOG_BAG);
        return refusal != CTL_REFUSAL_NONE || ends() ? refusal : std::uint16_t{UINT16_MAX};
    }
    std::uint16_t cutsOnce()
    {
        cuts = 0;
        const std::uint16_t refusal = command(CTL_COMMAND_SINGLE_CUT);
        return refusal != CTL_REFUSAL_NONE || ends() ? refusal : std::uint16_t{UINT16_MAX};
    }
    // Film, knife and infeed stand at the boundary of their cycles, the axis where the table says.
    bool isInPhase()
    {
        const ctl_packer& packer = core().packer;
        return core().motion.in_phase && packer.master == 0 && packer.film.phase == 0 &&
               packer.knife_gate.phase == 0 &&
               (core().motion.commanded - core().motion.origin) % knifePulses == 0;
    }
    std::uint32_t bags() { return core().packer.bags; }
    unsigned flags() { return core().packer.records[CTL_BAG_REGISTERS * (bags() % CTL_BAG_RECORDS) + 3]; }
    bool has(unsigned bit) { return (flags() & 1u << bit) != 0; }
    bool sumHolds()
    {
        const ctl_order& order = core().order;
        return order.counts[CTL_BAG_GOOD] + order.counts[CTL_BAG_REJECTED] + order.counts[CTL_BAG_EMPTY] +
                   (order.on_the_way ? 1u : 0u) ==
               order.cut;
    }
    void order() { command(CTL_COMMAND_ORDER_START, 1, CTL_ORDER_ACTION_NONE, 100'000); }

    int cuts = 0;
    int through = 0;
    double largestMm = 0.0; // deviation of a good bag
    std::uint16_t fastest = 0;
};

// Bags of the run that follows are good and as long as they should be.
bool goesOn(Line& line)
{
    line.largestMm = 0.0;
    const std::uint32_t rejected = line.core().order.counts[CTL_BAG_REJECTED];
    return line.runs(8) && line.largestMm > 0.0 && line.largestMm < 0.3 &&
           line.core().order.counts[CTL_BAG_REJECTED] == rejected;
}

} // namespace

class TestBagsByHand : public QObject {
    Q_OBJECT

private slots:
    void oneBagIsMade_data()
    {
        QTest::addColumn<int>("leader");
        QTest::newRow("clock") << int(Leader::Clock);
        QTest::newRow("encoder on a shaft") << int(Leader::Shaft);
    }

    void oneBagIsMade()
    {
        QFETCH(int, leader);
        Line line{static_cast<Leader>(leader)};
        QVERIFY(line.runs(20));
        line.order();
        for (std::uint32_t i = 1; i <= 5; ++i) {
            const std::uint32_t bags = line.bags();
            QCOMPARE(line.makesOne(), CTL_REFUSAL_NONE);
            QCOMPARE(line.cuts, 1);
            QCOMPARE(line.bags(), bags + 1);
            QVERIFY(line.isInPhase());
            QVERIFY(line.has(CTL_BAG_BIT_START_UP));
            QVERIFY2(line.fastest > 500 && line.fastest <= 2'000, qPrintable(QString::number(line.fastest)));
            QCOMPARE(line.core().order.counts[CTL_BAG_REJECTED], i);
            QCOMPARE(line.core().order.cut, i);
        }
        QVERIFY(goesOn(line));
        QCOMPARE(line.through, 0);
    }

    // From anywhere in a cycle: it ends at the next boundary behind a cut.
    void goesOnFromTheMiddleOfACycle()
    {
        Line line;
        line.order();
        for (const std::uint64_t moreUs : {10'000u, 60'000u, 90'000u, 110'000u, 150'000u, 190'000u}) {
            QVERIFY(line.runs(20, CTL_COMMAND_STOP_NOW, moreUs));
            QCOMPARE(line.makesOne(), CTL_REFUSAL_NONE);
            QCOMPARE(line.cuts, 1);
            QVERIFY(line.isInPhase());
            QVERIFY(line.sumHolds());
        }
        QVERIFY(goesOn(line));
    }

    void theKnifeCutsAlone_data()
    {
        QTest::addColumn<int>("leader");
        QTest::newRow("clock") << int(Leader::Clock);
        QTest::newRow("encoder on a shaft") << int(Leader::Shaft);
        QTest::newRow("encoder on the film") << int(Leader::Wheel);
    }

    // Without products: at the end of a cycle one lies under the knife.
    void theKnifeCutsAlone()
    {
        QFETCH(int, leader);
        Line line(static_cast<Leader>(leader), 1.0);
        line.start();
        line.steps(20 * cycleUs);
        line.order();
        line.command(CTL_COMMAND_STOP_AT_CYCLE_END);
        QVERIFY(line.ends());
        if (leader == int(Leader::Wheel)) {
            QCOMPARE(line.cutsOnce(), CTL_REFUSAL_FILM_MOVES);
            line.controller().machine().shaft().setSpeed(0.0);
            line.steps(4'000'000);
        }
        const std::uint32_t bags = line.bags();
        const std::uint32_t cut = line.core().order.cut;
        const std::int64_t film = line.core().packer.film_actual;
        const std::int64_t knife = line.core().motion.commanded;
        for (std::int64_t i = 1; i <= 3; ++i) { // again at the same place it makes no bag
            QCOMPARE(line.cutsOnce(), CTL_REFUSAL_NONE);
            QCOMPARE(line.cuts, 1);
            QCOMPARE(line.core().motion.commanded, knife + i * knifePulses);
            QVERIFY(std::abs(line.core().packer.film_actual - film) < 256);
            QCOMPARE(line.bags(), bags + 1);
            QVERIFY(line.has(CTL_BAG_BIT_START_UP));
            QCOMPARE(line.core().order.cut, cut + 1);
            QVERIFY(line.sumHolds());
            QVERIFY(line.core().motion.in_phase);
        }
        line.controller().machine().shaft().setSpeed(bagMm * 1e6 / cycleUs);
        const std::uint32_t rejected = line.core().order.counts[CTL_BAG_REJECTED];
        line.start();
        line.largestMm = 0.0;
        line.steps(20 * cycleUs);
        // The bag behind the cut is short, and scrap.
        QVERIFY(line.core().order.counts[CTL_BAG_REJECTED] > rejected);
        QVERIFY2(line.largestMm < 0.3, qPrintable(QString::number(line.largestMm)));
        QVERIFY(line.sumHolds());
    }

    void aProductUnderTheKnifeIsNotCut()
    {
        Line line;
        QVERIFY(line.runs(20));
        QCOMPARE(line.cutsOnce(), CTL_REFUSAL_PRODUCT_AT_KNIFE);
        QCOMPARE(line.cuts, 0);
        QCOMPARE(line.core().motion.state, CTL_STATE_READY);
        // Where no product lies it is, and the knife is back in its place in mid-cycle.
        for (int i = 0; i < 40 && line.cuts == 0; ++i) {
            QVERIFY(line.runs(1, CTL_COMMAND_STOP_NOW, 7'000));
            const std::int64_t before = line.core().motion.commanded;
            const std::uint16_t refusal = line.cutsOnce();
            QVERIFY(refusal == CTL_REFUSAL_NONE || refusal == CTL_REFUSAL_PRODUCT_AT_KNIFE);
            if (refusal == CTL_REFUSAL_NONE)
                QCOMPARE(line.core().motion.commanded, before + knifePulses);
        }
        QCOMPARE(line.cuts, 1);
        QCOMPARE(line.through, 0);
        QVERIFY(line.runs(8));
        QVERIFY(line.isInPhase());
        QCOMPARE(line.through, 0);
    }

    // Stopped in its turn, the knife opens, and the next start makes a reference run.
    void aCutThatIsStoppedLosesThePlaceAlone()
    {
        Line line(Leader::Clock, 1.0);
        line.setParameter(CTL_REG_PARAMETER_JAWS_BEFORE, 2500);
        line.setParameter(CTL_REG_PARAMETER_JAWS_BEHIND, 2500);
        QVERIFY(line.runs(10));
        QCOMPARE(line.command(CTL_COMMAND_SINGLE_CUT), CTL_REFUSAL_NONE);
        while (!line.controller().machine().areJawsClosed())
            line.step();
        line.command(CTL_COMMAND_STOP_AT_CYCLE_END);
        QVERIFY(line.ends());
        QVERIFY(!line.controller().machine().areJawsClosed());
        QCOMPARE(line.makesOne(), CTL_REFUSAL_NOT_IN_PHASE);
        QCOMPARE(line.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        QCOMPARE(line.core().motion.state, CTL_STATE_HOMING);
        line.steps(20 * cycleUs + 3'000'000);
        QCOMPARE(line.core().motion.state, CTL_STATE_RUNNING);
        line.command(CTL_COMMAND_STOP_AT_CYCLE_END);
        QVERIFY(line.ends());
        QVERIFY(line.isInPhase());
    }

    void whatCannotBeIsRefused()
    {
        Line line;
        QCOMPARE(line.makesOne(), CTL_REFUSAL_NOT_IN_PHASE);
        QCOMPARE(line.cutsOnce(), CTL_REFUSAL_NOT_IN_PHASE);
        QCOMPARE(line.command(CTL_COMMAND_TAKE_BAG), CTL_REFUSAL_NOT_RUNNING);
        line.start();
        QCOMPARE(line.command(CTL_COMMAND_JOG_BAG), CTL_REFUSAL_ALREADY_RUNNING);
        QCOMPARE(line.command(CTL_COMMAND_SINGLE_CUT), CTL_REFUSAL_ALREADY_RUNNING);
        QCOMPARE(line.command(CTL_COMMAND_TAKE_BAG), CTL_REFUSAL_NO_REJECT_GATE);
        Line wheel(Leader::Wheel);
        QVERIFY(wheel.runs(30));
        QCOMPARE(wheel.makesOne(), CTL_REFUSAL_FILM_NOT_OURS);
    }

    void theNextBagIsTaken()
    {
        Line line;
        line.setParameter(CTL_REG_PARAMETER_SWITCH1_MODE, CTL_SWITCH_MODE_REJECTED_BAGS);
        line.setParameter(CTL_REG_PARAMETER_SWITCH1_ON_ANGLE, 25'000);
        line.setParameter(CTL_REG_PARAMETER_SWITCH1_OFF_ANGLE, 30'000);
        line.start();
        line.steps(30 * cycleUs);
        line.order();
        line.steps(5 * cycleUs);
        int gates = 0;
        bool wasOn = false;
        const auto watch = [&](int bags) {
            for (const std::uint32_t until = line.bags() + static_cast<std::uint32_t>(bags);
                 line.bags() < until;) {
                line.step();
                const bool isOn = (line.core().io.outputs & 1u) != 0;
                gates += isOn && !wasOn ? 1 : 0;
                wasOn = isOn;
            }
        };
        for (std::uint32_t i = 1; i <= 3; ++i) {
            QCOMPARE(line.command(CTL_COMMAND_TAKE_BAG), CTL_REFUSAL_NONE);
            QCOMPARE(line.command(CTL_COMMAND_TAKE_BAG), CTL_REFUSAL_NONE); // the same bag
            watch(1);
            QVERIFY(line.has(CTL_BAG_BIT_TAKEN));
            QCOMPARE(line.flags() >> 8 & 0x7Fu, 1u);
            watch(4);
            QVERIFY(!line.has(CTL_BAG_BIT_TAKEN));
            QCOMPARE(gates, static_cast<int>(i));
            QCOMPARE(line.core().order.counts[CTL_BAG_REJECTED], i);
            QVERIFY(line.sumHolds());
        }
    }

    void theButtonMakesOneBag()
    {
        Line line;
        QVERIFY(line.runs(10));
        const std::uint32_t bags = line.bags();
        for (std::uint32_t i = 1; i <= 3; ++i) {
            line.controller().machine().setInput(CTL_INPUT_BIT_BAG_BUTTON, true);
            line.steps(100'000);
            line.controller().machine().setInput(CTL_INPUT_BIT_BAG_BUTTON, false);
            QVERIFY(line.ends());
            QCOMPARE(line.bags(), bags + i);
        }
        QCOMPARE(line.status(CTL_REG_SIGNAL_STATUS_REFUSAL), CTL_REFUSAL_NONE);
    }

    // Stops, runs and single cuts between them; each makes one bag, or says why not.
    void randomJogsKeepPhaseAndCount_data()
    {
        QTest::addColumn<int>("leader");
        QTest::newRow("clock") << int(Leader::Clock);
        QTest::newRow("encoder on a shaft") << int(Leader::Shaft);
    }

    void randomJogsKeepPhaseAndCount()
    {
        QFETCH(int, leader);
        bool isSet = false;
        const int cases = qEnvironmentVariableIntValue("CAMPANEL_RANDOM_CASES", &isSet);
        Line line(static_cast<Leader>(leader), 0.3);
        std::mt19937_64 random(static_cast<std::uint64_t>(leader) + 1);
        QVERIFY(line.runs(20));
        line.order();
        int jogs = 0;
        int single = 0;
        for (int i = 0; i < (isSet ? cases : 100); ++i) {
            switch (random() % 4) {
            case 0:
                QVERIFY(line.runs(static_cast<int>(random() % 4),
                                  random() % 2 == 0 ? CTL_COMMAND_STOP_NOW : CTL_COMMAND_STOP_AT_CYCLE_END,
                                  random() % cycleUs));
                break;
            case 1: {
                const std::uint16_t refusal = line.cutsOnce();
                QVERIFY(refusal == CTL_REFUSAL_NONE || refusal == CTL_REFUSAL_PRODUCT_AT_KNIFE);
                QCOMPARE(line.cuts, refusal == CTL_REFUSAL_NONE ? 1 : 0);
                single += line.cuts;
                break;
            }
            default: {
                const std::uint32_t bags = line.bags();
                QCOMPARE(line.makesOne(), CTL_REFUSAL_NONE);
                QCOMPARE(line.cuts, 1);
                QCOMPARE(line.bags(), bags + 1);
                QVERIFY(line.isInPhase());
                ++jogs;
            }
            }
            QVERIFY(line.sumHolds());
            QCOMPARE(line.through, 0);
        }
        QVERIFY(jogs > 10);
        QVERIFY(single > 2);
        QVERIFY2(line.largestMm < 0.5, qPrintable(QString::number(line.largestMm)));
    }
};

CAMPANEL_TEST(TestBagsByHand)

} // namespace test_bags_by_hand

#include "test_bags_by_hand.moc"
