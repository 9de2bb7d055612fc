// SPDX-License-Identifier: Apache-2.0
// The dead times of the product eye as a technician measures them: one part comes to the same place of the
// infeed, the machine runs at two speeds, the fields offer what was measured, and taken it is in the
// controller. What is true is the simulated eye's.
#include "packing_machine.h"

#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_eye_sensor {

using namespace campanel;
using panel::PackingFields;

namespace {

constexpr double endLaterMs = 0.7;

controller::MachineOptions lateBy(double delayMs, double scatterMm)
{
    controller::MachineOptions options;
    options.sensors.delayMs = delayMs;
    options.sensors.offLaterMs = endLaterMs;
    options.products.scatterMm = scatterMm;
    options.products.lengthScatterMm = scatterMm / 4;
    return options;
}

struct Machine : test::PackingMachine {
    Machine(double delayMs, double scatterMm)
        : PackingMachine(lateBy(delayMs, scatterMm), 300, slow)
    {
    }

    static constexpr double slow = 60;
    static constexpr double fast = 240;

    bool runAt(double rate, double seconds)
    {
        editor.rate()->set(rate);
        editor.download();
        pass(3);
        machine.start();
        pass(seconds);
        const bool runs = machine.state() == panel::Controller::State::Running;
        machine.stop();
        pass(5);
        return runs;
    }
    int begin() { return row(QStringLiteral("Product eye: dead time, product comes")); }
    int end() { return row(QStringLiteral("Product eye: dead time, product ends")); }
    QString offered(int row) { return at(row, PackingFields::SuggestionRole); }
    QString note(int row) { return at(row, PackingFields::NoteRole); }
};

} // namespace

class TestEyeSensor : public QObject {
    Q_OBJECT

private slots:
    void offersWhatItMeasured_data()
    {
        QTest::addColumn<double>("delayMs");
        QTest::newRow("1 ms") << 1.0;
        QTest::newRow("2.5 ms") << 2.5;
    }
    void offersWhatItMeasured()
    {
        QFETCH(double, delayMs);
        Machine machine(delayMs, 0.0);
        QVERIFY(machine.begin() >= 0 && machine.end() >= 0);
        QVERIFY2(machine.note(machine.begin()).contains(QStringLiteral("to measure this, fix one part")),
                 qPrintable(machine.note(machine.begin())));
        QVERIFY(machine.runAt(Machine::slow, 45));
        QVERIFY(machine.offered(machine.begin()).isEmpty()); // one speed says nothing
        QVERIFY(machine.runAt(Machine::fast, 20));
        for (const auto& [row, ms] :
             {std::pair(machine.begin(), delayMs), std::pair(machine.end(), delayMs + endLaterMs)}) {
            const QString offered = machine.offered(row);
            QVERIFY2(std::abs(offered.toDouble() - ms) < 0.15, qPrintable(offered + machine.note(row)));
            QVERIFY2(machine.note(row).contains(QStringLiteral("measured: ")), qPrintable(machine.note(row)));
        }
        QCOMPARE(machine.parameter(CTL_REG_PARAMETER_EYE_DEAD_TIME), std::uint16_t{0}); // nobody has taken it

        const double takenMs = machine.offered(machine.begin()).toDouble();
        machine.fields().takeSuggestion(machine.begin());
        machine.pass(1);
        QCOMPARE(machine.parameter(CTL_REG_PARAMETER_EYE_DEAD_TIME),
                 static_cast<std::uint16_t>(std::lround(takenMs * 1000.0)));
        QCOMPARE(machine.parameter(CTL_REG_PARAMETER_EYE_END_DEAD_TIME), std::uint16_t{0});
        // The controller takes a dead time off from now on; it is added again.
        QVERIFY(machine.runAt(Machine::slow, 45));
        QVERIFY(machine.runAt(Machine::fast, 20));
        QVERIFY2(machine.offered(machine.begin()).isEmpty(), qPrintable(machine.note(machine.begin())));
        QVERIFY(!machine.offered(machine.end()).isEmpty());
    }

    // Usual products: the note says why nothing is offered.
    void scatteredProductsAreNotOffered()
    {
        Machine machine(1.0, 2.0);
        QVERIFY(machine.runAt(Machine::slow, 70));
        QVERIFY(machine.runAt(Machine::fast, 30));
        for (const int row : {machine.begin(), machine.end()}) {
            QVERIFY2(machine.offered(row).isEmpty(), qPrintable(machine.offered(row)));
            QVERIFY2(machine.note(row).contains(QStringLiteral("not offered: margin ±0.")) &&
                         machine.note(row).contains(QStringLiteral("at most 0.2 ms. Fix one part")),
                     qPrintable(machine.note(row)));
        }
    }
};

CAMPANEL_TEST(TestEyeSensor)

} // namespace test_eye_sensor

#include "test_eye_sensor.moc"
