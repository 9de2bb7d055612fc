// SPDX-License-Identifier: Apache-2.0
// Knife by knife, as a technician meets it: a machine with two knives, one of them off its place, cuts bags;
// the field offers what was learned, and taken it is in the controller and the bags are even.
#include "packing_machine.h"

#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_knives {

using namespace campanel;
using panel::PackingFields;

namespace {

constexpr double offMm = 0.1;

controller::MachineOptions machineOf(double knifeOffMm)
{
    controller::MachineOptions options;
    options.knifeOffMm = knifeOffMm;
    return options;
}

struct Machine : test::PackingMachine {
    std::vector<double> deviationsMm;

    Machine(double knifeOffMm, int knives)
        : PackingMachine(machineOf(knifeOffMm), 150, 120, knives)
    {
        QObject::connect(machine.packing(), &panel::PackingLine::bagRecorded, &setup,
                         [this](const modbus::BagRecord& bag) { deviationsMm.push_back(bag.deviationMm); });
    }

    // Returns false when so many bags were not cut in time.
    bool cutBags(std::size_t bags)
    {
        deviationsMm.clear();
        for (int i = 0; i < 2000 && deviationsMm.size() < bags; ++i)
            pass(0.2);
        return deviationsMm.size() >= bags;
    }
    double scatterMm() const
    {
        double squares = 0.0;
        for (const double each : deviationsMm)
            squares += each * each;
        return std::sqrt(squares / static_cast<double>(deviationsMm.size()));
    }
};

} // namespace

class TestKnives : public QObject {
    Q_OBJECT

private slots:
    void offersThePlaceOfAKnife()
    {
        Machine machine(offMm, 2);
        const int row = machine.row(QStringLiteral("Knife 2 cuts behind its place by"));
        QVERIFY(row >= 0);
        machine.machine.start();
        QVERIFY(machine.cutBags(20));
        QVERIFY(machine.at(row, PackingFields::SuggestionRole).isEmpty());
        QVERIFY(machine.cutBags(200));
        const double before = machine.scatterMm();
        QVERIFY2(before > 0.09, qPrintable(QString::number(before)));
        const QString offered = machine.at(row, PackingFields::SuggestionRole);
        QVERIFY2(std::abs(offered.toDouble() - offMm) < 0.02, qPrintable(offered));
        QCOMPARE(machine.parameter(CTL_REG_PARAMETER_KNIFE_2), std::uint16_t{0}); // nobody has taken it

        machine.fields().takeSuggestion(row);
        machine.pass(1);
        QCOMPARE(machine.parameter(CTL_REG_PARAMETER_KNIFE_2),
                 static_cast<std::uint16_t>(std::lround(offered.toDouble() * 1000.0)));
        QVERIFY(machine.cutBags(4));
        QVERIFY(machine.cutBags(200));
        QVERIFY2(machine.scatterMm() < 0.05, qPrintable(QString::number(machine.scatterMm())));
        QVERIFY(machine.at(row, PackingFields::SuggestionRole).isEmpty());
    }

    void oneKnifeHasNoPlace()
    {
        Machine machine(offMm, 1);
        QCOMPARE(machine.row(QStringLiteral("Knife 2 cuts behind its place by")), -1);
        QCOMPARE(PackingFields::words(QStringLiteral("parameter.knife_3")),
                 QStringLiteral("Knife 3 cuts behind its place by"));
        QCOMPARE(PackingFields::words(QStringLiteral("parameter.knife_step")),
                 QStringLiteral("Knife: max. speed step at a change"));
    }
};

CAMPANEL_TEST(TestKnives)

} // namespace test_knives

#include "test_knives.moc"
